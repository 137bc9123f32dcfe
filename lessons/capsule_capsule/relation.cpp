// How two capsules lie, in words.

#include <fmt/format.h>

#include "lessons/capsule_capsule/picture.h"

namespace isect::lessons::capsule_capsule_lesson {

std::string because(const Setup& s) {
  switch (s.truth) {
    case Relation::disjoint:
      return "No end comes within *R* of the other segment, and they do not cross.";
    case Relation::touching:
      return s.segments() ? "An end of one lies on the other, and they share no other point."
                          : "An end is exactly *R* away, and none is nearer.";
    case Relation::overlapping:
      if (s.segments()) return "They share a point that is an end of neither.";
      return "They come nearer than *R*, but neither contains the balls at both ends of the other.";
    default:
      return "One capsule contains the balls at both ends of the other. It is convex, so it contains everything "
             "between.";
  }
}

std::string end_caption(const Setup& s) {
  const std::string
      segments = "A capsule of radius 0 is a segment. Its interior, taken along it, is all of it but its ends.\n",
      missed = "\nIf a common point is not a double, methods that compute it may miss it.";
  switch (s.truth) {
    case Relation::disjoint:
      return "The segments are more than *R* apart: a gap is left.\n"
             "The exact test compares squares, multiplied out, so it needs no division and no square root.";
    case Relation::touching:
      if (s.segments()) return segments + "They share one point, and it is an end." + missed;
      return "The distance is exactly *R*: the exact test takes the sign of *d* − *R* without rounding.\n"
             "They share boundary points, and no interior point.";
    case Relation::overlapping:
      if (s.segments()) return segments + "They share such a point, and neither contains the other." + missed;
      return "They share interior points, and neither contains the other.\nWhat they share is marked.";
    case Relation::equal:
      return "Each lies inside the other: they are the same set. The ends may be swapped.";
    default: {
      const char *in = s.truth == Relation::a_inside_b ? "a" : "b", *out = in[0] == 'a' ? "b" : "a";
      return fmt::format(
          "Both ends of {0} lie within *r*_{1} − *r*_{0} of the segment of {1}, so {1} contains their balls.\n"
          "A convex set that contains both contains all between them: {0} lies inside.",
          in, out);
    }
  }
}

}  // namespace isect::lessons::capsule_capsule_lesson
