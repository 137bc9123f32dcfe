// Do a box and the frustum have a common point? Decided exactly, as a map and a verdict rest on it.
//
// If they do, either the frustum has a point on one of the box's faces, or it lies inside the box with all of its
// points. Each face is clipped by the six planes. Its corners are homogeneous, (x, y, z) / w with w > 0, so that no
// step divides: where the heights over a plane are a > 0 > b, the side from A to B meets it at a B - b A.

#include <isect/numbers/predicate.h>
#include "lessons/culling/picture.h"

namespace isect::lessons::culling_lesson {
namespace {

template <class W>
struct Corner {
  std::array<W, 3> x;
  W w;
};
template <class W>
using Outline = std::vector<Corner<W>>;

/// The height of a corner over n.x + d = 0, in any unit.
template <class W>
W height(const Plane<double, 3>& plane, const Corner<W>& c) {
  const auto n = [&](int axis) { return W(plane.normal[axis]) * c.x[axis]; };
  return n(0) + n(1) + n(2) + W(plane.d) * c.w;
}

/// a B - b A
template <class W>
Corner<W> between(const W& a, const Corner<W>& A, const W& b, const Corner<W>& B) {
  const auto mixed = [&](const W& from, const W& to) { return a * to - b * from; };
  return {{mixed(A.x[0], B.x[0]), mixed(A.x[1], B.x[1]), mixed(A.x[2], B.x[2])}, mixed(A.w, B.w)};
}

/// Finds signs in the arithmetic W, and remembers if one stayed open: then no answer is valid.
template <class W>
class Clipper {
 public:
  bool open() const { return open_; }

  int sign(const W& x) {
    const std::optional<int> s = x.sign();
    open_ = open_ || !s;
    return s.value_or(0);
  }

  /// The part of the outline on the plane's inner side or on the plane.
  Outline<W> clip(const Outline<W>& outline, const Plane<double, 3>& plane) {
    Outline<W> kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Corner<W>&A = outline[i], &B = outline[(i + 1) % outline.size()];
      const W a = height(plane, A), b = height(plane, B);
      const int over = sign(a), next = sign(b);
      if (over >= 0) kept.push_back(A);
      if (over > 0 && next < 0) kept.push_back(between(a, A, b, B));
      if (over < 0 && next > 0) kept.push_back(between(b, B, a, A));
    }
    return kept;
  }

 private:
  bool open_ = false;
};

template <class W>
Outline<W> face(const Box& box, int axis, double at) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Outline<W> outline;
  for (const auto& [on_u, on_v] : {std::pair{box.lo[u], box.lo[v]}, std::pair{box.hi[u], box.lo[v]},
                                   std::pair{box.hi[u], box.hi[v]}, std::pair{box.lo[u], box.hi[v]}}) {
    std::array<double, 3> x{};
    x[axis] = at;
    x[u] = on_u, x[v] = on_v;
    outline.push_back({{W(x[0]), W(x[1]), W(x[2])}, W(1)});
  }
  return outline;
}

/// The frustum's corner on the planes left, bottom and near, by Cramer's rule.
template <class W>
Corner<W> corner(const Frustum<double>& view, Clipper<W>& clipper) {
  const std::array planes = {&view.planes[0], &view.planes[2], &view.planes[4]};
  const auto at = [&](std::size_t plane, int column) {
    return W(column < 3 ? planes[plane]->normal[column] : planes[plane]->d);
  };
  const auto determinant = [&](int i, int j, int k) {
    return at(0, i) * (at(1, j) * at(2, k) - at(1, k) * at(2, j)) -
           at(0, j) * (at(1, i) * at(2, k) - at(1, k) * at(2, i)) +
           at(0, k) * (at(1, i) * at(2, j) - at(1, j) * at(2, i));
  };
  Corner<W> c = {{-determinant(3, 1, 2), -determinant(0, 3, 2), -determinant(0, 1, 3)}, determinant(0, 1, 2)};
  if (clipper.sign(c.w) < 0) c = {{-c.x[0], -c.x[1], -c.x[2]}, -c.w};
  return c;
}

/// Returns nothing where W leaves a sign open.
template <class W>
std::optional<bool> meet_in(const Box& box, const Frustum<double>& view) {
  Clipper<W> clipper;
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {box.lo[axis], box.hi[axis]}) {
      Outline<W> part = face<W>(box, axis, at);
      for (const Plane<double, 3>& plane : view.planes) part = clipper.clip(part, plane);
      if (clipper.open()) return {};
      if (!part.empty()) return true;
    }
  const Corner<W> c = corner(view, clipper);
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    inside = inside && clipper.sign(c.x[axis] - W(box.lo[static_cast<int>(axis)]) * c.w) >= 0 &&
             clipper.sign(W(box.hi[static_cast<int>(axis)]) * c.w - c.x[axis]) >= 0;
  if (clipper.open()) return {};
  return inside;
}

}  // namespace

bool meet(const Box& box, const Frustum<double>& view) {
  if (const std::optional<bool> answer = meet_in<Bounded<double>>(box, view)) return *answer;
  return *meet_in<Exact>(box, view);
}

}  // namespace isect::lessons::culling_lesson
