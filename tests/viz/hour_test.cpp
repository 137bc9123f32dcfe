// The way through a playlist: on and back over steps and stops, questions asked, and what can't be opened.

#include "viz/player/hour.h"

#include "tests/catch.h"
#include "tests/viz/moving_lesson.h"
#include "tests/viz/playlists.h"
#include "tests/viz/sample_lesson.h"

namespace hour_test {
using namespace isect::viz;
using sample::broken_stop, sample::stop_at;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

/// An hour and its player, and where they are: "2/3", or "2/3?" while the question of the second stop's step 3 is open.
struct Walked {
  explicit Walked(const std::vector<Stop>& stops, const HourPlace& at = {})
      : hour({"An hour", "/hour.json", stops}, at), player(both, hour.start()) {
    hour.begin(player);
  }
  std::string where() const {
    const bool asked = player.quiz().asked() != nullptr;
    return std::to_string(hour.at() + 1) + "/" + std::to_string(player.index() + 1 + asked) + (asked ? "?" : "");
  }
  std::string on() {
    const bool more = hour.on(player);
    hour.follow(player);
    return more ? where() : "end";
  }
  std::string back() {
    const bool more = hour.back(player);
    hour.follow(player);
    return more ? where() : "begin";
  }
  Hour hour;
  Player player;
};

using Places = std::vector<std::string>;

Places all_on(Walked& walked) {
  Places places;
  while (places.size() < 50 && (places.empty() || places.back() != "end")) places.push_back(walked.on());
  return places;
}

Places all_back(Walked& walked) {
  Places places;
  while (places.size() < 50 && (places.empty() || places.back() != "begin")) places.push_back(walked.back());
  return places;
}

}  // namespace

TEST_CASE("an hour goes step by step, asks each question before its step, and goes on to the next stop", "[hour]") {
  Walked w({stop_at(disc, "squared-inside", {0, 1, 2}), stop_at(ball, "squared-outside", {2, 3}),
            stop_at(disc, "distance-on")});
  CHECK(w.where() == "1/1");
  CHECK(w.hour.told() == "1 of 3");
  CHECK(w.hour.at_start(w.player));
  CHECK(all_on(w) ==
        Places{"1/2", "1/3?", "1/3", "2/3?", "2/3", "2/4", "3/1", "3/2", "3/3?", "3/3", "3/4", "3/5", "end"});
  CHECK(w.hour.at_end(w.player));
  CHECK(w.hour.told() == "3 of 3");
  CHECK(all_back(w) == Places{"3/4", "3/3", "3/2", "3/1", "2/4", "2/3", "1/3", "1/2", "1/1", "begin"});
  CHECK(w.hour.at_start(w.player));
}

TEST_CASE("a stop's step is drawn at its time, from wherever it is come to", "[hour]") {
  const Lesson moves = moving::lesson();
  Stop timed = stop_at(moves, "usual", {0, 1, 2}), plain = stop_at(moves, "usual", {0, 1, 2});
  timed.timed = 1, timed.state.time = 0.75;
  Hour hour({"An hour", "/hour.json", {plain, timed}});
  Player player({&moves}, hour.start());
  hour.begin(player);
  const auto on = [&] {
    REQUIRE(hour.on(player));
    hour.follow(player);
  };
  on();
  CHECK((player.index() == 1 && !player.time_is_chosen()));  // of the first stop
  on(), on();
  CHECK((player.index() == 2 && hour.at() == 0));
  on();
  CHECK((player.index() == 0 && hour.at() == 1 && !player.time_is_chosen()));
  on();
  CHECK((player.index() == 1 && player.now() == 0.75));
  player.set_time(1.5);
  hour.follow(player);
  CHECK(player.now() == 1.5);  // the reader's
  on(), on();
  CHECK((player.index() == 2 && !player.time_is_chosen()));
  REQUIRE(hour.back(player));
  CHECK((player.index() == 1 && player.now() == 0.75));

  timed.timed = 2, timed.asks = true, timed.steps = {2}, timed.state.step = 2;
  Hour asking({"An hour", "/hour.json", {timed}});
  Player asked({&moves}, asking.start());
  asking.begin(asked);
  REQUIRE(asked.quiz().asked());
  CHECK_FALSE(asked.time_is_chosen());
  asked.answer(0);
  asking.follow(asked);
  CHECK((asked.index() == 2 && asked.now() == 0.75));

  const Player again({&moves}, Hour({"An hour", "/hour.json", {timed}}, {"/hour.json", 0, 2}).start());
  CHECK((again.index() == 2 && again.now() == 0.75));
}

TEST_CASE("a stop leaves out steps, but never a question of those that it has", "[hour]") {
  Walked w({stop_at(disc, "squared-inside", {1, 3}), stop_at(ball, "squared-inside", {0, 2})});
  CHECK(w.where() == "1/2");
  CHECK(all_on(w) == Places{"1/4", "2/1", "2/3?", "2/3", "end"});
  CHECK(w.back() == "2/1");
  CHECK(w.on() == "2/3?");
  CHECK(w.back() == "2/1");
  CHECK(w.back() == "1/4");
  CHECK(w.back() == "1/2");
}

TEST_CASE("back from a question closes it, and from the one with which a stop begins leads to the stop before",
          "[hour]") {
  Walked w({stop_at(disc, "squared-inside", {0, 1, 2}), stop_at(ball, "squared-inside", {2})});
  w.on();
  REQUIRE(w.on() == "1/3?");
  CHECK(w.back() == "1/2");
  w.on(), w.on();
  REQUIRE(w.on() == "2/3?");
  CHECK(w.back() == "1/3");
}

TEST_CASE("a question that is answered is told, and the hour goes on from there", "[hour]") {
  Walked w({stop_at(disc, "squared-inside")});
  w.on();
  REQUIRE(w.on() == "1/3?");
  w.player.answer(1);
  w.hour.follow(w.player);
  CHECK(w.where() == "1/3");
  CHECK(w.player.quiz().answered());
  CHECK(w.on() == "1/4");
}

TEST_CASE("what a reader does between two steps loses nothing of the hour", "[hour]") {
  Walked w({stop_at(disc, "squared-inside"), stop_at(ball, "squared-inside", {0, 3})});
  w.on();
  SECTION("another lesson: the next press returns, either way") {
    w.player.open(ball);
    w.hour.follow(w.player);
    CHECK(w.hour.away(w.player));
    CHECK(w.hour.told() == "1 of 2");
    CHECK_FALSE(w.hour.leaves(w.player));
    const bool on = GENERATE(true, false);
    CHECK((on ? w.on() : w.back()) == "1/2");
    CHECK_FALSE(w.hour.away(w.player));
    CHECK(w.on() == "1/3?");
  }
  SECTION("another setting, with fewer steps: its walk is gone through to its end") {
    w.player.set_parameters(preset(disc, "squared-outside").parameters);
    w.hour.follow(w.player);
    CHECK_FALSE(w.hour.away(w.player));
    CHECK(all_on(w) == Places{"1/3?", "1/3", "1/4", "2/1", "2/4", "end"});
  }
  SECTION("another preset: the next press returns, as from another lesson, and so does undo") {
    w.player.load(preset(disc, "squared-outside"));
    w.hour.follow(w.player);
    CHECK(w.hour.away(w.player));
    if (GENERATE(true, false)) {
      CHECK(w.on() == "1/2");
      CHECK(w.player.played().preset_id() == "squared-inside");
    } else {
      REQUIRE(w.player.undo());
      CHECK(w.where() == "1/2");
    }
    CHECK_FALSE(w.hour.away(w.player));
    CHECK(w.on() == "1/3?");
  }
  SECTION("a step that the stop leaves out: on and back lead to those that it has") {
    w.hour.open(w.player, 1);
    w.player.go_to(1);
    w.hour.follow(w.player);
    CHECK(w.on() == "2/4");
    w.player.go_to(1);
    CHECK(w.back() == "2/1");
    w.player.go_to(4);
    CHECK(w.on() == "end");
  }
}

TEST_CASE("a stop that can't be opened is gone to, told, and left by the next press", "[hour]") {
  Walked w({stop_at(disc, "squared-inside", {0, 1}), broken_stop(), stop_at(ball, "squared-inside", {0})});
  w.on();
  CHECK_FALSE(w.hour.faulty(w.player));
  w.on();
  CHECK(w.hour.told() == "2 of 3");
  CHECK(w.hour.faulty(w.player));
  CHECK(w.player.lesson().id == "point-disc");
  CHECK(w.on() == "3/1");
  CHECK_FALSE(w.hour.faulty(w.player));
  w.back();
  CHECK(w.hour.faulty(w.player));
  CHECK(w.back() == "1/2");
  w.hour.open(w.player, 1);
  w.player.open(ball);
  CHECK_FALSE(w.hour.faulty(w.player));  // something else is on show
  CHECK(w.hour.told() == "2 of 3");
}

TEST_CASE("an hour whose first or last stop can't be opened has all the others", "[hour]") {
  Walked w({broken_stop(), stop_at(ball, "squared-inside", {0}), broken_stop()});
  CHECK(w.hour.faulty(w.player));
  CHECK(w.hour.at_start(w.player));
  CHECK(w.on() == "2/1");
  w.on();
  CHECK(w.hour.told() == "3 of 3");
  CHECK(w.hour.faulty(w.player));
  CHECK(w.hour.at_end(w.player));
  CHECK(w.on() == "end");
  CHECK_THROWS_AS(Hour({"", "", {broken_stop()}}).start(), BadInput);
  CHECK_THROWS_AS(Hour({"", "", {}}), BadInput);
}

TEST_CASE("an hour goes on from the place where it was left", "[hour]") {
  const std::vector<Stop> stops = {stop_at(disc, "squared-inside"), stop_at(ball, "squared-outside", {2, 3})};
  Walked w(stops);
  const auto again = [&](const HourPlace& at) { return Walked(stops, at).where(); };
  w.on();
  CHECK(w.hour.place() == HourPlace{"/hour.json", 0, 1});
  CHECK(again(w.hour.place()) == "1/2");
  w.hour.open(w.player, 1);
  CHECK(w.where() == "2/3?");
  CHECK(again(w.hour.place()) == "2/3?");
  w.on();
  CHECK(again(w.hour.place()) == "2/3");
  CHECK(again({"/other.json", 1, 1}) == "1/1");
  CHECK(again({"/hour.json", 7, 1}) == "2/3?");  // the file has fewer stops now
  CHECK(again({"/hour.json", 0, 99}) == "1/5");
}

TEST_CASE("an hour knows whether its stop still asks something", "[hour]") {
  Walked w(
      {stop_at(disc, "squared-inside"), stop_at(ball, "squared-inside", {0, 1}), stop_at(disc, "distance-on", {2})});
  CHECK(w.hour.asks_ahead(w.player));
  w.on();
  REQUIRE(w.on() == "1/3?");
  CHECK(w.hour.asks_ahead(w.player));
  SECTION("an answer") { w.player.answer(0); }
  SECTION("passed over") { w.on(); }
  w.hour.follow(w.player);
  CHECK_FALSE(w.hour.asks_ahead(w.player));
  w.hour.open(w.player, 1);  // without the step that is asked about
  CHECK_FALSE(w.hour.asks_ahead(w.player));
  w.hour.open(w.player, 2);
  CHECK(w.hour.asks_ahead(w.player));
  w.player.open(ball);
  CHECK_FALSE(w.hour.asks_ahead(w.player));
}

TEST_CASE("play ends where the stop does", "[hour]") {
  Walked w({stop_at(disc, "squared-inside", {0, 1}), stop_at(ball, "squared-inside")});
  w.player.toggle_play();
  for (int i = 0; i < 1200; ++i) {
    w.player.advance(0.1);
    w.hour.follow(w.player);
  }
  CHECK(w.where() == "1/2");
  CHECK_FALSE(w.player.clock().playing());
}

}  // namespace hour_test
