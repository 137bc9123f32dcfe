// All cases of two intervals in the plane of one's ends, and the methods side by side.

#include <limits>

#include <isect/methods/interval_interval.h>
#include "lessons/intervals/picture.h"
#include "lessons/shared/opinions.h"

namespace isect::lessons::intervals_lesson {

using namespace viz;

namespace {

enum Case { none, inner, outer, overlap, before, after, touch, same };

int branch(const Parameters& p) {
  const Setup s = setup(p);
  if (empty(s.a) || empty(s.b)) return none;
  switch (s.truth) {
    case Relation::disjoint:
      return s.b.hi < s.a.lo ? before : after;
    case Relation::b_inside_a:
      return inner;
    case Relation::a_inside_b:
      return outer;
    case Relation::overlapping:
      return overlap;
    case Relation::touching:
      return touch;
    case Relation::equal:
      break;
  }
  return same;
}
/// The ends of b in lengths of a, from a's lower end; NaN if a has no length.
Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  const double unit = s.a.lo < s.a.hi ? s.a.hi - s.a.lo : std::numeric_limits<double>::quiet_NaN();
  return {(s.b.lo - s.a.lo) / unit, (s.b.hi - s.a.lo) / unit};
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p);
  Parameters there = p;
  there["b_min"] = s.a.lo + to.x() * (s.a.hi - s.a.lo);
  there["b_max"] = s.a.lo + to.y() * (s.a.hi - s.a.lo);
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*b*_{min}, where *a* runs from 0 to 1",
      "*b*_{max}",
      {-5, -2},
      {5, 3},
      {"b is empty", "b inside a", "a inside b", "overlapping", "b before a", "b after a", "touching", "equal"},
      branch,
      place,
      moved,
      "Each point of the plane is an interval *b*; *a* runs from 0 to 1 on both axes.\n"
      "Below the diagonal *b* ends before it begins: it is empty."};
  return map;
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  Opinions all(says_meet(s.truth != Relation::disjoint));
  all.add("two ends, the note's", says_meet(interval_interval::ends(s.a, s.b)));
  all.add("larger lower, smaller upper end", says_meet(interval_interval::min_max(s.a, s.b)));
  all.add("centres and half-lengths", says_meet(interval_interval::by_middles(s.a, s.b)));
  return all.take();
}

}  // namespace isect::lessons::intervals_lesson
