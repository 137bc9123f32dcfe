// Whether a hit of the line counts for the ray, in words.

#include <fmt/format.h>

#include <isect/orient.h>
#include "lessons/rays/picture.h"

namespace isect::lessons::rays_lesson {

namespace {

/// A sentence on how rounding turned the unit direction; exact.
std::string rounding(const Setup& s) {
  const Vector<double, 2> d = s.d.head<2>();
  const int turned = orient2d({0, 0}, d, s.ray.direction);
  return turned == 0 ? "Here the rounded **u** still points along **d**."
                     : fmt::format(
                           "The rounded unit vector, though, points a little to the {} of **d**: exact "
                           "predicates take **d** as given.",
                           turned > 0 ? "left" : "right");
}

/// Whether the segment's end lies in the wall. False if that end was rounded.
bool ends_in_the_wall(const Setup& s) {
  if (s.extent != "segment" || s.made == Made::unit) return false;
  if (s.made == Made::points) return s.q.x() == s.wall;
  const double end = s.o.x() + s.d.x();
  return end == s.wall && end - s.o.x() == s.d.x() && end - s.d.x() == s.o.x();
}

}  // namespace

std::string verdict_caption(const Setup& s) {
  if (!s.truth.line)
    return s.truth.coplanar ? "**o** lies in the wall, and so does the whole " + s.extent + "."
                            : "**o** does not lie in the wall, so no point of the line does.";
  const double t = *s.truth.line;
  std::string text;
  if (!s.truth.meets)
    text = t < s.ray.range.lo || s.extent != "segment"
               ? "*t* < 0: the wall lies behind **o**. The line meets it, the " + s.extent + " does not."
               : "*t* > *t*_{max}: the segment ends before the wall. Its line goes on, and meets it.";
  else if (ends_in_the_wall(s))
    text = "The segment ends exactly in the wall. Its end belongs to it, so they meet.";
  else if (s.truth.t && s.wall == s.o.x())
    text = "**o** lies in the wall. The range is closed, so *t* = 0 counts.";
  else
    text = t < 0 ? "*t* < 0, and still it counts: a line has every *t*."
                 : "*t* lies in the range, so **r**(*t*) is a common point.";
  return s.made == Made::unit ? text + "\n" + rounding(s) : text;
}

}  // namespace isect::lessons::rays_lesson
