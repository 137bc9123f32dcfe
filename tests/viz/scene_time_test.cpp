// Time within a step: how it runs, and what a player shows of it.

#include "viz/player/scene_time.h"

#include <cmath>
#include <limits>

#include "tests/catch.h"
#include "tests/viz/moving_lesson.h"
#include "viz/player/player.h"
#include "viz/walk/question_scene.h"

namespace scene_time_test {
using namespace isect::viz;

namespace {

Scene::Time motion(std::optional<double> contact) { return {2, 12, 2, contact, moving::at}; }

/// The time after so many seconds of frames.
double played(const Scene::Time& time, double from, double seconds, double a_frame) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / a_frame)); ++i) from = time_after(time, from, a_frame);
  return from;
}

const Lesson lesson = moving::lesson();
Player player() { return Player({&lesson}, {}, false); }
double place(const Player& p) { return std::get<Dot>(p.scene().items.at(0)).at.x(); }

}  // namespace

TEST_CASE("time runs evenly where no contact is known, and stops at the end", "[scene_time]") {
  const Scene::Time time = motion({});
  CHECK(time_after(time, 2, 1) == Approx(4.5));
  CHECK(time_after(time, 2, seconds_of_motion) == Approx(12));
  CHECK(time_after(time, 2, 1e9) == 12);
  CHECK(time_after(time, 12, 1) == 12);
  CHECK(time_after(time, 3, 0) == 3);
}

TEST_CASE("play slows down around the contact, whatever the frames", "[scene_time]") {
  const Scene::Time time = motion(7.0);
  CHECK(time_after(time, 2, 0.1) == Approx(2.25));
  CHECK(time_after(time, 6.5, 0.1) == Approx(6.5 + 0.25 / slower));
  CHECK(time_after(time, 7, 0.1) == Approx(7 + 0.25 / slower));
  CHECK(time_after(time, 9, 0.1) == Approx(9.25));
  // 8 of 10 at full pace, 2 slowly
  const double whole = seconds_of_motion * (0.8 + 0.2 * slower);
  CHECK(time_after(time, 2, whole - 0.01) < 12);
  CHECK(time_after(time, 2, whole + 0.01) == 12);
  for (const double seconds : {1.0, 2.5, 4.0, 5.0})
    CHECK(played(time, 2, seconds, 0.125) == Approx(time_after(time, 2, seconds)));
}

TEST_CASE("a contact at either end slows down what there is of the motion", "[scene_time]") {
  CHECK(time_after(motion(2.0), 2, 0.1) == Approx(2 + 0.25 / slower));
  CHECK(time_after(motion(12.0), 11.5, 0.1) == Approx(11.5 + 0.25 / slower));
  CHECK(time_after(motion(12.0), 11.5, 100) == 12);
}

TEST_CASE("beyond the ends of a motion there is no time, and at the contact there is that very one", "[scene_time]") {
  const double third = 2 + 10.0 / 3;
  const Scene::Time time = motion(third);
  CHECK(time_near(time, -5) == 2);
  CHECK(time_near(time, 99) == 12);
  CHECK(time_near(time, std::numeric_limits<double>::quiet_NaN()) == 2);
  CHECK(time_near(time, third + 0.04, 0.05) == third);
  CHECK(time_near(time, third + 0.06, 0.05) == third + 0.06);
  // keys stop there, too
  double t = 2;
  for (int i = 0; i < 60 && t < third; ++i) t = time_beside(time, t, 1);
  CHECK(t == third);
  CHECK(time_beside(time, t, 1) > third);
  CHECK(time_beside(time, t, -1) < third);
  CHECK(time_beside(time, 2, -1) == 2);
}

TEST_CASE("stills stand for the motion, the contact among them, and begin anew after the end", "[scene_time]") {
  const Scene::Time time = motion(8.0);
  std::vector<double> seen;
  for (double t = 2; seen.empty() || t != 2; t = next_still(time, t)) seen.push_back(t);
  CHECK(seen == std::vector<double>{2, 4.5, 7, 8, 9.5, 12});
}

TEST_CASE("the time is told in few digits, the contact as everywhere", "[scene_time]") {
  CHECK(time_words({0, 2, 0, 0.5, moving::at}, 0.3712345) == "*t* = 0.371 (contact at *t* = 0.5)");
  CHECK(time_words({0, 2, 0, 0.5, moving::at}, 0.5) == "*t* = 0.5 (contact)");
  CHECK(time_words({0, 2, 0, {}, moving::at}, 0.3712345) == "*t* = 0.371");
  CHECK(time_words({0, 2, 0, 0.5, moving::at}, 0.25, true) == "*t* = 0.25");
  CHECK(time_words({0, 2, 0, {}, moving::at}, 0) == "*t* = 0");
  CHECK(time_words({0, 4e-6, 0, {}, moving::at}, 1.23456e-6).find("1.23") != std::string::npos);
}

TEST_CASE("a scene is drawn at its time by its own lesson, and a step begins at its own", "[scene_time]") {
  Player p = player();
  CHECK(place(p) == 0);
  CHECK_FALSE(p.time_is_chosen());
  p.set_time(0.75);
  CHECK(place(p) == 0.75);
  CHECK(p.time() != nullptr);
  p.set_time(1e300);
  CHECK(p.now() == 2);
  CHECK(place(p) == 2);
  p.set_time(-3);
  CHECK(place(p) == 0);
  p.set_time(1);
  p.next();
  CHECK(p.index() == 1);
  CHECK_FALSE(p.time_is_chosen());
  CHECK(place(p) == 0);
}

TEST_CASE("time runs until its end, and then from the begin, and steps do not play meanwhile", "[scene_time]") {
  Player p = player();
  p.toggle_play();
  p.toggle_time();
  CHECK((p.time_runs() && !p.clock().playing()));
  p.advance(1);
  CHECK(p.now() == Approx(2 / seconds_of_motion));
  CHECK(p.index() == 0);
  p.toggle_time();
  p.advance(1);
  CHECK(p.now() == Approx(2 / seconds_of_motion));
  p.toggle_time();
  p.advance(100);
  CHECK((p.now() == 2 && !p.time_runs()));
  p.toggle_time();
  CHECK((p.now() == 0 && p.time_runs()));
  p.toggle_play();
  CHECK_FALSE(p.time_runs());
}

TEST_CASE("with reduced motion nothing runs: the next still is shown", "[scene_time]") {
  Player p = player();
  p.reduce_motion(true);
  p.toggle_time();
  CHECK((p.now() == 0.5 && !p.time_runs()));
  p.toggle_time();
  CHECK(p.now() == 1);
}

TEST_CASE("while a question is open no time runs", "[scene_time]") {
  Player p = player();
  p.go_to(1);
  p.toggle_time();
  p.next();
  REQUIRE(p.quiz().asked());
  CHECK(p.time() == nullptr);
  CHECK_FALSE(p.time_runs());
  p.toggle_time();
  p.set_time(1);
  p.advance(1);
  CHECK_FALSE(p.time_is_chosen());
  CHECK(asking_step(p.walk(), 2).scene.time == nullptr);
  p.answer(0);
  REQUIRE(p.time() != nullptr);
  CHECK(p.time()->contact == 0.5);
}

TEST_CASE("a change of the setting keeps the time on show, as far as the motion has it", "[scene_time]") {
  Player p = player();
  p.set_time(1.5);
  p.edit("speed", 3.0);
  CHECK(p.now() == 1.5);
  CHECK(place(p) == 4.5);
  p.edit("duration", 1.0);
  CHECK(p.now() == 1);
  p.load(lesson.presets.front());
  CHECK_FALSE(p.time_is_chosen());
}

TEST_CASE("the view holds the whole motion once time runs, unless the reader has moved it", "[scene_time]") {
  Player p = player();
  p.set_aspect(1.5);
  const double before = p.camera().goal().half_height;
  p.set_time(1);
  const Camera goal = p.camera().goal();
  CHECK(goal.half_height > before);
  const View view(goal, 150, 100);
  for (const double t : {0.0, 2.0}) {
    const Vec2 at = view.project({t, 0, 0}).at;
    CHECK((at.x() >= 0 && at.x() <= 150));
  }
  p.next();
  CHECK(p.camera().goal().half_height == Approx(before));
}

TEST_CASE("a player's place keeps the time that was chosen, and another player draws it", "[scene_time]") {
  Player p = player();
  p.go_to(2);
  CHECK_FALSE(p.reader_state().time);
  p.set_time(0.75);
  const ReaderState kept = p.reader_state();
  CHECK(kept.time == 0.75);
  const Player other({&lesson}, kept, false);
  CHECK((other.index() == 2 && other.now() == 0.75 && place(other) == 0.75));
  p.go_to(1);
  CHECK_FALSE(p.reader_state().time);
  p.go(kept);
  CHECK((p.now() == 0.75 && place(p) == 0.75));
  p.next();
  CHECK_FALSE(p.time_is_chosen());
}

TEST_CASE("a walk is drawn at a time of one step, whose questions show what they did", "[scene_time]") {
  Walk walk = lesson.walk(lesson.presets.front().parameters);
  walk.steps[1].question = walk.steps[2].question;
  const Walk posed = at_time(walk, 1, 0.5);
  const auto dot = [](const Scene& scene) { return std::get<Dot>(scene.items.at(0)).at.x(); };
  CHECK((dot(posed.steps[1].scene) == 0.5 && dot(posed.steps[0].scene) == 0 && dot(posed.steps[2].scene) == 0));
  CHECK(posed.steps[1].scene.time->now == 0.5);
  CHECK(posed.steps[1].caption == walk.steps[1].caption + " The picture shows *t* = 0.5.");
  for (const int asked : {1, 2}) CHECK(dot(question_scene(posed, asked)) == dot(question_scene(walk, asked)));
  CHECK(dot(at_time(walk, 1, 99).steps[1].scene) == 2);
  CHECK(at_time(walk, 3, 1).steps[3].caption == walk.steps[3].caption);  // nothing moves there

  Player p = player();
  CHECK(dot(p.drawn_walk().steps[0].scene) == 0);
  p.set_time(1.5);
  CHECK(dot(p.drawn_walk().steps[0].scene) == 1.5);
}

}  // namespace scene_time_test
