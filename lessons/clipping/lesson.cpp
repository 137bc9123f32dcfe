// Clipping (N01): a segment by a range of t that narrows, a polygon by one cut a side; both against a box.
//
// The walks stand in clipping/segment, clipping/reciprocals and clipping/polygon.

#include <isect/clip_segment.h>
#include <isect/methods/clip_segment.h>
#include <isect/methods/ray_aabb.h>
#include "lessons/clipping/picture.h"
#include "lessons/course.h"
#include "lessons/shared/opinions.h"
#include "lessons/shared/parameters.h"

namespace isect::lessons::clipping_lesson {

namespace {

using namespace viz;

struct Situation {
  const char* id;
  const char* title;
  std::array<Point<double, 2>, 4> points;  ///< p, q, and for a polygon r, s
};

const Situation segments[] = {
    {"both-ends-cut", "both ends cut", {{{-3, -2}, {3.5, 2}, {0, 2}, {-3, 1}}}},
    {"one-end-cut", "one end cut", {{{-1, 0.5}, {3, -1.5}, {0, 2}, {-3, 1}}}},
    {"inside", "inside", {{{-1.5, -0.75}, {1.5, 0.75}, {0, 2}, {-3, 1}}}},
    {"beyond-one-side", "beyond one side", {{{-2, 1.5}, {3, 2}, {0, 2}, {-3, 1}}}},
    {"past-a-corner", "past a corner", {{{0.75, 2.25}, {3.5, 0.25}, {0, 2}, {-3, 1}}}},
    {"at-a-corner", "touching a corner", {{{1, 2}, {3, 0.5}, {0, 2}, {-3, 1}}}},
    {"along-a-side", "along a side", {{{-3, 1.25}, {1, 1.25}, {0, 2}, {-3, 1}}}},
};
const Situation slabs[] = {
    {"slabs", "both ends cut", {{{-3, -2}, {3.5, 2}, {0, 2}, {-3, 1}}}},
    {"slabs-bottom", "along the bottom", {{{-3, -1.25}, {1, -1.25}, {0, 2}, {-3, 1}}}},
    {"slabs-top", "along the top", {{{-3, 1.25}, {1, 1.25}, {0, 2}, {-3, 1}}}},
};
const Situation exchanged[] = {
    {"slabs-bottom-exchanged", "bottom, exchanged", {{{-3, -1.25}, {1, -1.25}, {0, 2}, {-3, 1}}}},
    {"slabs-left-exchanged", "left, exchanged", {{{-2, -2}, {-2, 1}, {0, 2}, {-3, 1}}}},
};
const Situation polygons[] = {
    {"cut", "cut", {{{-1.5, -2}, {3.25, -0.75}, {1, 2}, {-3, 0.5}}}},
    {"polygon-inside", "inside", {{{-0.5, -1}, {1.5, -0.5}, {1, 1}, {-1.5, 0.5}}}},
    {"polygon-beyond", "beyond one side", {{{2.25, -1}, {3.5, -0.5}, {3.25, 1}, {2.5, 1.5}}}},
    {"polygon-past-a-corner", "past a corner", {{{3.5, 0.25}, {3.5, 1.25}, {2, 2.25}, {0.75, 2.25}}}},
    {"around", "around the box", {{{-2.75, -1.75}, {2.5, -2}, {3, 1.75}, {-2.5, 2}}}},
    {"polygon-at-a-corner", "touching a corner", {{{2, 1.25}, {3.25, 0.75}, {3.25, 2.25}, {1.5, 2.25}}}},
    {"polygon-along-a-side", "along a side", {{{2, -0.5}, {3.25, -1}, {3.25, 1}, {2, 0.75}}}},
    {"concave", "not convex", {{{0.25, -1.125}, {2.25, 0}, {0.25, 1.125}, {3.75, 0}}}},
};

Preset preset_of(const Situation& s, const std::string& shape, const std::string& first = "range") {
  Parameters values = {{"shape", shape}, {"first", first}};
  for (int i = 0; i < 4; ++i) values[std::string(1, "pqrs"[i])] = flat(s.points[i]);
  return {s.id, s.title, shape, values};
}

std::vector<Preset> presets() {
  std::vector<Preset> all;
  for (const Situation& s : segments) all.push_back(preset_of(s, "segment"));
  for (const Situation& s : slabs) all.push_back(preset_of(s, "slabs"));
  for (const Situation& s : exchanged) all.push_back(preset_of(s, "slabs", "slab"));
  for (const Situation& s : polygons) all.push_back(preset_of(s, "polygon"));
  return all;
}

Parameter vertex(const char* name, const char* help, int index) {
  return vector(name, std::string("**") + name + "**", help, flat(polygons[0].points[index]));
}

/// A corner of the box, absent until it is moved.
Parameter corner(const char* name, const char* label, const char* help, const Point<double, 2>& initial) {
  Parameter p = vector(name, label, help, flat(initial));
  p.optional = true;
  return p;
}

/// Requires that the box has an area, where the setting has this corner: it is to blame.
Condition with_area(const std::string& name, const char* allowed) {
  return {name, allowed, [name](const Parameters& values) {
            const Box box = box_of(values);
            return !values.contains(name) || (box.lo.array() < box.hi.array()).all();
          }};
}

bool is(const Parameters& values, const char* shape) { return std::get<std::string>(values.at("shape")) == shape; }

Walk walk(const Parameters& values) {
  const auto at = [&](const char* name) { return flat_point(values, name); };
  const Box box = box_of(values);
  if (is(values, "segment")) return clip_a_segment({at("p"), at("q")}, box);
  if (is(values, "slabs"))
    return clip_by_reciprocals({at("p"), at("q")}, box, std::get<std::string>(values.at("first")) == "range");
  return clip_a_polygon({at("p"), at("q"), at("r"), at("s")}, box);
}

/// Whether anything of a segment is kept.
std::vector<Opinion> opinions(const Parameters& values) {
  if (is(values, "polygon")) return {};
  const Segment<double, 2> s = {flat_point(values, "p"), flat_point(values, "q")};
  const Box box = box_of(values);
  const auto says = [](const auto& kept) { return kept ? "a part is kept" : "nothing is kept"; };
  Opinions all(says(clip(s, box)));
  all.add("Liang and Barsky", says(clip_segment::liang_barsky(s, box)));
  all.add("slabs, min and max", says(ray_aabb::by_min_max(segment(s.p, s.q), box)));
  if (is(values, "slabs"))
    all.add("slabs, min and max exchanged", says(ray_aabb::by_min_max_exchanged(segment(s.p, s.q), box)));
  all.add("slabs, by sign", says(ray_aabb::by_sign(segment(s.p, s.q), box)));
  return all.take();
}

}  // namespace

const Lesson& lesson() {
  static const Lesson lesson = {
      .id = "clipping",
      .title = "Clipping",
      .rows = "N01",
      .summary = "The part of a segment or a polygon that lies in a box: the sides cut it one after another.",
      .parameters = {choice("shape", "shape",
                            "What is clipped at the box: a segment, side by side or slab by slab; or a polygon.",
                            {"segment", "slabs", "polygon"}),
                     where(
                         "shape", {"slabs"},
                         choice("first", "first",
                                "What min and max have as their first argument: the range so far, or the new slab's t.",
                                {"range", "slab"})),
                     vertex("p", "First end or vertex, in world units; its third coordinate is not used.", 0),
                     vertex("q", "Second end or vertex, in world units.", 1),
                     where("shape", {"polygon"}, vertex("r", "Third vertex of the polygon; a segment has none.", 2)),
                     where("shape", {"polygon"}, vertex("s", "Fourth vertex of the polygon; a segment has none.", 3)),
                     corner("b_min", "**b**_{min}", "The lower left corner of the box, where it was moved.",
                            box_of_lesson().lo),
                     corner("b_max", "**b**_{max}", "The upper right corner of the box, where it was moved.",
                            box_of_lesson().hi)},
      .conditions = {with_area("b_max", "a corner to the right of the box’s other one, and above it"),
                     with_area("b_min", "a corner to the left of the box’s other one, and below it")},
      .group_by = "shape",
      .presets = presets(),
      .camera = {.azimuth = 0, .elevation = 0},
      .steps = walk,
      .flat = true,
      .opinions = opinions,
      .map = &cases(),
      .opening = opening(),
      .closing = &closing(),
      .after = {"intervals", "rays", "ray-polygon"},
      .ideas = {"trivial reject", "slab", "half-space"},
      .shared = shared_ideas,
      .query = R"({"kind": "segment_box", "segment": [[-3, 1.25], [1, 1.25]],
 "lo": [-2, -1.25], "hi": [2, 1.25]})",
  };
  return lesson;
}

}  // namespace isect::lessons::clipping_lesson
