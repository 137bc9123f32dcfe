#include "lessons/relations/pages.h"

#include <fmt/format.h>

#include <set>

#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"
#include "viz/compose.h"
#include "viz/grid.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

const std::vector<std::string> pseudocode = {
    "if a and b have no common point: return DISJOINT",         // 0
    "if a ⊆ b and b ⊆ a: return EQUAL",                         // 1
    "if a ⊆ b: return A INSIDE B",                              // 2
    "if b ⊆ a: return B INSIDE A",                              // 3
    "if no common point is interior to both: return TOUCHING",  // 4
    "return OVERLAPPING"                                        // 5
};
namespace {

/// How large the pairs are in each kind of grid: short numbers, so that nothing about them changes.
constexpr double two_rows = 0.375, four_rows = 0.21875;

/// A grid in the middle of the picture.
std::vector<Item> centred(const std::vector<Inset>& insets, int columns) {
  const std::vector<Item> items = in_grid(insets, columns, camera);
  const Box2 box = extent({items, {}, {}}, camera);
  const Vec2 middle = (box.lo + box.hi) / 2;
  return moved(items, in_plane(-middle.x() / axis_length, -middle.y() / axis_length));
}

}  // namespace

Scene six(Kind kind) {
  std::vector<Inset> insets;
  for (const Situation& s : situations(kind)) {
    const Pair pair(kind, s.pose, two_rows);
    insets.push_back(
        {drawn(pair, true), relation_name(pair.truth), pair.meet ? "yes" : "no", pair.meet ? Role::hit : Role::miss});
  }
  return {centred(insets, 3), {}, {}};
}

namespace {

/// In a word or two, for narrow columns.
std::string short_name(Relation relation) {
  const char* const names[] = {"disjoint", "equal", "a in b", "b in a", "touch", "overlap"};
  return names[static_cast<int>(relation)];
}

/// Every relation of every kind.
Scene all_pairs_of_all_kinds() {
  std::vector<Inset> insets;
  for (const Kind kind : kinds) {
    insets.push_back({{viz::Heading{Vec3::Zero(), name(kind), Role::muted, 0.84}}, "", "", Role::text});
    for (const Situation& s : situations(kind)) {
      const Pair pair(kind, s.pose, four_rows);
      insets.push_back({drawn(pair, true), kind == kinds[0] ? short_name(pair.truth) : "", "", Role::text});
    }
  }
  return {centred(insets, 7), {}, {}};
}

}  // namespace

Walk page_of_all(const Pose& pose) {
  std::vector<Inset> insets;
  std::set<Relation> found;
  for (const Kind kind : kinds) {
    const Pair pair(kind, pose, two_rows);
    insets.push_back({drawn(pair, true), name(kind), words(pair.truth, "they"),
                      verdict_kind(pair.truth) == Verdict::Kind::no ? Role::miss : Role::hit});
    found.insert(pair.truth);
  }
  Script script({"Note, N02", "Small pictures of two shapes: each of six relations, for each of four kinds.",
                 pseudocode, all_kinds});
  Step& same = script.add("same-place", "The same places, four kinds", -1,
                          fmt::format("All four pairs have the same centres and sizes, yet {} relations.\n"
                                      "How two things lie is a matter of their shapes, not of where they are.",
                                      found.size()));
  same.scene.items = centred(insets, 4);
  same.question = Question{"Are all four pairs related alike?",
                           {"yes", "no"},
                           found.size() == 1 ? 0 : 1,
                           "The exact test of each kind decides."};
  const Ball& b = std::get<Ball>(same.scene.items[1]);
  same.scene.handles = {{"size", Handle::Kind::along, b.center + two_rows * pose.size * upwards(), b.center,
                         Role::second, upwards() / (two_rows * axis_length * axis_length)}};
  script.settle(Verdict::Kind::yes, "six relations, whatever the kind");
  script
      .add("six-relations", "Six relations, four kinds", -1,
           "Each pair of convex sets lies in one of these six ways.\n"
           "Green is what they share: nothing, boundary points, or a common part.")
      .scene = all_pairs_of_all_kinds();
  return std::move(script.walk());
}

}  // namespace isect::lessons::relations_lesson
