// How two sets can lie (N02): six relations, distinguished by three questions; and what a yes or no loses.
//
// The shapes stand in relations/pair, their pictures in relations/picture, pages of many in relations/pages, the three
// questions in relations/telling.

#include <algorithm>

#include "lessons/course.h"
#include "lessons/relations/pages.h"
#include "lessons/relations/telling.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/plane.h"

namespace isect::lessons::relations_lesson {

namespace {

using namespace viz;

Walk walk(const Parameters& p) {
  const Kind* const kind = kind_of(p);
  if (!kind) return page_of_all(pose(p));
  return questions(*kind, pose(p));
}

Preset preset_of(const std::string& kind, const std::string& id, const std::string& title, const Pose& pose) {
  return {id, title, "", {{"kind", kind}, {"b", pose.b}, {"size", pose.size}, {"turn", pose.turn}}};
}

std::vector<Preset> presets() {
  const std::vector<std::pair<Kind, std::vector<std::string>>> chosen = {
      {Kind::polygons, {"overlapping", "touching", "disjoint", "b-inside-a"}},
      {Kind::balls, {"overlapping", "a-inside-b"}},
      {Kind::aabbs, {"touching"}},
      {Kind::obbs, {"touching", "equal"}}};
  std::vector<Preset> result;
  for (const auto& [kind, ids] : chosen)
    for (const std::string& id : ids) {
      const Situation& s = *std::ranges::find_if(situations(kind), [&](const Situation& x) { return x.id == id; });
      std::string lower = one(kind);
      for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
      result.push_back(preset_of(name(kind), lower + "-" + s.id, name(kind) + ": " + s.title, s.pose));
    }
  result.push_back(preset_of("balls", "ball-inner-touch", "balls: touching inside", {in_plane(-0.5, 0), 0.5}));
  result.push_back(preset_of(all_kinds, "all-kinds", "all kinds", {in_plane(1.75, 0), 0.75}));
  return result;
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = [] {
    std::vector<std::string> choices;
    for (const Kind kind : kinds) choices.push_back(name(kind));
    choices.emplace_back(all_kinds);
    std::vector<std::string> turned = choices;
    std::erase_if(turned,
                  [](const std::string& kind) { return kind == name(Kind::balls) || kind == name(Kind::aabbs); });
    return Lesson{
        .id = "relations",
        .title = "How two sets are related",
        .rows = "N02",
        .summary = "Six relations between two sets, and what a yes-or-no test loses.",
        .parameters = {choice("kind", "kind", "What the two sets are.", choices),
                       vector("b", "**b**", "The position of b, in units; a stays at the origin.", Vec3(0, 0, 0)),
                       {"size", "size of b", "The size of b, relative to a.", 1.0, 0.0625, 64, 0.25, 2},
                       where(
                           "kind", turned,
                           choice("turn", "turn of b", "The rotation of b; balls and AABBs are not rotated.", turns))},
        .group_by = "",
        .presets = presets(),
        .camera = camera,
        .steps = walk,
        .map = &cases(),
        .opening = opening(),
        .closing = &closing(),
        .ideas = {"closed set", "containment"},
        .shared = shared_ideas,
        .query = R"({"kind": "convex_polygons", "a": [[0, 0], [4, 0], [4, 4], [0, 4]],
 "b": [[4, 2], [6, 1], [6, 3]]})",
    };
  }();
  return lesson;
}

}  // namespace isect::lessons::relations_lesson
