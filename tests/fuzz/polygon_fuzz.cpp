// Any points as a polygon: point location against rational arithmetic by another rule, the hull against its meaning,
// wedges against crossings.

#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <vector>

#include <isect/convex_hull.h>
#include <isect/point_convex_polygon.h>
#include <isect/point_polygon.h>
#include "bench/rational.h"
#include "tests/fuzz/require.h"

namespace {

using namespace isect;
using oracle::Rational;

/// Coordinates from the input's bytes: mostly small integers, some of them an ulp or two off, some arbitrary.
class Source {
 public:
  Source(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool ended() const { return size_ == 0; }
  int byte() { return size_ == 0 ? 0 : (--size_, *data_++); }
  double coordinate() {
    const int how = byte();
    double x = (how % 16) - 8;
    if (how < 160) return x;
    if (how < 224) {
      for (int i = 1 + how % 2; i > 0; --i) x = std::nextafter(x, how % 4 < 2 ? 100 : -100);
      return x;
    }
    if (how < 240) return std::ldexp(x, how < 232 ? -1060 : 1000);
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | static_cast<std::uint64_t>(byte());
    const double any = std::bit_cast<double>(bits);
    return std::isfinite(any) ? any : 0;
  }
  Point<double, 2> point() {
    const double x = coordinate();
    return {x, coordinate()};
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

std::string told(const Point<double, 2>& p, const Ring<double, 2>& ring) {
  std::ostringstream out;
  out << std::hexfloat << p.transpose() << " in";
  for (const Point<double, 2>& v : ring) out << "\n  " << v.transpose();
  return out.str();
}

struct Truth {
  bool on = false;
  int winding = 0;
};

/// The winding number by a ray upwards.
Truth truth(const Point<double, 2>& point, const Ring<double, 2>& ring) {
  Truth t;
  const auto p = oracle::rational(point);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto a = oracle::operator-(oracle::rational(ring[i]), p),
               b = oracle::operator-(oracle::rational(ring[(i + 1) % ring.size()]), p);
    const Rational cross = a[0] * b[1] - a[1] * b[0], dot = a[0] * b[0] + a[1] * b[1];
    if (cross == 0 && dot <= 0) t.on = true;
    if ((a[0] > 0) == (b[0] > 0)) continue;
    const int leftwards = a[0] > 0 ? 1 : -1;  // counter-clockwise edges above the point go to the left
    if (sign(cross) == leftwards) t.winding += leftwards;
  }
  return t;
}

Location where(bool on, bool inside) { return on ? Location::on : inside ? Location::in : Location::out; }

void check_location(const Point<double, 2>& p, const Ring<double, 2>& ring) {
  const Truth t = truth(p, ring);
  const Winding w = winding(p, ring);
  require(w.even_odd == where(t.on, t.winding % 2 != 0), "even-odd", told(p, ring));
  require(w.nonzero == where(t.on, t.winding != 0), "non-zero", told(p, ring));
  require(t.on || w.winding == t.winding, "winding number", told(p, ring));
}

void check_hull(const Point<double, 2>& p, const Ring<double, 2>& points) {
  const Ring<double, 2> hull = convex_hull(points);
  require(hull.empty() == points.empty(), "a hull of something", told(p, points));
  for (std::size_t i = 0; hull.size() > 2 && i < hull.size(); ++i)
    require(orient2d(hull[i], hull[(i + 1) % hull.size()], hull[(i + 2) % hull.size()]) == 1, "strict vertices",
            told(p, points));
  for (const Point<double, 2>& v : points)
    require(locate(v, hull) != Location::out, "every point in its hull", told(v, points));

  const auto convex = make_convex(hull);
  require(convex.has_value() == (hull.size() > 2), "a hull is convex", told(p, points));
  if (convex) require(locate(p, *convex) == locate(p, hull), "wedges as crossings", told(p, hull));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Source source(data, size);
  const Point<double, 2> p = source.point();
  Ring<double, 2> ring;
  while (!source.ended() && ring.size() < 60) ring.push_back(source.point());
  check_location(p, ring);
  check_hull(p, ring);
  for (std::size_t i = 0; i < ring.size(); i += 7) check_location(ring[i], ring);
  return 0;
}
