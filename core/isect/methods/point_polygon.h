#pragma once
// Point in polygon by the note's crossings and winding number, and by two more usual forms of the crossings, in plain
// floating point: what is taught and compared. `locate` in isect/point_polygon.h is right for all input.
//
// Each form of the crossings says whether an odd number of edges crosses the ray to the right; anything for points on
// the boundary. Naive: rounding may decide near an edge.

#include <variant>

#include <isect/point_polygon.h>

namespace isect::point_polygon {

struct Straddles {
  int index;
  bool holds;  ///< whether the ends of the edge lie on different sides of the line
};
/// Where an edge meets the line, and whether that is on the right of the point.
template <class S>
struct CrossesAt {
  int index;
  S x;
  bool holds;
};
/// Twice the area of a, b, p: positive on the left of the edge.
template <class S>
struct LeftBy {
  int index;
  S area2;
};
template <class S>
using NaiveEvent = std::variant<Straddles, CrossesAt<S>, LeftBy<S>>;

/// Whether an odd number of edges crosses the ray to the right; anything for points on the boundary. Naive: rounding
/// may decide near an edge. Source: Franklin's PNPOLY.
template <class S, class Trace = NoTrace>
bool crossings_naive(const Point<S, 2>& p, const Ring<S, 2>& ring, Trace&& trace = {}) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, 2>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool straddles = (a[1] > p[1]) != (b[1] > p[1]);
    trace(Straddles{static_cast<int>(i), straddles});
    if (!straddles) continue;

    const S x = (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0];
    const bool crosses = p[0] < x;
    trace(CrossesAt<S>{static_cast<int>(i), x, crosses});
    if (crosses) inside = !inside;
  }
  return inside;
}

/// How many times the ring goes around the point, counter-clockwise. Naive: rounding may decide near an edge. Source:
/// D. Sunday, Inclusion of a point in a polygon (2001).
template <class S, class Trace = NoTrace>
int winding_naive(const Point<S, 2>& p, const Ring<S, 2>& ring, Trace&& trace = {}) {
  int winding = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, 2>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool straddles = (a[1] > p[1]) != (b[1] > p[1]);
    trace(Straddles{static_cast<int>(i), straddles});
    if (!straddles) continue;

    const S area2 = (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1]);
    trace(LeftBy<S>{static_cast<int>(i), area2});
    const bool up = b[1] > p[1];
    if (up && area2 > S(0)) ++winding;
    if (!up && area2 < S(0)) --winding;
  }
  return winding;
}

/// The two products, and whether they say that the edge crosses on the right of the point.
template <class S>
struct ProductsCompared {
  int index;
  S first, second;
  bool holds;
};
/// The edge with the point as the origin.
template <class S>
struct EdgeMoved {
  int index;
  Vector<S, 2> a, b;
};
/// Both ends lie on one side of the point: the right if it holds.
struct SideKnown {
  int index;
  bool holds;
};
/// Whether the edge has a point at the height of the point.
struct Reaches {
  int index;
  bool holds;
};
template <class S>
using ClosedEvent = std::variant<Reaches, CrossesAt<S>>;
template <class S>
using FormEvent = std::variant<Straddles, ProductsCompared<S>, EdgeMoved<S>, SideKnown, CrossesAt<S>>;

/// Multiplies out the division of `crossings_naive`. Source: E. Haines, Point in polygon strategies, Graphics Gems IV
/// (1994), the crossings-multiply test.
template <class S, class Trace = NoTrace>
bool crossings_multiplied(const Point<S, 2>& p, const Ring<S, 2>& ring, Trace&& trace = {}) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, 2>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool straddles = (a[1] > p[1]) != (b[1] > p[1]);
    trace(Straddles{static_cast<int>(i), straddles});
    if (!straddles) continue;

    const S first = (b[0] - a[0]) * (p[1] - a[1]), second = (p[0] - a[0]) * (b[1] - a[1]);
    const bool crosses = b[1] > p[1] ? second < first : first < second;
    trace(ProductsCompared<S>{static_cast<int>(i), first, second, crosses});
    if (crosses) inside = !inside;
  }
  return inside;
}

/// Moves the polygon so that the point becomes the origin, and divides only where an edge has its ends on both sides of
/// it. The move rounds each vertex by itself, so that edges may lose the point that lies between them.
/// Source: E. Haines, Essential ray tracing algorithms, in Glassner (ed.), An Introduction to Ray Tracing (1989),
/// ch. 2.
template <class S, class Trace = NoTrace>
bool crossings_translated(const Point<S, 2>& p, const Ring<S, 2>& ring, Trace&& trace = {}) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector<S, 2> a = ring[i] - p, b = ring[i + 1 < ring.size() ? i + 1 : 0] - p;
    trace(EdgeMoved<S>{static_cast<int>(i), a, b});

    const bool straddles = (a[1] > S(0)) != (b[1] > S(0));
    trace(Straddles{static_cast<int>(i), straddles});
    if (!straddles) continue;

    const bool right = a[0] > S(0), known = right == (b[0] > S(0));
    if (known) {
      trace(SideKnown{static_cast<int>(i), right});
      if (right) inside = !inside;
      continue;
    }
    const S x = a[0] - a[1] * (b[0] - a[0]) / (b[1] - a[1]);
    const bool crosses = x > S(0);
    trace(CrossesAt<S>{static_cast<int>(i), x, crosses});
    if (crosses) inside = !inside;
  }
  return inside;
}

/// How many edges meet the ray to the right, each with its ends: what "count the edges that the ray crosses" says when
/// it is read plainly. Wrong by more than rounding: a vertex on the ray counts for both of its edges, and an edge along
/// the ray divides 0 by 0, which compares as false. It is here to be shown beside the half-open rule. Source: the note,
/// N22.
template <class S, class Trace = NoTrace>
int crossings_closed(const Point<S, 2>& p, const Ring<S, 2>& ring, Trace&& trace = {}) {
  int crossings = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, 2>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool reaches = !(a[1] < p[1] && b[1] < p[1]) && !(a[1] > p[1] && b[1] > p[1]);
    trace(Reaches{static_cast<int>(i), reaches});
    if (!reaches) continue;

    const S x = (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0];
    const bool crosses = p[0] < x;
    trace(CrossesAt<S>{static_cast<int>(i), x, crosses});
    if (crosses) ++crossings;
  }
  return crossings;
}

}  // namespace isect::point_polygon
