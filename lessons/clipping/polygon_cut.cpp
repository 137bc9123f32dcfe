// A polygon against a box, one side of it: which vertices go, and which are new.

#include <fmt/format.h>

#include <algorithm>

#include <isect/clip_polygon.h>
#include <isect/methods/clip_polygon.h>
#include "lessons/clipping/polygon.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;
using C = Counted<double>;

void PolygonTeller::cut(const Side& side) {
  Cut cut = {side, known_.ring, {}, {}};
  Ring<C, 2> wide;
  for (const Point<double, 2>& v : known_.ring) wide.push_back(v.cast<C>());
  const Plane<double, 2> plane = half_plane(side, box_);
  Record<clip_polygon::Event<C, 2>> record;
  const Ring<C, 2> rest =
      clip_polygon::sutherland_hodgman(wide, Plane<C, 2>{plane.normal.cast<C>(), C(plane.d)}, record);
  for (const auto& event : record.events) {
    if (const auto* e = std::get_if<clip_polygon::Side>(&event)) cut.signs.push_back(e->sign);
    if (const auto* e = std::get_if<clip_polygon::Crossing<C, 2>>(&event))
      cut.fresh.push_back({e->point[0].value, e->point[1].value});
  }
  known_.ring.clear();
  for (const Point<C, 2>& v : rest) known_.ring.push_back({v[0].value, v[1].value});

  const auto out = std::ranges::count_if(cut.signs, [](int sign) { return sign < 0; });
  script_.count(tally());
  script_.value("vertices", static_cast<double>(known_.ring.size()));
  script_.value("removed", static_cast<double>(out), {}, Role::miss);
  script_.value("new", static_cast<double>(cut.fresh.size()), {}, Role::hit);
  Step& step = script_.add(std::string("side-") + (side.upper ? "upper-" : "lower-") + "xy"[side.axis],
                           "Cut at " + name_of(side), line_of(cut), caption(out, cut),
                           fmt::format("{} − {} + {} = {}", cut.before.size(), out, cut.fresh.size(),
                                       plural(static_cast<long long>(known_.ring.size()), "vertex")));
  step.decides = true;
  step.scene = picture(known_, &cut);
  const auto before = static_cast<double>(cut.before.size()), added = static_cast<double>(cut.fresh.size());
  step.question = which_count("How many vertices are left after the cut at " + name_of(side) + "?",
                              static_cast<double>(known_.ring.size()),
                              {{before, "That is the count before the cut."},
                               {before - static_cast<double>(out), "That leaves out the new vertices, on the side."},
                               {before + added, "That keeps the vertices beyond the side."},
                               {added, "That counts the new vertices alone."}},
                              "Outside vertices are removed; each crossing edge adds one.");
  Rest untouched = known_;
  untouched.ring = cut.before;
  step.question->over = picture(untouched);
  add_side(side, box_, *step.question->over);
}

int PolygonTeller::line_of(const Cut& cut) const { return known_.ring.empty() ? 6 : cut.fresh.empty() ? 4 : 5; }

std::string PolygonTeller::caption(std::int64_t out, const Cut& cut) const {
  if (known_.ring.empty()) return "All that was left lies beyond this side. Nothing remains.";
  if (out == 0) return "No vertex lies beyond this side, so it cuts nothing off.";
  if (cut.fresh.empty())
    return "The vertices beyond are removed. No edge passes strictly from one side to the other, so none is added.";
  return "Walk around the ring. Vertices beyond the side are removed (large rings).\n"
         "Each edge that passes from one side to the other adds one (ring).";
}

}  // namespace isect::lessons::clipping_lesson
