#include "lessons/relations/pages.h"

#include <fmt/format.h>

#include <set>

#include "lessons/shared/questions.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"
#include "viz/compose/compose.h"
#include "viz/compose/small_multiples.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

const std::vector<std::string> note_pseudocode = {
    "DISJOINT if a and b have no common point",              // 0
    "else EQUAL if a ⊆ b and b ⊆ a",                         // 1
    "else A INSIDE B if a ⊆ b",                              // 2
    "else B INSIDE A if b ⊆ a",                              // 3
    "else TOUCHING if no common point is interior to both",  // 4
    "else OVERLAPPING"                                       // 5
};
namespace {

/// How large the pairs are in each kind of grid: short numbers, so that nothing about them changes.
constexpr double two_by_two = 0.625, two_rows = 0.375, four_rows = 0.21875;

/// Moves a grid to the middle of the picture.
std::vector<Item> centred(const std::vector<Item>& items) {
  const Box2 box = extent(items, camera);
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
  return arrangeable(insets, 3, camera, centred);
}

namespace {

/// A name in a word or two, for narrow columns.
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
  return {centred(small_multiples(insets, 7, camera)), {}, {}};
}

}  // namespace

Walk page_of_all(const Pose& pose) {
  std::vector<Inset> insets;
  std::set<Relation> found;
  std::string alt = "Four pairs in one pose";
  for (const Kind kind : kinds) {
    const Pair pair(kind, pose, two_by_two);
    insets.push_back({drawn(pair, true), name(kind), relation_words(pair.truth, "they"),
                      verdict_kind(pair.truth) == Verdict::Kind::no ? Role::miss : Role::hit});
    found.insert(pair.truth);
    alt += (kind == kinds[0] ? ": " : ", ") + name(kind) + " " + relation_name(pair.truth);
  }
  Script script({"Lecture note Intersection Detection, spatial relationships",
                 alt + ". Then each of six relations for each of four kinds.", note_pseudocode, all_kinds});
  // Whether four relations or one: the shapes matter, and the pose does.
  Step& same =
      script.add("same-place", "One pose, four kinds", -1,
                 found.size() == 1 ? "All four pairs have one pose, and here one relation. Move b, and they may differ."
                                   : fmt::format("All four pairs have one pose, yet {} different relations.\n"
                                                 "Both count: what shape the two sets have, and where they are.",
                                                 found.size()));
  same.scene.items = centred(small_multiples(insets, 2, camera));
  std::vector<WrongNumber> wrong = {{1, "The pose alone does not decide: the shapes matter, too."}};
  for (const std::size_t k : {2u, 3u, 4u})
    wrong.push_back({static_cast<double>(k), k < found.size()
                                                 ? "Two of those that you take for alike differ."
                                                 : "Some of those that you take for different are alike."});
  same.question = which_count("One pose, four kinds of shape. How many different relations?",
                              static_cast<double>(found.size()), wrong, "The exact test of each kind decides.");
  const Ball& b = std::get<Ball>(same.scene.items[1]);
  same.scene.handles = {{.parameter = "b",
                         .kind = Handle::Kind::vector,
                         .at = b.center,
                         .anchor = b.center - two_by_two * pose.b,
                         .role = Role::second,
                         .scale = two_by_two},
                        {"size", Handle::Kind::along, b.center + two_by_two * pose.size * upwards(), b.center,
                         Role::second, upwards() / (two_by_two * axis_length * axis_length)}};
  script.settle(Verdict::Kind::yes, "six relations, whatever the kind");
  script
      .add("six-relations", "Six relations, four kinds", -1,
           "Each pair of convex sets lies in one of these six ways.\n"
           "What they share is marked: boundary points or a common part. Disjoint ones share nothing.")
      .scene = all_pairs_of_all_kinds();
  return std::move(script.walk());
}

}  // namespace isect::lessons::relations_lesson
