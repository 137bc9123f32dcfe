// What can be taken hold of: corners of polygons, points of clouds, the end of a segment.

#include "viz/player/dragging.h"
#include <imgui_internal.h>
#include <Eigen/Geometry>
#include <algorithm>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/player/reader_state.h"
#include "viz/window/edge_arrows.h"

namespace dragging_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Handle& handle(const Player& player, const std::string& name) {
  for (const Handle& h : player.scene().handles)
    if (h.parameter == name) return h;
  throw std::runtime_error("no handle " + name);
}

}  // namespace

TEST_CASE("every corner and every point that a lesson draws can be dragged with the pointer", "[window]") {
  const auto [lesson, preset, count] =
      GENERATE(table<const char*, const char*, int>({{"crossings", "inside", 5},
                                                     {"crossings", "hole", 8},
                                                     {"concave-polygon", "slabs", 9},
                                                     {"concave-polygon", "hierarchy", 9},
                                                     {"convex-hull", "scattered", 8}}));
  INFO(lesson << " " << preset);
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at(lesson, preset));
  for (int i = 0; i < count; ++i) {
    const std::string name = "v" + std::to_string(i);
    INFO(name);
    const Rect before = window.rect("handle " + name);
    CHECK((before.width() >= 24 && before.height() >= 24));
    CHECK_FALSE(window.player().parameters().contains(name));
    window.drag("handle " + name, 3, -2);
    CHECK(window.player().parameters().contains(name));
    window.frames(60);
    CHECK(window.player().undo());
    window.frames(60);
    CHECK_FALSE(window.player().parameters().contains(name));
  }
  CHECK_FALSE(window.has("handle v" + std::to_string(count)));
}

TEST_CASE("the words on a handle stand at it, at the picture's edge while it is dragged, and nowhere once it is let go",
          "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  const auto at_pointer = [] {
    const ImGuiWindow* const words = ImGui::FindWindowByName("##Tooltip_00");
    return words && words->Active;
  };
  const bool to_the_corner = GENERATE(false, true);
  const Rect grip = window.rect("handle origin"), scene = window.rect("scene");
  window.move(grip.middle_x(), grip.middle_y());
  window.frames(2);
  CHECK(at_pointer());
  window.button(true);
  const float x = to_the_corner ? scene.right - 40 : grip.middle_x() + 30;
  const float y = to_the_corner ? scene.top + 40 : grip.middle_y() + 20;
  window.move((grip.middle_x() + x) / 2, (grip.middle_y() + y) / 2);
  window.move(x, y);
  window.frames(2);
  CHECK_FALSE(at_pointer());
  REQUIRE(window.has("words on the handle"));
  const Rect words = window.rect("words on the handle"), now = window.rect("handle origin");
  CHECK((words.left >= scene.left && words.right <= scene.right));
  CHECK((words.top >= scene.top && words.bottom <= scene.bottom));
  CHECK_FALSE(words.contains(now.middle_x(), now.middle_y()));
  CHECK_FALSE(words.contains(x, y));
  window.button(false);
  window.frames(2);
  CHECK_FALSE(window.has("words on the handle"));
  CHECK_FALSE(at_pointer());
  window.move(x + 1, y);
  window.frames(2);
  const bool follows = window.rect("handle origin").contains(x + 1, y);
  if (!to_the_corner) REQUIRE(follows);
  CHECK(at_pointer() == follows);
}

TEST_CASE("every box of collision and of a hierarchy is dragged with the pointer", "[window]") {
  const auto [lesson, preset, count] = GENERATE(table<const char*, const char*, int>(
      {{"collision", "brute-force", 6}, {"hierarchy", "build", 12}, {"hierarchy", "pairs", 12}}));
  WindowDriver boxes(lessons::all_lessons(), 1280, 800, place_at(lesson, preset));
  for (int k = 1; k < count; ++k) {
    const std::string name = "p" + std::to_string(k);
    INFO(lesson << " " << name);
    CHECK_FALSE(boxes.player().parameters().contains(name));
    const Vec3 before = handle(boxes.player(), name).at;
    boxes.drag("handle " + name, 9, -6);
    REQUIRE(boxes.player().parameters().contains(name));
    CHECK((handle(boxes.player(), name).at - before).norm() > 0.01);
    boxes.frames(60);
  }
}

TEST_CASE("each side of clipping's box is dragged, and the whole box", "[window]") {
  WindowDriver box(lessons::all_lessons(), 1280, 800, place_at("clipping", "both-ends-cut"));
  const auto corner = [&](const char* name) { return std::get<Vec3>(box.player().parameters().at(name)); };
  box.drag("handle b_min.x", 20, 0);
  CHECK((corner("b_min").x() > -2 && corner("b_min").y() == -1.25));
  CHECK_FALSE(box.player().parameters().contains("b_max"));
  const double left = corner("b_min").x();
  box.frames(60);
  box.drag("handle box", 12, -9);
  CHECK((corner("b_max") - corner("b_min")).isApprox(Vec3(2 - left, 2.5, 0), 1e-12));
  box.frames(60);
  box.drag("handle b_max.y", 0, 700);  // through the side across
  CHECK(corner("b_max").y() > corner("b_min").y());
}

TEST_CASE("who drops a handle out of sight is told how to see it again", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("crossings", "inside"));
  window.drag("handle v0", 12, 8);
  CHECK(window.ui.message().empty());
  const Rect scene = window.rect("scene"), corner = window.rect("handle v0");
  window.drag("handle v0", scene.right + 60 - corner.middle_x(), 0);
  CHECK(window.ui.message() == "It is out of sight: F shows all of the scene");
  window.type("f");
  window.frames(60);
  const Rect again = window.rect("handle v0");
  CHECK((again.left >= scene.left && again.right <= scene.right));
}

TEST_CASE("an arrow at the edge points to a handle that is out of view, and a click on it brings it back", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("crossings", "inside"));
  CHECK_FALSE(window.has("edge arrow 1"));
  const Rect scene = window.rect("scene"), corner = window.rect("handle v0");
  window.drag("handle v0", scene.right + 60 - corner.middle_x(), 0);
  REQUIRE(window.has("edge arrow 1"));
  CHECK_FALSE(window.has("edge arrow 2"));
  const Rect arrow = window.rect("edge arrow 1");
  CHECK((arrow.middle_x() > scene.right - 60 && arrow.right <= scene.right));
  CHECK(arrow.middle_y() == Approx(corner.middle_y()).margin(80));
  window.click("edge arrow 1");
  window.frames(60);
  const Rect again = window.rect("handle v0");
  CHECK((again.middle_x() > scene.left && again.middle_x() < scene.right));
  CHECK_FALSE(window.has("edge arrow 1"));
}

TEST_CASE("a name that is lit has an arrow, too, if its line is out of view", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  const std::vector<Step>& steps = window.player().walk().steps;
  const auto drawn = std::ranges::find_if(steps, [](const Step& step) {
    return std::ranges::any_of(step.scene.items, [](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      return label && label->text == "*s*" && label->until;
    });
  });
  REQUIRE(drawn != steps.end());
  window.player().go_to(static_cast<int>(drawn - steps.begin()));
  window.player().move_camera("", [](CameraRig& camera) {
    Camera away = camera.goal();
    away.target += Vec3(0, 40 * away.half_height, 0);
    camera.jump(away);
  });
  window.frames(2);
  CHECK(window.has("edge arrow 1"));
  CHECK_FALSE(window.has("lit edge arrow 1"));
  const Rect row = window.rect("value s");
  window.move(row.middle_x(), row.middle_y());
  window.frames(3);
  CHECK(window.has("lit edge arrow 1"));  // one for all, which lie the same way
}

TEST_CASE("arrows stand on the rim towards what they point to, and near ones are one", "[window]") {
  const Rect room{0, 0, 1000, 600};
  const std::vector<EdgeArrow> arrows = edge_arrows(
      {{{2500, 300}, "*a*"}, {{2500, 310}, "*b*"}, {{500, -900}, "*c*"}, {{500, -900}, "**c**", true}}, room);
  REQUIRE(arrows.size() == 2);
  CHECK(arrows[0].at.x() == Approx(1000));
  CHECK(arrows[0].at.y() == Approx(300));
  CHECK(arrows[0].way.x() == Approx(1));
  CHECK(arrows[0].words() == "*a*, *b*");
  CHECK(arrows[1].at.y() == Approx(0).margin(1e-9));
  CHECK(arrows[1].words() == "*c*");
  CHECK(arrows[1].lit);
  CHECK(EdgeArrow{.names = {"*a*", "*b*", "*c*", "*d*"}}.words() == "*a* and 3 more");
  CHECK(edge_arrows({{{2500, 300}, "*a*"}}, {0, 0, 0, 0}).empty());
}

TEST_CASE("L and a pin in the corner keep the reader's view for all presets", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  CHECK_FALSE(window.has("pin"));
  window.key(key::right, false, true);
  const Camera own = window.player().camera().goal();
  window.frames(2);
  window.click("pin");
  CHECK(window.player().camera().pinned());
  window.type("2");
  CHECK(window.player().camera().goal() == own);
  window.type("l");
  CHECK_FALSE(window.player().camera().pinned());
  window.type("3");
  CHECK_FALSE(window.player().camera().moved());
  window.frames(2);
  CHECK_FALSE(window.has("pin"));
}

TEST_CASE("a corner of a polygon in space stays in its plane under the pointer and under the keys", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-polygon", "hit"));
  const auto& parameters = [&]() -> const Parameters& { return window.player().parameters(); };
  const Vec3 across(1, 0, 0.5), up(0.125, 1, -0.0625);
  for (const std::string name : {"p0", "p1", "p2", "p3", "p4"}) {
    INFO(name);
    const Rect before = window.rect("handle " + name);
    CHECK((before.width() >= 24 && before.height() >= 24));
    window.drag("handle " + name, 11, -7);
    REQUIRE(parameters().contains(name));
    window.frames(60);
    const Rect after = window.rect("handle " + name);
    CHECK(after.middle_x() == Approx(before.middle_x() + 11).margin(1.5));  // the grid is a pixel wide
    CHECK(after.middle_y() == Approx(before.middle_y() - 7).margin(1.5));
    const Handle& corner = handle(window.player(), name);
    CHECK(corner.at.dot(across.cross(up)) == 0);
    CHECK(window.player().undo());
    window.frames(60);
    CHECK_FALSE(parameters().contains(name));
  }
  const std::size_t steps = window.player().walk().steps.size();
  window.drag("handle p3", 0, -40);  // the notch is gone
  CHECK(window.player().walk().steps.size() == steps);
  CHECK_FALSE(parameters().at("p3") == Setting(Vec3(0, 0, 0)));
}

TEST_CASE("an arrow key moves a handle along the view, and what it does not mean stays to the last bit", "[player]") {
  Player player(lessons::all_lessons(), place_at("sphere-sphere", "touching"));
  const View view(Camera{.azimuth = 0.6, .elevation = 0.4}, 800, 600);
  const Handle ball = handle(player, "b");
  const Vec3 along_x = {1, 0, 0};
  const Vec2 way = (view.project(ball.at + along_x).at - view.project(ball.at).at).normalized();
  CHECK(nudge(player, View(Camera{.azimuth = 0, .elevation = 0}, 800, 600), ball, {1, 0}, false).refused.empty());
  const Vec3 there = handle(player, "b").at;
  CHECK(there.x() > ball.at.x());
  CHECK(there.y() == ball.at.y());
  CHECK(there.z() == ball.at.z());
  CHECK(nudge(player, view, handle(player, "b"), way, false).refused.empty());
  CHECK(handle(player, "b").at != there);
}

TEST_CASE("a handle on the image plane stays on it, under the pointer", "[player]") {
  const auto [lesson, preset, name] = GENERATE(
      table<const char*, const char*, const char*>({{"picking", "front", "pointer"}, {"ray-tracing", "lit", "pixel"}}));
  INFO(lesson);
  Player player(lessons::all_lessons(), place_at(lesson, preset));
  const View view(player.camera().now(), 800, 600);
  const Handle before = handle(player, name);
  const Vec2 pixel = view.project(before.at).at + Vec2(7, -5);
  CHECK(drag_to(player, before, before.at, brought(view, before, pixel), false).refused.empty());
  const Handle& after = handle(player, name);
  CHECK(after.at != before.at);
  CHECK(std::get<Vec3>(player.parameters().at(name)).x() == before.at.x());
  CHECK((view.project(after.at).at - pixel).norm() < 1e-6);
}

TEST_CASE("a handle on a line stays on it, next to the pointer, unless the line points to the viewer", "[player]") {
  const View view(Camera{.azimuth = 0.6, .elevation = 0.4, .perspective = true}, 800, 600);
  Handle face = {.parameter = "A.lo",
                 .kind = Handle::Kind::on_line,
                 .at = Vec3(0.5, 0.25, 0),
                 .direction = Vec3(1, 2, 0.5),
                 .name = "A.lo.x"};
  const Vec3 there = face.at + 0.375 * face.direction;
  CHECK(brought(view, face, view.project(there).at).isApprox(there, 1e-9));
  const Vec3 beside = brought(view, face, view.project(there).at + Vec2(9, 3));
  CHECK((beside - face.at).cross(face.direction).norm() < 1e-9);
  face.direction = view.towards_eye(face.at);
  const Vec3 facing = brought(view, face, view.project(face.at).at + Vec2(9, 3));
  CHECK((facing - face.at).norm() < 0.2);
  CHECK(facing == view.on_facing_plane(view.project(face.at).at + Vec2(9, 3), face.at));

  Scene scene;
  Handle other = face;
  other.name = "A.lo.y";
  scene.handles = {other, face};
  REQUIRE(same_handle(scene, face));
  CHECK(same_handle(scene, face)->name == "A.lo.x");
  face.name = "A.lo.z";
  CHECK_FALSE(same_handle(scene, face));
}

TEST_CASE("Snap stands on the short number where a border is one", "[player]") {
  Player player(lessons::all_lessons(), place_at("rays", "segment"));
  const auto shown = [&] {
    return std::ranges::any_of(player.scene().handles, [](const Handle& h) { return h.parameter == "wall"; });
  };
  for (int step = 0; !shown(); ++step) REQUIRE((player.go_to(step), step < 10));
  const Handle wall = handle(player, "wall");
  for (const double to : {0.4, 0.6}) {
    drag_to(player, wall, wall.at, {to, wall.at.y(), 0}, true);
    CHECK(std::get<double>(player.parameters().at("wall")) == 0.5);  // where the segment ends
  }
}

TEST_CASE("corners that would enclose no area are refused", "[player]") {
  const auto lessons = lessons::all_lessons();
  Player player(lessons, place_at("ray-polygon", "hit"));
  for (const auto& [name, to] :
       {std::pair{"p1", Vec3(0, 1, 0)}, {"p2", Vec3(0, 2, 0)}, {"p3", Vec3(0, 3, 0)}, {"p4", Vec3(0, 4, 0)}})
    player.edit(name, to);
  CHECK_THROWS_WITH(player.edit("p0", Vec3(0, 5, 0)), isect::test::Contains("enclose an area"));
}

TEST_CASE("a moved corner is kept by the other rule and in a copied state, and forgotten with its polygon",
          "[player]") {
  const auto lessons = lessons::all_lessons();
  Player player(lessons, place_at("crossings", "inside"));
  player.drag_handle(handle(player, "v2"), {1.5, 0.25, 0});
  const Setting moved = Vec3(1.5, 0.25, 0);
  CHECK(player.parameters().at("v2") == moved);
  CHECK(handle(player, "v2").at == Vec3(1.5, 0.25, 0));
  player.load_method("closed");
  CHECK(player.parameters().at("v2") == moved);
  CHECK(reader_state_from_json(to_json(player.reader_state()), lessons).parameters->at("v2") == moved);
  player.edit("polygon", std::string("outside"));
  CHECK_FALSE(player.parameters().contains("v2"));
}

TEST_CASE("a corner does not go where a method's polygon would no longer be simple, and that is said", "[player]") {
  Player player(lessons::all_lessons(), place_at("concave-polygon", "slabs"));
  const Parameters before = player.parameters();
  const Condition* forbids = player.drag_handle(handle(player, "v2"), {-2, 1.25, 0});  // across the edge v7 v8
  REQUIRE(forbids);
  CHECK(forbids->allowed.find("no two edges cross") != std::string::npos);
  CHECK(player.parameters() == before);
  CHECK(player.drag_handle(handle(player, "v2"), {5, 0, 0}));  // beyond the frame
  CHECK_FALSE(player.drag_handle(handle(player, "v2"), {-0.75, 0, 0}));
  CHECK(player.parameters().contains("v2"));
}

TEST_CASE("where a moved corner makes edges cross, Jordan's theorem is no longer cited", "[player]") {
  Player player(lessons::all_lessons(), place_at("crossings", "inside"));
  const auto cites = [&] { return player.walk().steps[0].caption.find("(Jordan curve theorem)") != std::string::npos; };
  CHECK(cites());
  player.drag_handle(handle(player, "v0"), {2, 2.25, 0});
  CHECK_FALSE(cites());
  CHECK(player.walk().alt.find("that meets itself") != std::string::npos);
}

TEST_CASE("a segment's end is dragged along it, in lengths of the direction as given", "[player]") {
  const std::string preset = GENERATE("segment-before", "segment-before-quadratic", "segment-inside-half-b");
  Player player(lessons::all_lessons(), place_at("ray-sphere", preset));
  const Vec3 o = handle(player, "origin").at, d = std::get<Vec3>(player.parameters().at("direction"));
  player.drag_handle(handle(player, "t_max"), o + 1.5 * d);
  CHECK(std::get<double>(player.parameters().at("t_max")) == Approx(1.5).epsilon(1e-12));
  CHECK((handle(player, "t_max").at - (o + 1.5 * d)).norm() < 1e-9);
  player.edit("extent", std::string("ray"));
  CHECK_THROWS(handle(player, "t_max"));
}

}  // namespace dragging_test
