// Points, polygons and segments in the plane, and many boxes.

#include <isect/convex_hull.h>

#include "app/grade/drawing_numbers.h"

namespace isect::grade {

namespace {

double coordinate(const Numbers& x, int corner, int k) { return x[1 + 2 * static_cast<std::size_t>(corner) + k]; }

/// A polygon alone: how many corners, then they.
Numbers some_polygon(Random& random, Kind kind) {
  Draw draw(random, kind);
  const int count = random.integer(3, 9);
  draw.put({static_cast<double>(count)});
  for (int i = 0; i < count; ++i) {
    if (kind != Kind::ordinary) {
      draw.point(2);
      continue;
    }
    const double angle = 6.283185307179586 * i / count, r = random.uniform(0.3, 1.2);
    draw.put({r * std::cos(angle), r * std::sin(angle)});
  }
  return draw.x;
}
Numbers convex_outline(Random& random, Kind kind) {
  for (;;) {
    std::vector<Point<double, 2>> points;
    for (int i = random.integer(3, 12); i > 0; --i) {
      Draw draw(random, kind);
      draw.point(2);
      points.emplace_back(draw.x[0], draw.x[1]);
    }
    const Ring<double, 2> hull = convex_hull(std::span<const Point<double, 2>>(points));
    if (hull.size() < 3) continue;
    Numbers x = {static_cast<double>(hull.size())};
    for (const Point<double, 2>& p : hull) x.insert(x.end(), {p[0], p[1]});
    return x;
  }
}

template <Numbers (*polygon)(Random&, Kind)>
Numbers polygon_and_point(Random& random, Kind kind) {
  Numbers x = polygon(random, kind);
  Draw draw(random, kind);
  draw.point(2), draw.x.insert(draw.x.begin(), x.begin(), x.end());
  return draw.x;
}
/// At a corner, the middle of an edge, or a little beside it.
template <Numbers (*polygon)(Random&, Kind)>
Numbers on_an_edge(Random& random) {
  Numbers x = polygon(random, Kind::grid);
  const int count = static_cast<int>(x[0]), i = random.below(count), j = (i + 1) % count;
  const double part = 0.25 * random.integer(0, 4);
  for (int k = 0; k < 2; ++k) x.push_back(coordinate(x, i, k) + part * (coordinate(x, j, k) - coordinate(x, i, k)));
  if (random.one_in(3)) x.back() = beside(x.back(), random.integer(-1, 1));
  return x;
}
/// Draws a point as high as a corner: a level ray from it passes through that corner.
template <Numbers (*polygon)(Random&, Kind)>
Numbers level_with_a_corner(Random& random) {
  Numbers x = polygon(random, random.one_in(2) ? Kind::grid : Kind::ordinary);
  const int count = static_cast<int>(x[0]);
  const double y = coordinate(x, random.below(count), 1);
  x.insert(x.end(), {random.uniform(-1, 1), y});
  return x;
}
/// Beside an edge of ordinary numbers, by no more than rounding.
template <Numbers (*polygon)(Random&, Kind)>
Numbers beside_an_edge(Random& random) {
  Numbers x = polygon(random, Kind::ordinary);
  const int count = static_cast<int>(x[0]), i = random.below(count), j = (i + 1) % count;
  const double part = random.unit();
  for (int k = 0; k < 2; ++k) x.push_back(coordinate(x, i, k) + part * (coordinate(x, j, k) - coordinate(x, i, k)));
  return x;
}

Numbers some_points(Random& random, Kind kind) {
  Draw draw(random, kind);
  const int count = random.integer(3, 20);
  draw.put({static_cast<double>(count)}), draw.point(2 * count);
  return draw.x;
}
Numbers points_on_one_line(Random& random) {
  const int count = random.integer(2, 12), dx = random.integer(-3, 3), dy = random.integer(-3, 3);
  Numbers x = {static_cast<double>(count)};
  const bool tenths = random.one_in(2);  // on one line but for rounding
  for (int i = 0; i < count; ++i) {
    const int at = random.integer(-9, 9);
    x.insert(x.end(), {tenths ? 0.1 * (at * dx) : at * dx, tenths ? 0.1 * (at * dy) : at * dy});
  }
  return x;
}
Numbers equal_points(Random& random) {
  const int count = random.integer(1, 9), kinds = random.integer(1, 3);
  Numbers some = some_points(random, Kind::grid), x = {static_cast<double>(count)};
  for (int i = 0; i < count; ++i) {
    const int from = random.below(kinds);
    x.insert(x.end(), {coordinate(some, from, 0), coordinate(some, from, 1)});
  }
  return x;
}
Numbers points_on_a_square(Random& random) {
  const int count = random.integer(4, 20);
  Numbers x = {static_cast<double>(count)};
  for (int i = 0; i < count; ++i) {
    double p[2] = {static_cast<double>(random.integer(-3, 3)), random.one_in(2) ? 3.0 : -3.0};
    if (random.one_in(2)) std::swap(p[0], p[1]);
    x.insert(x.end(), {p[0], p[1]});
  }
  return x;
}

Numbers segment_and_box(Random& random, Kind kind) {
  Draw draw(random, kind);
  draw.point(4), draw.box(2);
  return draw.x;
}
Numbers along_an_edge(Random& random) {
  Numbers x = segment_and_box(random, Kind::grid);
  const int k = random.below(2);
  x[k] = x[2 + k] = x[(random.one_in(2) ? 4 : 6) + k];
  if (random.one_in(3)) x[k] = x[2 + k] = beside(x[k], random.integer(-1, 1));
  return x;
}
Numbers at_a_corner(Random& random) {
  Numbers x = segment_and_box(random, Kind::grid);
  const double corner[2] = {x[random.one_in(2) ? 4 : 6], x[random.one_in(2) ? 5 : 7]};
  const int dx = random.integer(-4, 4), dy = random.integer(-4, 4), after = random.integer(0, 1);
  x[0] = corner[0] - dx, x[1] = corner[1] - dy, x[2] = corner[0] + after * dx, x[3] = corner[1] + after * dy;
  return x;
}
Numbers point_as_segment(Random& random) {
  Numbers x = segment_and_box(random, Kind::grid);
  x[2] = x[0], x[3] = x[1];
  return x;
}
Numbers segment_within(Random& random) {
  Numbers x = segment_and_box(random, Kind::ordinary);
  for (int i = 0; i < 4; ++i) x[i] = random.uniform(x[4 + i % 2], x[6 + i % 2]);
  return x;
}

Numbers two_convex(Random& random, Kind kind) {
  Numbers x = convex_outline(random, kind);
  const Numbers other = convex_outline(random, kind);
  const double away = kind == Kind::ordinary ? random.uniform(0, 2) : 0;
  const std::size_t first = x.size() + 1;
  x.insert(x.end(), other.begin(), other.end());
  for (std::size_t i = first; i < x.size(); i += 2) x[i] += away;
  return x;
}
/// A corner of b is put onto a corner of a, or onto the middle of an edge.
Numbers corner_to_corner(Random& random) {
  const Numbers a = convex_outline(random, Kind::grid);
  Numbers b = convex_outline(random, Kind::grid);
  const int i = random.below(static_cast<int>(a[0])), j = random.one_in(2) ? i : (i + 1) % static_cast<int>(a[0]),
            corner = random.below(static_cast<int>(b[0]));
  double shift[2];
  for (int k = 0; k < 2; ++k) shift[k] = (coordinate(a, i, k) + coordinate(a, j, k)) / 2 - coordinate(b, corner, k);
  if (random.one_in(4)) shift[0] += 0.25;
  for (std::size_t n = 1; n < b.size(); ++n) b[n] += shift[(n - 1) % 2];
  Numbers x = a;
  x.insert(x.end(), b.begin(), b.end());
  return x;
}
Numbers one_polygon_within(Random& random) {
  Numbers x = convex_outline(random, Kind::ordinary), small = x;
  double middle[2] = {0, 0};
  const int count = static_cast<int>(x[0]);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 2; ++k) middle[k] += coordinate(x, i, k) / count;
  for (std::size_t n = 1; n < small.size(); ++n) small[n] = middle[(n - 1) % 2] + (small[n] - middle[(n - 1) % 2]) / 4;
  if (random.one_in(2)) x.swap(small);
  Numbers both = x;
  both.insert(both.end(), small.begin(), small.end());
  return both;
}

Numbers some_boxes(Random& random, Kind kind) {
  Draw draw(random, kind);
  const int count = random.integer(1, 12);
  draw.put({static_cast<double>(count)});
  for (int i = 0; i < count; ++i) {
    if (kind != Kind::ordinary) {
      draw.box(3);
      continue;
    }
    draw.point(3);
    for (int k = 0; k < 3; ++k) draw.put({draw.x[draw.x.size() - 3] + random.uniform(0.05, 0.6)});
  }
  return draw.x;
}
Numbers boxes_in_a_row(Random& random) {
  const int count = random.integer(2, 10), along = random.below(3);
  Numbers x = {static_cast<double>(count)};
  double at = 0;
  for (int i = 0; i < count; ++i) {
    Numbers lo = {0, 0, 0}, hi = {1, 1, 1};
    lo[along] = at, hi[along] = at = at + 0.1 * random.integer(1, 9);
    if (random.one_in(4)) at = beside(at, 1);
    x.insert(x.end(), lo.begin(), lo.end()), x.insert(x.end(), hi.begin(), hi.end());
  }
  return x;
}
Numbers equal_boxes(Random& random) {
  Numbers x = some_boxes(random, Kind::grid);
  for (std::size_t i = 13; i < x.size(); i += 12) std::copy_n(x.begin() + 1, 6, x.begin() + static_cast<long>(i));
  return x;
}

}  // namespace

std::vector<Family> polygon_families(const std::string& task) {
  if (task == "crossings")
    return with_own(
        of_all_numbers<polygon_and_point<some_polygon>>(),
        {{"on an edge", "points on edges and corners, or an ulp beside", on_an_edge<some_polygon>},
         {"level with a corner", "a level ray from the point meets a corner", level_with_a_corner<some_polygon>},
         {"beside an edge", "points off an edge by rounding alone", beside_an_edge<some_polygon>}});
  if (task == "convex-polygon")
    return with_own(
        of_all_numbers<polygon_and_point<convex_outline>>(),
        {{"on an edge", "points on edges and corners, or an ulp beside", on_an_edge<convex_outline>},
         {"level with a corner", "a level ray from the point meets a corner", level_with_a_corner<convex_outline>},
         {"beside an edge", "points off an edge by rounding alone", beside_an_edge<convex_outline>}});
  if (task == "hull")
    return with_own(of_all_numbers<some_points>(),
                    {{"on a square", "many points on each edge", points_on_a_square},
                     {"on one line", "points on one line, or off it by rounding", points_on_one_line},
                     {"degenerate", "equal points", equal_points}});
  if (task == "clip-segment")
    return with_own(of_all_numbers<segment_and_box>(),
                    {{"along an edge", "the segment runs along an edge of the box", along_an_edge},
                     {"at a corner", "the segment goes to a corner, or through it", at_a_corner},
                     {"within", "both ends lie in the box", segment_within},
                     {"degenerate", "segments that are points", point_as_segment}});
  if (task == "sat-polygons")
    return with_own(of_all_numbers<two_convex>(),
                    {{"touching", "a corner at a corner or an edge", corner_to_corner},
                     {"one within the other", "a small polygon in a large one", one_polygon_within}});
  if (task == "all-pairs")
    return with_own(of_all_numbers<some_boxes>(),
                    {{"touching in a row", "each box touches the next, or misses it by an ulp", boxes_in_a_row},
                     {"degenerate", "many equal boxes", equal_boxes}});
  return {};
}

}  // namespace isect::grade
