// What hands do in the window, and what comes of it.

#include "viz/window/window_ui.h"

#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"

namespace window_test {
using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

}  // namespace

TEST_CASE("the keys step, jump and stop at questions", "[window]") {
  WindowDriver window(both);
  window.key(key::right);
  CHECK(window.player().index() == 1);
  window.key(key::right);
  CHECK(window.player().index() == 1);
  REQUIRE(window.player().quiz().asked());
  window.key(key::right);
  CHECK(window.player().index() == 2);
  window.key(key::left);
  CHECK(window.player().index() == 1);
  window.key(key::end);
  CHECK(window.player().at_end());
  window.key(key::home);
  CHECK(window.player().index() == 0);
  CHECK(window.ui.title() == "Point and disc, inside, step 1 of 5 – isect");
}

TEST_CASE("presets are loaded by chip and by number, and the method by its menu", "[window]") {
  WindowDriver window(both);
  window.click("preset 2");
  CHECK(window.player().played().preset_id() == "squared-outside");
  window.type("3");
  CHECK(window.player().played().preset_id() == "squared-on");
  window.type("9");  // there is no ninth
  CHECK(window.player().played().preset_id() == "squared-on");
  window.click("method");
  window.click("method distance");
  CHECK(window.player().played().preset_id() == "distance-on");
}

TEST_CASE("a dragged handle changes its parameter and the verdict at once", "[window]") {
  WindowDriver window(both);
  window.key(key::end);
  REQUIRE(window.player().step().verdict.kind == Verdict::Kind::yes);
  const auto center = [&] { return std::get<Vec3>(window.player().parameters().at("c")); };

  const Rect grip = window.rect("handle c");
  window.move(grip.middle_x(), grip.middle_y());
  window.button(true);
  window.move(grip.middle_x() + 120, grip.middle_y() + 150);
  window.move(grip.middle_x() + 240, grip.middle_y() + 250);
  CHECK(window.player().step().verdict.kind == Verdict::Kind::no);  // while it is still held
  window.button(false);
  CHECK(center().norm() > 1);
  CHECK(window.player().played().preset_id().empty());
  CHECK(window.has("changed"));
  const Rect now = window.rect("handle c");
  CHECK(now.middle_x() == Approx(grip.middle_x() + 240).margin(0.5));
  CHECK(now.middle_y() == Approx(grip.middle_y() + 250).margin(0.5));

  window.key(key::z, true);
  CHECK(center() == Vec3(0, 0, 0));
  CHECK(window.player().played().preset_id() == "squared-inside");
}

TEST_CASE("a radius handle changes a number", "[window]") {
  WindowDriver window(both);
  window.drag("handle r", 0, -60);
  CHECK(std::get<double>(window.player().parameters().at("r")) > 1.6);
}

TEST_CASE("what has very much to draw is sketched while it is dragged, and drawn once it is let go", "[window]") {
  Mesh mesh;
  for (int i = 0; i < 120; ++i)
    for (int k = 0; k < 100; ++k) {
      const auto corner = [&](int u, int v) { return Vec3(0.04 * u - 2.4, 0.04 * v - 2, 0); };  // of one shade
      const int first = static_cast<int>(mesh.vertices.size());
      for (const Vec3& p : {corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)})
        mesh.vertices.push_back(p);
      mesh.triangles.push_back({first, first + 1, first + 2}), mesh.triangles.push_back({first, first + 2, first + 3});
    }
  const auto outline = [](int corners) {
    Region region;
    region.rings.emplace_back();
    for (int i = 0; i < corners; ++i) {
      const double a = 2 * std::numbers::pi * i / corners;
      region.rings[0].emplace_back(2 * std::cos(a), 2 * std::sin(a), 0);
    }
    return region;
  };
  // how many pixels change on letting go
  const auto change = [](const Item& item) {
    Lesson lesson;
    lesson.id = lesson.title = "much", lesson.presets = {{"all", "all", "", {}}};
    lesson.steps = [item](const Parameters&) {
      Walk walk;
      walk.steps.emplace_back();
      walk.steps[0].slug = walk.steps[0].title = "all", walk.steps[0].scene.items = {item};
      return walk;
    };
    WindowDriver window({&lesson});
    const Rect r = window.rect("scene");
    window.move(r.middle_x(), r.middle_y());
    window.button(true);
    window.move(r.middle_x() + 20, r.middle_y() + 7);
    window.move(r.middle_x() + 30, r.middle_y() + 7);  // the pin has come
    const Picture held = window.picture();
    window.button(false);
    window.move(5, r.bottom - 5);  // where no text says what lies under the pointer
    return compare(held, window.picture()).over_8;
  };
  for (const Item& much : {Item(mesh), Item(outline(10'000))}) {
    const int changed = change(much);
    CHECK(changed > 50);    // the rims
    CHECK(changed < 6000);  // and nothing else: it stands where it was let go
  }
  CHECK(change(outline(100)) < 50);
}

TEST_CASE("dragging beside the handles orbits, the right button pans, the wheel zooms, two clicks frame all",
          "[window]") {
  WindowDriver window(both);
  const Camera home = window.player().camera().now();
  const Rect scene = window.rect("scene");
  const float x = scene.left + 60, y = scene.top + 200;
  window.drag(x, y, x + 80, y + 30);
  const Camera turned = window.player().camera().now();
  CHECK(turned.azimuth != home.azimuth);
  CHECK(turned.elevation != home.elevation);
  CHECK(turned.target == home.target);

  window.drag(x, y, x + 80, y + 30, 1);
  CHECK(window.player().camera().now().target != turned.target);
  CHECK(window.player().camera().now().azimuth == turned.azimuth);

  window.wheel(2);
  CHECK(window.player().camera().now().half_height < turned.half_height);

  window.wait(1);  // so that the drags' clicks are long past
  window.click(x, y);
  window.click(x, y);
  CHECK(window.player().camera().now().azimuth == home.azimuth);
}

TEST_CASE("the pointer knows the ball it is over, and not where its circle ends", "[window]") {
  WindowDriver window(both);
  const Rect center = window.rect("handle c");
  window.move(center.middle_x() - 40, center.middle_y() + 40);
  REQUIRE(window.has("ball under pointer"));
  const Rect ball_rect = window.rect("ball under pointer");
  const float x = center.middle_x(), y = ball_rect.bottom;
  window.move(x, y - 2);
  CHECK(window.has("ball under pointer"));
  window.move(x, y + 2);
  CHECK_FALSE(window.has("ball under pointer"));
  window.move(ball_rect.left + 3, ball_rect.top + 3);  // within its square, beside its circle
  CHECK_FALSE(window.has("ball under pointer"));
}

TEST_CASE("P and O and the name in the corner change the projection", "[window]") {
  WindowDriver window(both);
  window.type("p");
  CHECK(window.player().camera().now().perspective);
  window.type("o");
  CHECK_FALSE(window.player().camera().now().perspective);
  window.click("projection");
  CHECK(window.player().camera().now().perspective);
}

TEST_CASE("the scrubber follows the pointer", "[window]") {
  WindowDriver window(both);
  const Rect bar = window.rect("scrubber");
  window.move(bar.left + 16, bar.middle_y());
  window.button(true);
  window.move(bar.middle_x(), bar.middle_y());
  CHECK(window.player().index() == 2);
  window.move(bar.right - 16, bar.middle_y());
  CHECK(window.player().index() == 4);
  window.button(false);
  window.move(bar.left, bar.middle_y());
  CHECK(window.player().index() == 4);
}

TEST_CASE("the transport's buttons do what the keys do", "[window]") {
  WindowDriver window(both);
  window.click("next");
  CHECK(window.player().index() == 1);
  window.click("last");
  CHECK(window.player().at_end());
  window.click("back");
  CHECK(window.player().index() == 3);
  window.click("first");
  CHECK(window.player().index() == 0);
  window.click("speed");
  CHECK(window.player().clock().speed() == 1.5);
  window.click("play");
  CHECK(window.player().clock().playing());
  window.wait(1.2f);
  CHECK(window.player().index() == 1);
  window.type(" ");
  CHECK_FALSE(window.player().clock().playing());
}

TEST_CASE("a question is answered by click or by letter, and the answer is told", "[window]") {
  WindowDriver window(both);
  window.player().go_to(1);
  window.key(key::right);
  REQUIRE(window.has("choice 1"));
  window.click("choice 1");
  REQUIRE(window.player().quiz().answered());
  CHECK_FALSE(window.player().quiz().answered()->right());
  CHECK(window.player().index() == 2);
  window.click("choice 0");  // too late
  CHECK(window.player().quiz().answered()->choice == 1);

  window.type("r");
  window.player().go_to(1);
  window.key(key::right);
  window.type("a");
  REQUIRE(window.player().quiz().answered());
  CHECK(window.player().quiz().answered()->right());
}

TEST_CASE("letters typed into a field are no commands", "[window]") {
  WindowDriver window(both);
  window.key(key::o, true);
  window.frames(2);
  window.type("ball 2");
  CHECK(window.player().played().preset_id() == "squared-inside");
  window.type("");
  CHECK_FALSE(window.has("lesson point-disc"));
}

TEST_CASE("the columns of the key sheet have room beside each other, at any size", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1024, 768}, {1280, 800}, {2560, 1440}}));
  WindowDriver window(both, width, height);
  window.type("?");
  window.frames(2);
  const Rect sheet = window.rect("key sheet"), left = window.rect("keys left"), right = window.rect("keys right");
  CHECK(sheet.left < left.left);
  CHECK(left.right + 12 < right.left);
  CHECK(right.right + 8 < sheet.right);
  CHECK(std::max(left.bottom, right.bottom) < sheet.bottom);
  CHECK(left.height() == right.height());
}

TEST_CASE("the key sheet opens by key and by button, and closes by Escape", "[window]") {
  WindowDriver window(both);
  window.key(key::f1);
  CHECK(window.has("key sheet"));
  window.key(key::escape);
  CHECK_FALSE(window.has("key sheet"));
  window.type("?");
  CHECK(window.has("key sheet"));
  window.key(key::right);  // it keeps the keys from the lesson
  CHECK(window.player().index() == 0);
  window.key(key::f1);
  CHECK_FALSE(window.has("key sheet"));
  window.click("help");
  CHECK(window.has("key sheet"));
}

TEST_CASE("Page Down scrolls the key sheet, Page Up scrolls back, and at the end Page Down closes it", "[window]") {
  const float height = GENERATE(500.0f, 1080.0f);
  WindowDriver window(both, 1280, height);
  window.key(key::f1);
  window.frames(2);
  const float top = window.rect("keys left").top;
  if (height == 500) {
    window.key(key::page_down);
    window.frames(2);
    REQUIRE(window.has("key sheet"));
    CHECK(window.rect("keys left").top < top);
    window.key(key::page_up);
    window.frames(2);
    CHECK(window.rect("keys left").top == top);
  }
  int presses = 0;
  for (; window.has("key sheet") && presses < 9; ++presses) {
    window.key(key::page_down);
    window.frames(2);
  }
  CHECK((height == 500 ? presses > 1 : presses == 1));
  CHECK_FALSE(window.has("key sheet"));
  CHECK(window.player().index() == 0);
}

TEST_CASE("a line of pseudocode leads to its step", "[window]") {
  WindowDriver window(both);
  window.click("line 3");
  CHECK(window.player().step().slug == "compare");
}

}  // namespace window_test
