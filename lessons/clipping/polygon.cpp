// A polygon against a box: what comparisons tell, the sides in turn, and what is kept in the end.

#include "lessons/clipping/polygon.h"

#include <fmt/format.h>

#include <isect/clip_polygon.h>
#include <isect/clip_segment.h>
#include <isect/point_convex_polygon.h>
#include <isect/point_polygon.h>
#include <isect/segment_segment.h>
#include "lessons/shared/line_question.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

namespace {

/// Whether two edges run along each other.
bool has_bridges(const Ring<double, 2>& ring) {
  const auto edge = [&](std::size_t i) { return Segment<double, 2>{ring[i], ring[(i + 1) % ring.size()]}; };
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = i + 1; j < ring.size(); ++j)
      if (intersect(edge(i), edge(j)).relation == segment_segment::Meeting::overlap) return true;
  return false;
}

/// Whether some edge meets the box, or the box lies in the polygon; exact.
bool share_a_point(const Ring<double, 2>& ring, const Box& box) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (isect::clip(Segment<double, 2>{ring[i], ring[(i + 1) % ring.size()]}, box)) return true;
  return winding(box.lo, ring).even_odd != Location::out;
}

/// The number of different vertices in the method's result; 0 if polygon and box share no point (only bridges).
std::size_t count_kept(const Ring<double, 2>& ring, const Box& box, const Ring<double, 2>& returned) {
  if (!share_a_point(ring, box)) return 0;
  Ring<double, 2> different;
  for (const Point<double, 2>& v : returned)
    if (!among(different, v)) different.push_back(v);
  return different.size();
}

std::string shared(std::size_t kept) {
  return kept == 0   ? "No part of it lies in the box."
         : kept == 1 ? "They share one point."
         : kept == 2 ? "They share a segment."
                     : fmt::format("The part in the box has {} vertices.", kept);
}

}  // namespace

PolygonTeller::PolygonTeller(const Ring<double, 2>& ring, const Box& box)
    : box_(box),
      truth_(isect::clip(ring, box)),
      kept_(count_kept(ring, box, truth_)),
      script_({"Lecture note, uses of intersection detection; Sutherland and Hodgman, Communications of the ACM 17 "
               "(1974)",
               fmt::format("A polygon of {} vertices and a box. {}", ring.size(), shared(kept_)),
               {
                   "if all vertices lie in the box: return the polygon",              // 0
                   "if all lie beyond one and the same side",                         // 1
                   "    return NONE",                                                 // 2
                   "for each side of the box",                                        // 3
                   "    keep the vertices that are not beyond it",                    // 4
                   "    add the points where edges pass from one side to the other",  // 5
                   "    if none is left: return NONE",                                // 6
                   "return the polygon"                                               // 7
               },
               "a polygon"}),
      known_{ring, box, ring} {}

Walk PolygonTeller::tell() {
  script_.value("vertices", static_cast<double>(known_.ring.size()));
  if (!trivial()) {
    add_sides();
    tally() = {};
    for (const int axis : {0, 1})
      for (const bool upper : {false, true})
        if (!known_.ring.empty()) cut({axis, upper});
  }
  end();
  return std::move(script_.walk());
}

bool PolygonTeller::trivial() {
  int all = ~0, any = 0;
  for (const Point<double, 2>& v : known_.ring) {
    const int code = clip_segment::outcode(v, box_);
    all &= code, any |= code;
  }
  trivial_ = any == 0 || all != 0;
  if (any != 0) script_.refuse(0, {});
  if (!trivial_) script_.refuse(1, {2});
  Step& step =
      script_.add("trivial", "A trivial answer?",
                  any == 0   ? 0
                  : all != 0 ? 2
                             : 1,
                  any == 0   ? "All vertices lie in the box. The box is convex, so it contains the whole polygon."
                  : all != 0 ? "All vertices lie beyond the same side, so the whole polygon does."
                             : "Some vertices lie outside, but not all beyond one side. So the polygon must be cut.");
  step.decides = true;
  step.scene = picture(known_);
  ask_for_line(
      script_.walk(),
      "Lines 1 to 3 need no more than comparisons of the vertices with the sides. Which of them runs last?",
      {{0, "Not all vertices lie in the box, so the test goes on."},
       {1, any == 0 ? "All vertices lie in the box: line 1 has returned."
                    : "All vertices lie beyond one side, so its condition holds. The line below it runs, too."},
       {2, any == 0 ? "All vertices lie in the box: line 1 has returned."
                    : "No side has all vertices beyond it, so nothing is returned yet."}},
      any == 0   ? "No vertex lies beyond a side, so the first line returns the polygon."
      : all != 0 ? "One side has all vertices beyond it."
                 : "The condition of line 2 is asked, and does not hold. So the polygon must be cut.");
  if (trivial_) script_.leave_early();
  if (all != 0) known_.ring.clear();
  return trivial_;
}

void PolygonTeller::add_sides() {
  Step& step =
      script_.add("sides", "Side after side", 3,
                  "A box is the intersection of four half-planes. So four simple cuts do the work of one hard one.\n"
                  "Each takes the ring that the one before has left.\n"
                  "Compute each crossing from the edge's inner to its outer end: so neighbours that share an edge get "
                  "the same point, rounding and all.");
  step.scene = picture(known_);
  const Point<double, 2>&lo = box_.lo, &hi = box_.hi;
  const double more = 0.625;
  for (const bool upper : {false, true}) {
    const double x = upper ? hi.x() : lo.x(), y = upper ? hi.y() : lo.y();
    step.scene.items.emplace_back(
        Line{{x, lo.y() - more, 0}, {x, hi.y() + more, 0}, Role::construction, Pen::construction});
    step.scene.items.emplace_back(
        Line{{lo.x() - more, y, 0}, {hi.x() + more, y, 0}, Role::construction, Pen::construction});
  }
}

void PolygonTeller::end() {
  known_.settled = true;
  astray_ = known_.ring.empty() != truth_.empty();
  const bool none = known_.ring.empty();
  if (known_.ring.empty() == truth_.empty()) known_.ring = truth_;
  const std::size_t n = kept_;
  bridges_ = n == 0 && !truth_.empty();
  script_.forget({"removed", "new"});  // which were of the last cut
  script_.value("vertices", static_cast<double>(n), {}, n > 0 ? Role::hit : Role::muted);
  script_.settle(n == 0  ? Verdict::Kind::no
                 : n < 3 ? Verdict::Kind::on
                         : Verdict::Kind::yes,
                 n == 0   ? "nothing is kept"
                 : n == 1 ? "one point is kept"
                 : n == 2 ? "a segment is kept"
                          : fmt::format("kept: {} vertices", n));
  const int line = trivial_ ? script_.walk().steps.back().line : none ? 6 : 7;
  script_.add("kept", n == 0 ? "Nothing is kept" : "What is kept", line, end_caption(n)).scene = picture(known_);
}

std::string PolygonTeller::end_caption(std::size_t n) const {
  if (astray_) return "Rounding makes the four cuts wrong here: the exact test says otherwise.";
  if (bridges_)
    return "The polygon is not convex, and it misses the box. The method returns nothing but zero-width bridges "
           "along "
           "the sides.";
  if (n == 0)
    return trivial_ ? "Comparisons were enough: no vertex was computed."
                    : "No single side has all vertices beyond it, yet the polygon misses the box.\n"
                      "Only the four cuts together show that.";
  if (trivial_ && n < 3) return "The polygon has no area: some of its vertices coincide. It is kept as it is.";
  if (n < 3)
    return "The polygon and the box share points, but no area. The sets are closed, so they intersect.\n"
           "A renderer may drop it; a test for contact must not.";
  if (trivial_) return "No edge was cut, so the polygon is kept as it is.";
  if (has_bridges(known_.ring))
    return "The polygon is not convex, and what is kept falls into parts.\n"
           "The method returns one ring: zero-width bridges along the clip side join the pieces.\n"
           "For one polygon each, cut it into convex parts first, or clip by Weiler and Atherton or Greiner and "
           "Hormann.\n"
           "If it is only filled, bridges do no harm: they have no area.";
  if (!make_convex(known_.original))
    return "The polygon is not convex, so the cuts might have left several parts. Here they leave one.";
  return fmt::format("A convex polygon of {} vertices and four sides: at most {} vertices can be left, here {}.",
                     known_.original.size(), known_.original.size() + 4, n);
}

Walk clip_a_polygon(const Ring<double, 2>& ring, const Box& box) { return PolygonTeller(ring, box).tell(); }

}  // namespace isect::lessons::clipping_lesson
