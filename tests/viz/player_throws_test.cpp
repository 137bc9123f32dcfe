// Whatever throws within an action of the player - memory, or the lesson itself - leaves the player as it was.

#include <cstdlib>
#include <functional>
#include <limits>
#include <new>

#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/scarce_memory.h"
#include "viz/player/camera_moves.h"
#include "viz/player/player.h"
#include "viz/player/reader_state.h"

namespace player_throws_test {
using namespace isect::viz;
using isect::tests::allocations_left;

namespace {

/// The functions of the sample lesson throw after this many calls; negative: never.
int calls_left = -1;

void call() {
  if (calls_left == 0) throw BadInput("the lesson fails");
  if (calls_left > 0) --calls_left;
}

Walk failing_walk(const Parameters& values) {
  call();
  return sample::walk(values);
}
std::vector<Opinion> failing_opinions(const Parameters&) {
  call();
  return {{"by squares", "inside", true}, {"by distance", "outside", false}};
}
Vec2 nowhere(const Parameters&) {
  call();
  return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
}
const CaseMap map = {"x", "y", {0, 0}, {4, 4}, {"all"}, nullptr, nowhere, [](const Parameters& from, const Vec2& at) {
                       call();
                       Parameters moved = from;
                       moved["p"] = Vec3(at.x(), at.y(), 0);
                       return moved;
                     }};

Lesson failing(Lesson lesson) {
  lesson.steps = failing_walk;
  lesson.opinions = failing_opinions;
  lesson.map = &map;
  return lesson;
}
const Lesson disc = failing(sample::lesson()), ball = failing(sample::other_lesson());

/// The visible state of a player, including that found by undoing all that it remembers.
struct Seen {
  std::string place;
  unsigned revision;
  bool playing, asking, answered;
  std::vector<std::string> methods, opinions, behind;

  bool operator==(const Seen&) const = default;
};

Seen seen(Player player) {
  Seen s = {to_json(player.reader_state()),
            player.revision(),
            player.clock().playing(),
            player.quiz().asked() != nullptr,
            player.quiz().answered().has_value(),
            {},
            {},
            {}};
  for (const Method& m : player.played().methods()) s.methods.push_back(m.title);
  for (const Opinion& o : player.played().opinions()) s.opinions.push_back(o.method + o.says);
  while (player.undo()) s.behind.push_back(to_json(player.reader_state()));
  return s;
}

/// A player in the middle of work: much to undo, a step answered, another one asked, a view of the reader's own.
Player busy() {
  Player player({&disc, &ball});
  for (int i = 0; i < 101; ++i) player.load(disc.presets[i % 2]);  // one more than is kept
  player.edit("r", 1.5);
  player.go_to(1);
  player.next();
  player.toggle_play();
  player.remember("zoom");
  orbit(player, {40, 20});
  return player;
}

struct Action {
  const char* name;
  std::function<void(Player&)> act;
};

const std::vector<Action> actions = {
    {"open another lesson", [](Player& p) { p.open(ball); }},
    {"open the lesson after", [](Player& p) { p.open_neighbour(1); }},
    {"load a preset", [](Player& p) { p.load(disc.presets.back()); }},
    {"load a method", [](Player& p) { p.load_method("distance"); }},
    {"restart", [](Player& p) { p.restart(); }},
    {"edit", [](Player& p) { p.edit("r", 2.25); }},
    {"drag",
     [](Player& p) {
       p.drag_handle(p.step().scene.handles.front(), {1, 0.25, 0});
     }},
    {"go to a case",
     [](Player& p) {
       p.go_to_case({3, 2});
     }},
    {"go to a place",
     [](Player& p) {
       ReaderState state;
       state.lesson = "point-ball";
       state.step = 2;
       state.camera = Camera{};
       p.go(state);
     }},
    {"another aspect", [](Player& p) { p.set_aspect(2); }},
    {"frame all", [](Player& p) { frame_all(p); }},
    {"frame the step", [](Player& p) { frame_shown(p); }},
    {"turn",
     [](Player& p) {
       p.end_action(), orbit(p, {5, 5});
     }},
    {"perspective", [](Player& p) { set_perspective(p, !p.camera().goal().perspective); }},
    {"remember", [](Player& p) { p.remember("a name that is too long for a string without memory"); }},
    {"answer", [](Player& p) { p.answer(0); }},
    {"skip the question", [](Player& p) { p.next(); }},
    {"take back", [](Player& p) { p.undo(); }},
};

/// Lets the action fail at the k-th chance that `left` counts, for increasing k, until it succeeds. Returns how often
/// it failed.
template <class Count>
int fail_everywhere(const Action& action, Count& left, const std::function<Count(Count)>& next) {
  const Player before = busy();
  const Seen seen_before = seen(before);
  int failures = 0;
  for (Count k = 0;; k = next(k)) {
    Player player = before;
    bool failed = false;
    left = k;
    try {
      action.act(player);
    } catch (const std::exception&) {
      failed = true;
    }
    left = -1;
    if (!failed) return failures;
    ++failures;
    INFO(action.name << ", failing at " << k);
    REQUIRE((seen(player) == seen_before));
  }
}

}  // namespace

TEST_CASE("an action whose lesson throws at any of its calls changes nothing", "[player]") {
  int failures = 0;
  for (const Action& action : actions)
    failures += fail_everywhere<int>(action, calls_left, [](int k) { return k + 1; });
  CHECK(failures > 30);  // the lesson is called by most of the actions, several times
}

TEST_CASE("an action that runs out of memory anywhere changes nothing", "[player]") {
  for (const Action& action : actions) {
    if (action.name == std::string("turn") || action.name == std::string("another aspect")) continue;
    const int failures = fail_everywhere<long>(action, allocations_left, [](long k) { return k + 1 + k / 16; });
    INFO(action.name);
    CHECK(failures > 0);
  }
}

TEST_CASE("an action that failed once does its whole work when it is tried again", "[player]") {
  for (const Action& action : actions) {
    Player once = busy(), again = busy();
    action.act(once);
    bool failed = false;
    calls_left = 0;
    try {
      action.act(again);
    } catch (const BadInput&) {
      failed = true;
    }
    calls_left = -1;
    if (failed) action.act(again);
    INFO(action.name);
    CHECK((seen(again) == seen(once)));
  }
}

}  // namespace player_throws_test
