#include "viz/player/player.h"

#include "tests/catch.h"
#include "tests/viz/moving_lesson.h"
#include "tests/viz/sample_lesson.h"
#include "viz/compose/compose.h"
#include "viz/player/camera_moves.h"

namespace player_test {
using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

Vec3 point_of(const Player& player, const std::string& name) { return std::get<Vec3>(player.parameters().at(name)); }
double radius_of(const Player& player) { return std::get<double>(player.parameters().at("r")); }

Handle handle(const Player& player, const std::string& name) {
  for (const Handle& h : player.step().scene.handles)
    if (h.parameter == name) return h;
  throw std::runtime_error("no handle " + name);
}

}  // namespace

TEST_CASE("a player starts paused at the first step of the first lesson's first preset", "[player]") {
  const Player player(both);
  CHECK(player.lesson().id == "point-disc");
  CHECK(player.played().preset_id() == "squared-inside");
  CHECK(player.index() == 0);
  CHECK(player.count() == 5);
  CHECK_FALSE(player.clock().playing());
  CHECK(player.quiz().asked() == nullptr);
}

TEST_CASE("a place opens lesson, preset, step, parameters and camera", "[player]") {
  ReaderState state;
  state.lesson = "point-ball";
  state.step = 2;
  state.parameters = sample::parameters("distance", {3, 0, 0}, {1, 0, 0}, 2.5);
  state.camera = Camera{};
  state.camera->half_height = 7;
  const Player player(both, state);
  CHECK(player.lesson().id == "point-ball");
  CHECK(player.played().preset_id().empty());
  CHECK(player.index() == 2);
  CHECK(player.played().method() == "distance");
  CHECK(player.camera().now().half_height == 7);
  CHECK((*player.reader_state().parameters == *state.parameters));
}

TEST_CASE("a number that is typed or a handle that is dragged keeps the lesson's conditions", "[player]") {
  Lesson lesson = disc;
  lesson.conditions = {
      {"p", "a point that is not 0", [](const Parameters& p) { return std::get<Vec3>(p.at("p")).norm() > 0; }}};
  Player player({&lesson});
  player.edit("p", Vec3(1, 0, 0));
  CHECK_THROWS_AS(player.edit("p", Vec3(0, 0, 0)), BadInput);
  CHECK(point_of(player, "p") == Vec3(1, 0, 0));
  player.drag_handle(handle(player, "p"), Vec3(0, 0, 0));
  CHECK(point_of(player, "p") == Vec3(1, 0, 0));
}

TEST_CASE("a place that is none is refused and nothing changes", "[player]") {
  ReaderState state;
  state.lesson = "point-dis";
  CHECK_THROWS_AS(Player(both, state), BadInput);

  Player player(both);
  player.go_to(1);
  CHECK_THROWS_AS(player.go(state), BadInput);
  state.lesson = "point-ball";
  state.preset = "nowhere";
  CHECK_THROWS_AS(player.go(state), BadInput);
  state.preset.clear();
  state.parameters = sample::parameters("squared", {0, 0, 0}, {0, 0, 0}, -1);
  CHECK_THROWS_AS(player.go(state), BadInput);
  CHECK(player.lesson().id == "point-disc");
  CHECK(player.index() == 1);
  CHECK_FALSE(player.undo());
}

TEST_CASE("stepping stops at both ends", "[player]") {
  Player player(both);
  player.back();
  CHECK(player.index() == 0);
  player.last();
  CHECK(player.at_end());
  player.next();
  CHECK(player.index() == 4);
  player.go_to(99);
  CHECK(player.index() == 4);
  player.go_to(-3);
  CHECK(player.index() == 0);
}

TEST_CASE("a question is asked before its step, and stepping on skips it", "[player]") {
  Player player(both);
  player.go_to(1);
  player.next();
  REQUIRE(player.quiz().asked());
  CHECK(player.quiz().asked()->prompt == "Where is **p**?");
  CHECK(player.index() == 1);
  player.next();
  CHECK(player.index() == 2);
  CHECK_FALSE(player.quiz().asked());
  CHECK_FALSE(player.quiz().answered());
}

TEST_CASE("a question that was skipped is asked again when the reader comes by, and one that was answered is not",
          "[player]") {
  Player player(both);
  player.go_to(1);
  player.next();
  player.next();
  REQUIRE(player.index() == 2);
  CHECK(player.quiz().is_skipped(2));
  player.back();
  player.next();
  REQUIRE(player.quiz().asked());
  CHECK(player.index() == 1);
  player.answer(0);
  CHECK(player.index() == 2);
  CHECK((player.quiz().is_answered(2) && !player.quiz().is_skipped(2)));
  player.back();
  player.next();
  CHECK(player.index() == 2);
  CHECK_FALSE(player.quiz().asked());
}

TEST_CASE("a title to come is told where no question stands before it", "[player]") {
  Player player(both);  // its third step has a question
  player.go_to(0);
  CHECK((player.tells_title(0) && player.tells_title(1) && !player.tells_title(2) && player.tells_title(3)));
  player.go_to(1);
  player.next();
  REQUIRE(player.quiz().asked());
  CHECK((player.tells_title(1) && !player.tells_title(2) && !player.tells_title(3)));
  player.answer(0);
  CHECK((player.tells_title(2) && player.tells_title(3)));
}

TEST_CASE("a number is typed in any form, and what is none leaves the question open", "[player]") {
  const Lesson lesson = sample::asking_for_a_number();
  const auto answer = [&](const std::string& text, const auto& check) {
    INFO(text);
    Player player({&lesson});
    player.go_to(1);
    player.next();
    REQUIRE(player.quiz().wants_number());
    player.answer_typed(text);
    CHECK(player.index() == 2);
    REQUIRE(player.quiz().answered());
    check(*player.quiz().answered());
  };
  for (const char* right : {"3/4", "0.75", "0,75", ".750", "75e-2", "7.5·10^-1"})
    answer(right, [](const Answered& given) { CHECK((given.right() && given.reply.empty())); });
  answer("4/3", [](const Answered& given) {
    CHECK(given.choice == 2);
    CHECK(given.reply == "You divided the other way round.");
  });
  answer("17", [](const Answered& given) {
    CHECK(given.choice == -1);
    CHECK((!given.right() && given.reply.empty()));
  });
  answer("-3/4", [](const Answered& given) { CHECK(given.reply == "The sign is the opposite."); });

  Player player({&lesson});
  player.go_to(1);
  player.next();
  for (const char* none : {"", "abc", "1/0", "1e400"}) {
    INFO(none);
    CHECK_THROWS_AS(player.answer_typed(none), BadInput);
    CHECK((player.index() == 1 && player.quiz().wants_number()));
  }
}

TEST_CASE("the choices of a question for a number are shown as a hint, and stay so while the setting moves",
          "[player]") {
  const Lesson lesson = sample::asking_for_a_number();
  Player player({&lesson});
  player.go_to(1);
  player.next();
  REQUIRE(player.quiz().wants_number());
  player.edit("r", 2.0);
  CHECK(player.quiz().wants_number());
  player.show_choices();
  CHECK_FALSE(player.quiz().wants_number());
  player.edit("r", 2.5);
  REQUIRE(player.quiz().asked());
  CHECK_FALSE(player.quiz().wants_number());
  player.answer_typed("3/4");  // now it is a choice
  CHECK(player.quiz().asked());
  player.answer(3);
  REQUIRE(player.quiz().answered());
  CHECK(player.quiz().answered()->reply == "You did not divide.");
  player.ask_again(2);
  CHECK(player.quiz().wants_number());
}

TEST_CASE("an answer shows the step, and whether it was right", "[player]") {
  Player player(both);
  player.go_to(1);
  player.next();
  player.answer(7);  // no such choice
  REQUIRE(player.quiz().asked());
  player.answer(1);
  CHECK(player.index() == 2);
  REQUIRE(player.quiz().answered());
  CHECK_FALSE(player.quiz().answered()->right());
  CHECK(player.quiz().answered()->question->answer == 0);

  player.restart();
  CHECK_FALSE(player.quiz().answered());
  player.go_to(1);
  player.next();
  player.answer(0);
  CHECK(player.quiz().answered()->right());
  player.back();
  player.next();
  CHECK(player.index() == 2);  // it is not asked twice
}

TEST_CASE("stepping back withdraws a question", "[player]") {
  Player player(both);
  player.go_to(1);
  player.next();
  player.back();
  CHECK(player.index() == 1);
  CHECK_FALSE(player.quiz().asked());
}

TEST_CASE("play takes 1.6 s a step, waits for answers, and ends with the walk", "[player]") {
  Player player(both);
  player.toggle_play();
  player.advance(1.5);
  CHECK(player.index() == 0);
  player.advance(0.2);
  CHECK(player.index() == 1);
  player.advance(1.7);
  REQUIRE(player.quiz().asked());
  for (int i = 0; i < 10; ++i) player.advance(1.7);
  CHECK(player.index() == 1);
  player.answer(0);
  player.clock().set_speed(2);
  player.advance(0.9);
  CHECK(player.index() == 2);  // there is time to read why
  player.advance(1.6);
  CHECK(player.index() == 3);
  player.advance(0.9);
  CHECK(player.index() == 4);
  CHECK_FALSE(player.clock().playing());
  player.toggle_play();
  CHECK(player.index() == 0);
  CHECK(player.clock().playing());
}

TEST_CASE("play passes over questions where it is told to, and after a restart they are asked again", "[player]") {
  Player player(both);
  player.clock().stop_at_questions(false);
  player.next();
  while (!player.quiz().asked()) player.next();
  const int before = player.index();
  player.toggle_play();
  CHECK(player.running());
  player.advance(1.7);
  CHECK(player.index() == before + 1);
  CHECK_FALSE(player.quiz().answered());
  for (int i = 0; i < 100 && player.clock().playing(); ++i) player.advance(1.7);
  CHECK(player.at_end());
  player.go_to(before);
  player.clock().stop_at_questions(true);
  player.restart();
  while (player.index() < before) player.next();
  player.next();
  CHECK(player.quiz().asked());
}

TEST_CASE("the speed goes round from 0.5x to 2x", "[player]") {
  Player player(both);
  std::vector<double> speeds;
  for (int i = 0; i < 5; ++i) {
    speeds.push_back(player.clock().speed());
    player.clock().next_speed();
  }
  CHECK(speeds == std::vector<double>{1, 1.5, 2, 0.5, 1});
}

TEST_CASE("presets of the present group are offered, and another method keeps the case", "[player]") {
  Player player(both);
  REQUIRE(player.played().group().size() == 3);
  player.load(*player.played().group()[1]);
  CHECK(player.played().preset_id() == "squared-outside");
  CHECK(player.step().slug == "way");
  CHECK(player.count() == 4);

  REQUIRE(player.played().methods().size() == 2);
  CHECK(player.played().methods()[1].title == "By distance");
  player.load_method("distance");
  CHECK(player.played().preset_id() == "distance-outside");
  CHECK(player.played().group()[1]->id == "distance-outside");
  CHECK_THROWS_AS(player.load_method("guess"), BadInput);
  CHECK(player.played().method() == "distance");
}

TEST_CASE("another method keeps the step's place, and what was before it comes back", "[player]") {
  Player player(both);
  player.go_to(2);
  REQUIRE(player.step().slug == "compare");
  player.load_method("distance");
  CHECK(player.played().method() == "distance");
  CHECK(player.step().slug == "compare");
  CHECK_FALSE(player.quiz().asked());
  REQUIRE(player.undo());
  CHECK(player.played().method() == "squared");
  CHECK(player.step().slug == "compare");
  player.last();
  player.load_method("distance");
  CHECK(player.at_end());
}

TEST_CASE("parameters changed by hand are no preset, until they are one again", "[player]") {
  Player player(both);
  player.edit("r", 1.0);
  CHECK(player.played().preset_id().empty());
  CHECK(player.reader_state().preset.empty());
  player.edit("r", 1.5);
  CHECK(player.played().preset_id() == "squared-inside");
  CHECK_THROWS_AS(player.edit("r", -1.0), BadInput);
  CHECK_THROWS_AS(player.edit("q", 1.0), BadInput);
  CHECK_THROWS_AS(player.edit("r", Vec3(1, 1, 1)), BadInput);
  CHECK(radius_of(player) == 1.5);
}

TEST_CASE("a dragged handle moves its parameter, and the walk follows at once", "[player]") {
  Player player(both);
  player.last();
  CHECK(player.step().verdict.kind == Verdict::Kind::yes);
  player.drag_handle(handle(player, "p"), {4, 0, 0});
  CHECK(point_of(player, "p") == Vec3(4, 0, 0));
  CHECK(player.step().verdict.kind == Verdict::Kind::no);
  CHECK(player.at_end());
  player.drag_handle(handle(player, "r"), {0, 5, 0});
  CHECK(radius_of(player) == 5);
  CHECK(player.step().verdict.kind == Verdict::Kind::yes);
  CHECK(player.step().slug == "end");  // who stood at the end stays there, however long the walk becomes
}

TEST_CASE("a step that a drag took away comes back with its walk", "[player]") {
  Player player(both);
  player.go_to(3);
  CHECK(player.step().slug == "in");
  player.drag_handle(handle(player, "p"), {4, 0, 0});
  CHECK(player.step().slug == "out");
  player.drag_handle(handle(player, "p"), {0, 0, 0});
  CHECK(player.step().slug == "in");
}

TEST_CASE("restart returns to the preset loaded last", "[player]") {
  Player player(both);
  player.load(*player.played().group()[2]);
  player.edit("r", 4.0);
  player.last();
  player.restart();
  CHECK(player.played().preset_id() == "squared-on");
  CHECK(player.index() == 0);
}

TEST_CASE("the lessons before and after go round", "[player]") {
  Player player(both);
  player.open_neighbour(1);
  CHECK(player.lesson().id == "point-ball");
  player.open_neighbour(1);
  CHECK(player.lesson().id == "point-disc");
  player.open_neighbour(-1);
  CHECK(player.lesson().id == "point-ball");
}

TEST_CASE("undo takes changes back one by one, a run of the same as one", "[player]") {
  Player player(both, {}, true);
  const Camera home = player.camera().now();
  player.load(*player.played().group()[1]);
  orbit(player, {40, 0});
  orbit(player, {40, 10});
  player.end_action();
  orbit(player, {-5, 0});
  player.open_neighbour(1);

  CHECK(player.history().can_undo());
  CHECK_FALSE(player.history().can_redo());
  REQUIRE(player.undo());
  CHECK(player.history().can_redo());
  CHECK(player.lesson().id == "point-disc");
  CHECK(player.played().preset_id() == "squared-outside");
  REQUIRE(player.undo());
  REQUIRE(player.undo());
  CHECK(player.camera().now().azimuth == home.azimuth);
  CHECK(player.camera().now().elevation == home.elevation);
  REQUIRE(player.undo());
  CHECK(player.played().preset_id() == "squared-inside");
  CHECK_FALSE(player.history().can_undo());
  CHECK_FALSE(player.undo());
}

namespace {

/// The sample lesson, which asks only about points inside.
Lesson asking_inside() {
  Lesson lesson = sample::lesson();
  lesson.steps = [](const Parameters& values) {
    Walk walk = sample::walk(values);
    if (walk.steps.size() < 5) walk.steps[2].question.reset();
    return walk;
  };
  return lesson;
}

}  // namespace

TEST_CASE("undo asks again what a drag has taken away, at its step, wherever the reader has gone since", "[player]") {
  const Lesson lesson = asking_inside();
  Player player({&lesson}, {}, true);
  player.go_to(1);
  player.next();
  REQUIRE(player.quiz().asked());
  player.remember("drag");
  player.edit("p", Vec3(1, 0.5, 0));
  CHECK(player.quiz().asked());
  player.edit("p", Vec3(2.5, 1, 0));
  REQUIRE_FALSE(player.quiz().asked());
  player.edit("p", Vec3(3, 1, 0));
  const int on = GENERATE(0, 1, 2);
  for (int i = 0; i < on; ++i) player.next();
  REQUIRE(player.undo());
  CHECK(point_of(player, "p") == Vec3(0.5, 0.5, 0));
  CHECK(player.index() == 1);
  CHECK(player.quiz().asked());
  REQUIRE(player.redo());
  CHECK(point_of(player, "p") == Vec3(3, 1, 0));
  CHECK_FALSE(player.quiz().asked());
  CHECK(player.index() == 1 + on);
}

TEST_CASE("undo of a preset that was loaded at an open question asks it again, with its choices", "[player]") {
  const Lesson lesson = sample::asking_for_a_number();
  Player player({&lesson}, {}, true);
  player.go_to(1);
  player.next();
  const bool choices = GENERATE(true, false);
  if (choices) player.show_choices();
  player.load(*player.played().group()[1]);
  REQUIRE_FALSE(player.quiz().asked());
  REQUIRE(player.undo());
  REQUIRE(player.quiz().asked());
  CHECK(player.index() == 1);
  CHECK(player.quiz().asks_more() == !choices);
}

TEST_CASE("another version that the reader leaves the step for comes with that step when it is undone", "[player]") {
  Lesson edited = disc;
  edited.title = "edited";
  Player player(both, {}, true);
  player.go_to(1);
  const bool leaves = GENERATE(true, false);
  player.show_version(edited, leaves);
  player.go_to(3);
  REQUIRE(player.undo());
  CHECK(&player.lesson() == &disc);
  CHECK(player.index() == (leaves ? 1 : 3));
  REQUIRE(player.redo());
  CHECK(player.index() == 3);
}

TEST_CASE("zoom keeps the point under the pointer, pan moves it with the pointer", "[player]") {
  const bool perspective = GENERATE(false, true);
  Player player(both, {}, true);
  player.set_aspect(1.5);
  set_perspective(player, perspective);
  const Vec2 at(130, 440), to(300, 120);
  const auto view = [&] { return View(player.camera().now(), 900, 600); };
  const Vec3 there = view().on_facing_plane(at, player.camera().now().target);
  zoom(player, view(), at, 1.7);
  CHECK((view().project(there).at - at).norm() < 1e-6);
  pan(player, view(), at, to);
  CHECK((view().project(there).at - to).norm() < 1e-6);
}

TEST_CASE("a glide starts and ends where it should, and is a valid view on its way", "[player]") {
  Player player(both);
  player.set_aspect(1.5);
  const Camera from = player.camera().now();
  set_perspective(player, true);
  CHECK(player.camera().goal().perspective);
  double last_opening = 0;
  for (int i = 0; i < 34; ++i) {
    player.advance(0.01);
    const Camera& now = player.camera().now();
    CHECK(now.half_height == Approx(from.half_height));
    CHECK(now.field_of_view >= last_opening);
    last_opening = now.field_of_view;
  }
  CHECK(player.camera().moving());
  player.advance(0.02);
  CHECK_FALSE(player.camera().moving());
  CHECK(player.camera().now().field_of_view == from.field_of_view);
}

TEST_CASE("orbit stops straight above and straight below", "[player]") {
  Player player(both, {}, true);
  orbit(player, {0, 1e5});
  CHECK(player.camera().now().elevation == Approx(std::numbers::pi / 2));
  orbit(player, {0, -1e5});
  CHECK(player.camera().now().elevation == Approx(-std::numbers::pi / 2));
}

TEST_CASE("a preset frames itself after the camera was moved by hand, a step does not", "[player]") {
  Player player(both, {}, true);
  player.set_aspect(1.5);
  const std::vector<const Preset*> group = player.played().group();
  player.load(*group[1]);
  const Camera framed = player.camera().goal();
  player.load(*group[0]);
  orbit(player, {40, 10});
  zoom(player, View(player.camera().now(), 900, 600), {450, 300}, 3);
  const Camera own = player.camera().goal();
  player.go_to(1);
  CHECK(player.camera().goal() == own);
  CHECK(player.camera().moved());

  player.load(*group[1]);
  CHECK(player.camera().goal() == framed);
  CHECK_FALSE(player.camera().moved());
  REQUIRE(player.undo());
  CHECK(player.camera().goal() == own);
  CHECK(player.camera().moved());
}

TEST_CASE("a pinned view stays for all presets and for a restart, until it is let go or another lesson is opened",
          "[player]") {
  Player player(both, {}, true);
  player.set_aspect(1.5);
  const std::vector<const Preset*> group = player.played().group();
  orbit(player, {40, 10});
  const Camera own = player.camera().goal();
  player.pin_camera(true);
  player.load(*group[1]);
  CHECK(player.camera().goal() == own);
  player.go_to(2);
  CHECK(player.camera().goal() == own);
  player.restart();
  CHECK(player.camera().goal() == own);
  player.set_aspect(0.7);
  CHECK(player.camera().goal() == own);
  player.pin_camera(false);
  player.load(*group[0]);
  CHECK(player.camera().goal() != own);
  CHECK_FALSE(player.camera().moved());

  player.pin_camera(true);
  player.open_neighbour(1);
  CHECK_FALSE(player.camera().pinned());
}

TEST_CASE("frame all counts as not moved, and a chosen projection outlasts a preset", "[player]") {
  Player player(both, {}, true);
  player.set_aspect(1.5);
  orbit(player, {40, 10});
  frame_all(player);
  CHECK_FALSE(player.camera().moved());
  CHECK(player.camera().goal() == player.camera().whole(player.played()));
  REQUIRE(player.undo());
  CHECK(player.camera().moved());

  set_perspective(player, true);
  player.load(*player.played().group()[1]);
  CHECK(player.camera().goal().perspective);
  CHECK_FALSE(player.camera().moved());
}

TEST_CASE("what a step shows can be brought into view in the reader's own direction", "[player]") {
  Player player(both, {}, true);
  player.set_aspect(1.5);
  orbit(player, {40, 10});
  const double azimuth = player.camera().goal().azimuth;
  player.move_camera("", [](CameraRig& camera) {
    Camera away = camera.goal();
    away.target += Vec3(100, 0, 0);
    camera.jump(away);
  });
  const auto seen = [&](const Vec3& at) {
    const Vec2 p = View(player.camera().goal(), 900, 600).project(at).at;
    return p.x() >= 0 && p.x() <= 900 && p.y() >= 0 && p.y() <= 600;
  };
  REQUIRE_FALSE(player.scene().handles.empty());
  for (const Handle& h : player.scene().handles) CHECK_FALSE(seen(h.at));
  frame_shown(player);
  for (const Handle& h : player.scene().handles) CHECK(seen(h.at));
  CHECK(player.camera().goal().azimuth == azimuth);
}

TEST_CASE("another version of a lesson takes its place in the list, and undo brings back the one before", "[player]") {
  Lesson edited = disc, again = disc;
  edited.title = "edited", again.title = "edited again";
  edited.presets.front().parameters.at("r") = 2.5;
  Player player(both, {}, true);
  player.go_to(2);
  player.remember("drag");
  player.edit("p", Vec3(0.25, 0, 0));
  player.end_action();
  orbit(player, {10, 0});
  player.end_action();
  const Camera view = player.camera().goal();
  player.show_version(edited);
  player.show_version(again);
  CHECK(&player.lesson() == &again);
  CHECK(player.lessons().front() == &again);
  CHECK(player.index() == 2);
  CHECK(player.camera().goal() == view);
  player.open(ball);
  player.open(again);
  CHECK(player.lessons().front() == &again);
  for (int i = 0; i < 3; ++i) REQUIRE(player.undo());
  CHECK(&player.lesson() == &edited);
  CHECK(player.lessons().front() == &edited);
  CHECK(radius_of(player) == 2.5);
  REQUIRE(player.undo());
  CHECK(&player.lesson() == &disc);
  CHECK(point_of(player, "p") == Vec3(0.25, 0, 0));
  REQUIRE(player.redo());
  CHECK(&player.lesson() == &edited);
  CHECK(radius_of(player) == 2.5);
}

TEST_CASE("a view nobody has moved follows the window's shape, one that was moved does not", "[player]") {
  Player player(both, {}, true);
  player.set_aspect(2);
  const double wide = player.camera().now().half_height;
  player.set_aspect(0.25);
  CHECK(player.camera().now().half_height > wide);
  orbit(player, {10, 0});
  const double kept = player.camera().now().half_height;
  player.set_aspect(2);
  CHECK(player.camera().now().half_height == kept);
}

TEST_CASE("a played walk knows which rooms its steps need, and what choices are called", "[player]") {
  const Lesson moves = moving::lesson();
  Lesson with_axis = disc;
  with_axis.steps = [](const Parameters& values) {
    Walk walk = sample::walk(values);
    walk.steps.back().scene.axis = Axis();
    return walk;
  };
  const Player still({&disc}), axis({&with_axis}), moving({&moves});
  CHECK_FALSE((still.played().has_axis() || still.played().has_time()));
  CHECK((axis.played().has_axis() && !axis.played().has_time()));
  CHECK((moving.played().has_time() && !moving.played().has_axis()));
  const Parameter &way = disc.parameters[0], &radius = disc.parameters[3];
  CHECK(still.played().title_of(way, "squared") == "By squares");
  CHECK(still.played().title_of(way, "by hand") == "by hand");
  CHECK(still.played().title_of(radius, "squared") == "squared");
}

}  // namespace player_test
