#include "tests/proof/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace isect::proof {

const char* name(Family f) {
  static constexpr const char* names[] = {"grid",      "tenths", "beside", "flat",     "large",     "small",
                                          "subnormal", "mixed",  "nested", "restated", "thresholds"};
  return names[static_cast<int>(f)];
}

namespace {

using Place = std::array<double, 3>;
using Places = std::vector<Place>;

class Drawing {
 public:
  Drawing(std::mt19937_64& random, Drawn& out) : random_(random), out_(out), flat_(out.flat) {
    if (out.family == Family::mixed) {
      size_ = 1;
    } else if (out.family == Family::large) {
      size_ = one_of(std::vector{1e299, 0x1p900, 0x1p520, 1e154});
    } else if (out.family == Family::small) {
      size_ = one_of(std::vector{1e-300, 0x1p-900, 0x1p-520, 1e-160});
    } else if (out.family == Family::subnormal) {
      size_ = std::numeric_limits<double>::denorm_min() * one_of(std::vector{1., 2., 1024.});
    }
  }

  void objects(int count) {
    for (int i = 0; i < count; ++i) {
      const std::string called(1, static_cast<char>('A' + i));
      const int before = static_cast<int>(out_.objects.size());
      const bool again = before > 0 && chance(out_.family == Family::restated ? 0.6 : 0.1);
      Json o = again ? restated(out_.objects[static_cast<std::size_t>(whole(0, before - 1))]) : object();
      if (o.is_null()) o = object();
      o.begin().value() = called;
      collect(o);
      out_.objects.push_back(o);
    }
  }

 private:
  int whole(int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(random_) < p; }
  template <class T>
  T one_of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(whole(0, static_cast<int>(all.size()) - 1))];
  }
  int dimension() const { return flat_ ? 2 : 3; }

  /// The coordinate with the size of the family.
  double sized(double x) {
    switch (out_.family) {
      case Family::tenths:
        return std::round(x * 10) / 10;
      case Family::beside:
        return chance(0.15) ? std::nextafter(x, chance(0.5) ? 9 : -9) : x;
      case Family::mixed:
        return x * one_of(std::vector{1., 1., 1e299, 1e-300, 5e-324, 0x1p500, 0x1p-500});
      default:
        return x * size_;
    }
  }
  double coordinate() {
    const double x = out_.family == Family::tenths ? whole(-30, 30) / 10. : whole(-3, 3);
    return sized(x);
  }
  double length() {
    if (out_.family == Family::flat && chance(0.6)) return 0;
    return std::abs(coordinate());
  }

  Place place() {
    Place p = {};
    if (!pool_.empty() && chance(0.4)) {
      p = one_of(pool_);
      if (chance(0.3)) {
        const Place q = one_of(pool_);
        for (int i = 0; i < 3; ++i) p[i] = p[i] / 2 + q[i] / 2;
      } else if (chance(0.2)) {
        const Place q = one_of(pool_), r = one_of(pool_);
        for (int i = 0; i < 3; ++i) p[i] += q[i] - r[i];
      } else if (chance(0.3)) {
        p[whole(0, dimension() - 1)] = coordinate();
      }
    } else {
      for (int i = 0; i < dimension(); ++i)
        p[i] = out_.family == Family::nested ? center_[i] + scale_ * coordinate() : coordinate();
    }
    for (double& x : p) x = std::clamp(x, -1e300, 1e300);
    return p;
  }
  double extent() { return out_.family == Family::nested ? scale_ * length() : length(); }

  Json list(const Place& p) const {
    Json all = {p[0], p[1]};
    if (!flat_) all.push_back(p[2]);
    return all;
  }
  Json list(const Places& all) const {
    Json json = Json::array();
    for (const Place& p : all) json.push_back(list(p));
    return json;
  }

  Place grid_vector() {
    Place v = {};
    do
      for (int i = 0; i < dimension(); ++i) v[i] = whole(-2, 2);
    while (v == Place{});
    return v;
  }
  /// A direction, of any length but 0.
  Place direction() {
    Place v = grid_vector();
    double by = 1;
    if (pool_.size() > 1 && chance(0.3)) {
      const Place p = one_of(pool_), q = one_of(pool_);
      Place d;
      for (int i = 0; i < 3; ++i) d[i] = std::clamp(p[i] - q[i], -1e300, 1e300);
      if (d != Place{}) return d;
    }
    if (out_.family == Family::tenths) by = 0.1;
    if (out_.family >= Family::large && out_.family <= Family::mixed)
      by = one_of(std::vector{1., 1e299, 1e-300, 1e-309, 5e-324, size_});
    for (double& x : v) x *= by;
    return v;
  }
  bool parallel(const Place& a, const Place& b) const {
    return a[0] * b[1] == a[1] * b[0] && a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2];
  }

  // Objects.

  using Maker = Json (Drawing::*)();
  Json object() {
    if (out_.family == Family::nested && !pool_.empty() && chance(0.5)) {
      center_ = one_of(pool_);
      scale_ = one_of(std::vector{0.125, 0.25, 1., 4.});
    }
    if (out_.family == Family::thresholds && chance(0.6)) return many();
    static const std::vector<Maker> in_plane = {
        &Drawing::point,   &Drawing::segment,  &Drawing::segment, &Drawing::ray,     &Drawing::line,
        &Drawing::plane,   &Drawing::sphere,   &Drawing::box,     &Drawing::obb,     &Drawing::capsule,
        &Drawing::capsule, &Drawing::triangle, &Drawing::polygon, &Drawing::polygon, &Drawing::kdop,
        &Drawing::hull,    &Drawing::cloud};
    static const std::vector<Maker> in_space = {
        &Drawing::point,   &Drawing::segment,  &Drawing::segment, &Drawing::ray,      &Drawing::line,
        &Drawing::plane,   &Drawing::sphere,   &Drawing::box,     &Drawing::obb,      &Drawing::capsule,
        &Drawing::capsule, &Drawing::cylinder, &Drawing::cone,    &Drawing::triangle, &Drawing::polygon_in_space,
        &Drawing::kdop,    &Drawing::frustum,  &Drawing::hull,    &Drawing::hull,     &Drawing::mesh,
        &Drawing::cloud};
    return (this->*one_of(flat_ ? in_plane : in_space))();
  }

  Json point() { return {{"point", ""}, {"at", list(place())}}; }
  Json segment() {
    const Place from = place(), to = out_.family == Family::flat && chance(0.3) ? from : place();
    return {{"segment", ""}, {"from", list(from)}, {"to", list(to)}};
  }
  Json ray() {
    Json o = {{"ray", ""}, {"origin", list(place())}, {"dir", list(direction())}};
    if (chance(0.2)) o["tmin"] = whole(-2, 1) / 2.;
    if (chance(0.2)) o["tmax"] = whole(2, 4) / 2.;
    return o;
  }
  Json line() { return {{"line", ""}, {"origin", list(place())}, {"dir", list(direction())}}; }
  Json plane() {
    const Place n = direction(), through = place();
    double d = 0;
    for (int i = 0; i < 3; ++i) d -= n[i] * through[i];
    if (!(std::abs(d) <= 1e300)) d = coordinate();
    return {{"plane", ""}, {"normal", list(n)}, {"d", d}};
  }
  Json sphere() { return {{"sphere", ""}, {"center", list(place())}, {"radius", extent()}}; }
  Json box() {
    Place lo = place(), hi = place();
    for (int i = 0; i < 3; ++i) {
      if (out_.family == Family::flat && chance(0.4)) hi[i] = lo[i];
      if (lo[i] > hi[i]) std::swap(lo[i], hi[i]);
    }
    return {{"box", ""}, {"lo", list(lo)}, {"hi", list(hi)}};
  }
  /// Three axes at right angles, or nearly.
  std::array<Place, 3> axes() {
    std::array<Place, 3> u = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const int kind = whole(0, flat_ ? 2 : 4);
    if (kind == 1) u[0] = {0.6, 0.8, 0}, u[1] = {-0.8, 0.6, 0};
    if (kind == 2) {
      const double angle = whole(1, 62) / 10.;
      u[0] = {std::cos(angle), std::sin(angle), 0}, u[1] = {-std::sin(angle), std::cos(angle), 0};
    }
    if (kind == 3) u = {{{1. / 3, 2. / 3, 2. / 3}, {2. / 3, 1. / 3, -2. / 3}, {2. / 3, -2. / 3, 1. / 3}}};
    if (kind == 4) u = {{{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}}};
    if (!flat_ && chance(0.5)) std::ranges::rotate(u, u.begin() + 1);
    return u;
  }
  Json obb() {
    const auto u = axes();
    Json o = {{"obb", ""}, {"center", list(place())}, {"u", list(u[0])}, {"v", list(u[1])}};
    if (!flat_) o["w"] = list(u[2]);
    o["half"] = list(Place{extent(), extent(), extent()});
    return o;
  }
  Json capsule() {
    const Place p = place(), q = out_.family == Family::flat && chance(0.3) ? p : place();
    return {{"capsule", ""}, {"p", list(p)}, {"q", list(q)}, {"r", extent()}};
  }
  /// A cylinder, with at least a short axis.
  Json cylinder() {
    const Place p = place();
    return {{"cylinder", ""}, {"p", list(p)}, {"q", list(other_than(p))}, {"r", extent()}};
  }
  Json cone() {
    const Place apex = place();
    return {{"cone", ""}, {"apex", list(apex)}, {"base", list(other_than(apex))}, {"r", extent()}};
  }
  Place other_than(const Place& p) {
    Place q = place();
    if (q == p) q[whole(0, 2)] += p[0] > 0 ? -1 : 1;
    return q;
  }
  Places some(int count) {
    Places all;
    for (int i = 0; i < count; ++i) all.push_back(place());
    return all;
  }
  Json triangle() {
    Places p = some(3);
    if (out_.family == Family::flat && chance(0.3)) p[2] = p[0];
    if (out_.family == Family::flat && chance(0.2))
      for (int i = 0; i < 3; ++i) p[2][i] = p[0][i] / 2 + p[1][i] / 2;
    return {{"triangle", ""}, {"points", list(p)}};
  }

  static double area(const Places& p) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
      sum += (p[i][0] - p[0][0]) * (p[i + 1][1] - p[0][1]) - (p[i][1] - p[0][1]) * (p[i + 1][0] - p[0][0]);
    return sum;
  }
  /// A simple outline on a small grid; some are concave, and some have corners on a side.
  Places outline() {
    static const std::vector<Places> all = {
        {{{0, 0, 0}}, {{2, 0, 0}}, {{2, 2, 0}}, {{0, 2, 0}}},
        {{{0, 0, 0}}, {{3, 0, 0}}, {{3, 1, 0}}, {{1, 1, 0}}, {{1, 3, 0}}, {{0, 3, 0}}},
        {{{0, 0, 0}}, {{3, 0, 0}}, {{3, 3, 0}}, {{2, 3, 0}}, {{2, 1, 0}}, {{1, 1, 0}}, {{1, 3, 0}}, {{0, 3, 0}}},
        {{{0, 0, 0}}, {{2, 1, 0}}, {{0, 2, 0}}, {{1, 1, 0}}},
        {{{0, 0, 0}}, {{1, 0, 0}}, {{3, 0, 0}}, {{0, 3, 0}}},
        {{{-2, 0, 0}}, {{-1, -2, 0}}, {{1, -2, 0}}, {{2, 0, 0}}, {{1, 2, 0}}, {{-1, 2, 0}}},
        {{{0, -3, 0}}, {{1, -1, 0}}, {{3, 0, 0}}, {{1, 1, 0}}, {{0, 3, 0}}, {{-1, 1, 0}}, {{-3, 0, 0}}, {{-1, -1, 0}}},
    };
    Places p = one_of(all);
    if (chance(0.3)) std::ranges::reverse(p);
    std::ranges::rotate(p, p.begin() + whole(0, static_cast<int>(p.size()) - 1));
    return p;
  }
  /// Replaces x and y by sizes of the family, equal values by equal ones; so it stays simple, if it does not collapse.
  Places resized(Places p) {
    for (int i = 0; i < 2; ++i) {
      const double shift = whole(-2, 2);
      std::vector<double> values(11);
      for (int k = 0; k < 11; ++k) values[static_cast<std::size_t>(k)] = sized((k - 5 + shift) * scale_);
      if (!std::ranges::is_sorted(values)) std::ranges::sort(values);
      for (Place& q : p) q[i] = values[static_cast<std::size_t>(std::lround(q[i]) + 5)];
    }
    return p;
  }
  Json polygon() {
    Places p = chance(0.5) ? resized(outline()) : some(whole(3, 6));
    if (chance(0.15)) p.push_back(p[0]);
    if (chance(0.1)) p.push_back(p.back());
    if (chance(0.2)) {
      const Places hole = chance(0.5) ? some(whole(3, 4)) : resized(outline());
      return {{"polygon", ""}, {"rings", {list(p), list(hole)}}};
    }
    return {{"polygon", ""}, {"points", list(p)}};
  }
  /// A polygon in a plane along two axes, or with whole numbers in any plane.
  Json polygon_in_space() {
    const bool exact = out_.family == Family::grid || out_.family == Family::nested || out_.family == Family::restated;
    if (exact && chance(0.6)) {
      const Place u = grid_vector(), from = {whole(-3, 3) * 1., whole(-3, 3) * 1., whole(-3, 3) * 1.};
      Place v = grid_vector();
      while (parallel(u, v)) v = grid_vector();
      Places all;
      for (const Place& q : outline()) {
        all.push_back(from);
        for (int i = 0; i < 3; ++i) all.back()[i] += q[0] * u[i] + q[1] * v[i];
      }
      return {{"polygon", ""}, {"points", list(all)}};
    }
    while (true) {
      Places p = resized(outline());
      bool collapsed = false;
      for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) collapsed |= p[i] == p[j];
      if (collapsed || edges_cross(p)) continue;
      const double height = coordinate();
      for (Place& q : p) q[2] = height;
      const int turn = whole(0, 2);
      for (Place& q : p) std::ranges::rotate(q, q.begin() + turn);
      return {{"polygon", ""}, {"points", list(p)}};
    }
  }
  /// Whether edges cross, in long double: it may say so of a simple outline, but on these grids misses none that cross.
  static bool edges_cross(const Places& p) {
    const auto turn = [](const Place& a, const Place& b, const Place& c) {
      const auto scaled = [](double x, double y) { return static_cast<long double>(x) - y; };
      const long double l = scaled(b[0], a[0]) * scaled(c[1], a[1]), r = scaled(b[1], a[1]) * scaled(c[0], a[0]);
      return l > r ? 1 : l < r ? -1 : 0;
    };
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        const Place &a = p[i], &b = p[(i + 1) % n], &c = p[j], &d = p[(j + 1) % n];
        if (j == i + 1 || (i == 0 && j == n - 1)) {  // neighbours: no way back
          const Place &x = j == i + 1 ? a : c, &y = j == i + 1 ? b : a, &z = j == i + 1 ? d : b;
          const bool back =
              turn(x, y, z) == 0 && ((x[0] - y[0]) * (z[0] - y[0]) > 0 || (x[1] - y[1]) * (z[1] - y[1]) > 0);
          if (back) return true;
          continue;
        }
        if (turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0) {
          const auto apart = [&](int k) {
            return std::max(a[k], b[k]) < std::min(c[k], d[k]) || std::max(c[k], d[k]) < std::min(a[k], b[k]);
          };
          if (!apart(0) && !apart(1)) return true;
        }
      }
    return false;
  }

  Json kdop_of(const Places& normals, const Place& center) {
    Json o = {{"kdop", ""}, {"normals", list(normals)}, {"lo", Json::array()}, {"hi", Json::array()}};
    for (const Place& n : normals) {
      double value = 0;
      for (int i = 0; i < 3; ++i) value += n[i] * center[i];
      o["lo"].push_back(std::clamp(value - extent(), -1e300, 1e300));
      o["hi"].push_back(std::clamp(value + extent(), -1e300, 1e300));
    }
    return o;
  }
  Json kdop() {
    Places normals = {{1, 0, 0}, {0, 1, 0}};
    if (!flat_) normals.push_back({0, 0, 1});
    static const Places more_in_plane = {{1, 1, 0}, {1, -1, 0}, {2, 1, 0}, {-1, 2, 0}};
    static const Places more = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 0}, {1, 0, 1},
                                {0, 1, 1}, {1, -1, 0}, {1, 0, -1}, {0, 1, -1}, {2, 1, 0}, {1, 2, 3}};
    for (const Place& n : flat_ ? more_in_plane : more)
      if (chance(0.3)) normals.push_back(n);
    if (chance(0.2)) normals.erase(normals.begin());  // may be refused, having no end
    if (chance(0.3))
      for (Place& n : normals)
        for (double& x : n) x *= 0.7;
    return kdop_of(normals, place());
  }
  Json frustum() {
    const Place forward = direction();
    Place up = grid_vector();
    while (parallel(forward, up)) up = grid_vector();
    const double near = std::abs(coordinate());
    double far = near + std::abs(coordinate());
    if (!(near < far) || far > 1e300) far = near > 1 ? std::min(2 * near, 1e300) : near + 1;
    Json o = {{"frustum", ""}, {"eye", list(place())}, {"forward", list(forward)}, {"up", list(up)}};
    o["angle"] = one_of(std::vector{1., 30., 53.13, 90., 120., 170.});
    if (chance(0.5)) o["aspect"] = one_of(std::vector{0.5, 1., 1.6, 2.});
    o["near"] = near, o["far"] = far;
    return o;
  }
  Json hull() {
    Places all = some(whole(dimension() + 1, 9));
    if (chance(0.3)) all.push_back(all[0]);
    return {{"hull", ""}, {"points", list(all)}};
  }
  Json cloud() { return {{"cloud", ""}, {"points", list(some(whole(1, 6)))}}; }

  static Json triangles_of_box() {
    return {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  }
  static Places corners_of_box(const Place& lo, const Place& hi, int count = 8) {
    Places all;
    for (int k = 0; k < count; ++k)
      all.push_back({k & 1 ? hi[0] : lo[0], k & 2 ? hi[1] : lo[1], k & 4 ? hi[2] : lo[2]});
    return all;
  }
  Json mesh() {
    const int kind = whole(0, 3);
    if (kind == 0) {
      const Json of = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
      return {{"mesh", ""}, {"points", list(some(4))}, {"triangles", of}};
    }
    if (kind == 1) {
      Place lo = place(), hi = place();
      for (int i = 0; i < 3; ++i)
        if (lo[i] > hi[i]) std::swap(lo[i], hi[i]);
      return {{"mesh", ""}, {"points", list(corners_of_box(lo, hi))}, {"triangles", triangles_of_box()}};
    }
    if (kind == 2) {  // a ring around a middle
      const Place m = {coordinate(), coordinate(), coordinate()};
      const Place e = {std::abs(coordinate()), std::abs(coordinate()), std::abs(coordinate())};
      Places p;
      for (int i = 0; i < 3; ++i)
        for (const int side : {-1, 1}) {
          p.push_back(m);
          p.back()[i] = std::clamp(m[i] + side * e[i], -1e300, 1e300);
        }
      Json of = Json::array();
      for (int x = 0; x < 2; ++x)
        for (int y = 2; y < 4; ++y)
          for (int z = 4; z < 6; ++z) (x + y + z) % 2 == 0 ? of.push_back({x, z, y}) : of.push_back({x, y, z});
      return {{"mesh", ""}, {"points", list(p)}, {"triangles", of}};
    }
    const int count = whole(1, 5);
    Json of = Json::array();
    for (int i = 0; i < count; ++i) of.push_back({whole(0, 4), whole(0, 4), whole(0, 4)});
    return {{"mesh", ""}, {"points", list(some(5))}, {"triangles", of}};
  }

  // Objects with as many parts as where another way through the program begins.

  /// The corners of a convex outline with whole coordinates.
  Places convex_outline(int count) {
    Places vectors;
    for (int x = -4; x <= 4; ++x)
      for (int y = -4; y <= 4; ++y)
        if (std::gcd(x, y) == 1) vectors.push_back({x * 1., y * 1., 0});
    std::ranges::shuffle(vectors, random_);
    std::ranges::stable_sort(vectors, {}, [](const Place& v) { return std::abs(v[0]) + std::abs(v[1]); });
    Places half;  // with their opposites they go round
    for (const Place& v : vectors)
      if (2 * static_cast<int>(half.size()) < count && (v[1] > 0 || (v[1] == 0 && v[0] > 0))) half.push_back(v);
    for (std::size_t i = 0, n = half.size(); i < n; ++i) half.push_back({-half[i][0], -half[i][1], 0});
    std::ranges::sort(half, {}, [](const Place& v) { return std::atan2(v[1], v[0]); });
    Places all;
    Place at = {};
    for (const Place& v : half) {
      at[0] += v[0], at[1] += v[1];
      all.push_back(at);
    }
    Place middle = {};
    for (const Place& p : all)
      for (int i = 0; i < 2; ++i) middle[i] += p[i];
    for (Place& p : all)
      for (int i = 0; i < 2; ++i) p[i] -= std::round(middle[i] / static_cast<double>(all.size()));
    return all;
  }
  Json many() {
    const Place shift = place();
    const auto moved = [&](Places all) {
      for (Place& p : all)
        for (int i = 0; i < dimension(); ++i) p[i] += shift[i];
      return list(all);
    };
    if (flat_) {
      const Places outline = convex_outline(one_of(std::vector{32, 34, 36, 38, 40, 42}));
      const int kind = whole(0, 3);
      if (kind == 0) return {{"hull", ""}, {"points", moved(outline)}};
      if (kind == 1) return {{"polygon", ""}, {"points", moved(outline)}};
      if (kind == 2) return {{"cloud", ""}, {"points", moved(outline)}};
      Places normals;
      for (const Place& v : convex_outline(2 * whole(15, 22)))
        if (std::ranges::none_of(normals, [&](const Place& n) { return parallel(n, v); }) && v != Place{})
          normals.push_back(v);
      return kdop_of(normals, shift);
    }
    const int kind = whole(0, 4);
    if (kind == 0) {  // a prism or a double pyramid
      const Places outline = convex_outline(one_of(std::vector{6, 8, 10, 12}));
      Places all;
      const double top = whole(1, 3);
      for (const Place& p : outline) all.push_back({p[0], p[1], -top}), all.push_back({p[0], p[1], top});
      return {{"hull", ""}, {"points", moved(all)}};
    }
    if (kind == 1) {
      Places all = convex_outline(one_of(std::vector{14, 16, 18, 20, 22}));
      all.push_back({0, 0, 3}), all.push_back({0, 0, -2});
      return {{"hull", ""}, {"points", moved(all)}};
    }
    if (kind == 2) {  // on a ball: 2 n - 4 facets
      Places all;
      for (const Place& p : std::vector<Place>{{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}})
        for (int k = 0; k < 8; ++k) all.push_back({k & 1 ? -p[0] : p[0], k & 2 ? -p[1] : p[1], k & 4 ? -p[2] : p[2]});
      std::ranges::shuffle(all, random_);
      all.resize(static_cast<std::size_t>(whole(15, 24)));
      return {{"hull", ""}, {"points", moved(all)}};
    }
    if (kind == 3) return {{"cloud", ""}, {"points", list(some(whole(39, 42)))}};
    Places normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    while (static_cast<int>(normals.size()) < 13) {
      const Place v = grid_vector();
      if (std::ranges::none_of(normals, [&](const Place& n) { return parallel(n, v); })) normals.push_back(v);
    }
    normals.resize(static_cast<std::size_t>(whole(9, 13)));
    return kdop_of(normals, shift);
  }

  // The same set as an object of another type; null where there is none.

  static Place place_of(const Json& p) { return {p[0], p[1], p.size() > 2 ? p[2].get<double>() : 0}; }
  /// A box around points of the plane, one unit larger on each side.
  static Places around(const Json& points) {
    Place lo = place_of(points[0]), hi = lo;
    for (const Json& p : points)
      for (int i = 0; i < 2; ++i)
        lo[i] = std::min(lo[i], p[i].get<double>()), hi[i] = std::max(hi[i], p[i].get<double>());
    return {{lo[0] - 1, lo[1] - 1, 0}, {hi[0] + 1, lo[1] - 1, 0}, {hi[0] + 1, hi[1] + 1, 0}, {lo[0] - 1, hi[1] + 1, 0}};
  }
  Json restated(const Json& o) {
    const std::string type = o.begin().key();
    if (type == "sphere") {
      if (chance(0.4)) return o;
      return {{"capsule", ""}, {"p", o["center"]}, {"q", o["center"]}, {"r", o["radius"]}};
    }
    if (type == "capsule") {
      if (o["r"] == 0 && chance(0.5)) return {{"segment", ""}, {"from", o["p"]}, {"to", o["q"]}};
      return {{"capsule", ""}, {"p", o["q"]}, {"q", o["p"]}, {"r", o["r"]}};
    }
    if (type == "segment") {
      const int kind = whole(0, 2);
      if (kind == 0) return {{"capsule", ""}, {"p", o["from"]}, {"q", o["to"]}, {"r", 0.}};
      if (kind == 1) return {{"segment", ""}, {"from", o["to"]}, {"to", o["from"]}};
      return {{"triangle", ""}, {"points", {o["from"], o["to"], o["from"]}}};
    }
    if (type == "point") return {{"sphere", ""}, {"center", o["at"]}, {"radius", 0.}};
    if (type == "box") {
      const Place lo = place_of(o["lo"]), hi = place_of(o["hi"]);
      Places corners = corners_of_box(lo, hi, flat_ ? 4 : 8);
      const int kind = whole(0, 4);
      if (kind == 0) return {{"hull", ""}, {"points", list(corners)}};
      if (kind == 1) {
        Json k = {{"kdop", ""}, {"normals", Json::array()}, {"lo", o["lo"]}, {"hi", o["hi"]}};
        for (int i = 0; i < dimension(); ++i) {
          Place n = {};
          n[i] = 1;
          k["normals"].push_back(list(n));
        }
        return k;
      }
      if (kind == 2) {
        Place c, e;
        for (int i = 0; i < 3; ++i) c[i] = lo[i] / 2 + hi[i] / 2, e[i] = hi[i] / 2 - lo[i] / 2;
        Json b = {{"obb", ""}, {"center", list(c)}, {"u", list(Place{1, 0, 0})}, {"v", list(Place{0, 1, 0})}};
        if (!flat_) b["w"] = list(Place{0, 0, 1});
        b["half"] = list(e);
        return b;
      }
      if (kind == 3 && flat_) {
        std::swap(corners[2], corners[3]);
        return {{"polygon", ""}, {"points", list(corners)}};
      }
      if (kind == 3) return {{"mesh", ""}, {"points", list(corners)}, {"triangles", triangles_of_box()}};
      return o;
    }
    if (type == "triangle") {
      Json points = o["points"];
      std::rotate(points.begin(), points.begin() + 1, points.end());
      if (flat_ && chance(0.4)) return {{"hull", ""}, {"points", points}};
      if (flat_ && chance(0.5)) return {{"polygon", ""}, {"points", points}};
      if (!flat_ && chance(0.3)) return {{"mesh", ""}, {"points", points}, {"triangles", {{0, 1, 2}}}};
      return {{"triangle", ""}, {"points", points}};
    }
    if (type == "polygon" && o.contains("rings")) {
      Json rings = o["rings"];
      std::reverse(rings.begin(), rings.end());
      for (Json& ring : rings) std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      return {{"polygon", ""}, {"rings", rings}};
    }
    if (type == "polygon") {
      Json points = o["points"];
      std::reverse(points.begin(), points.end());
      if (flat_ && chance(0.3)) return {{"polygon", ""}, {"rings", {list(around(points)), points}}};  // as its hole
      return {{"polygon", ""}, {"points", points}};
    }
    if (type == "hull") {
      Json points = o["points"];
      std::reverse(points.begin(), points.end());
      return {{"hull", ""}, {"points", points}};
    }
    if (type == "cloud") return {{"hull", ""}, {"points", o["points"]}};
    if (type == "obb" || type == "kdop" || type == "plane" || type == "frustum") return o;
    if (type == "ray" || type == "line") {
      Json other = o;
      const double by = chance(0.5) ? 2 : 1;
      for (Json& x : other["dir"]) x = x.get<double>() * (type == "line" ? -by : by);
      if (place_of(other["dir"]) == Place{} || std::abs(other["dir"][0].get<double>()) > 1e300) return o;
      for (const Json& x : other["dir"])
        if (std::abs(x.get<double>()) > 1e300) return o;
      return other;
    }
    return {};
  }

  /// Collects points of the object that others may start from.
  void collect(const Json& o) {
    for (const auto& [key, value] : o.items()) {
      if (!value.is_array() || value.empty() || key == "dir" || key == "normal" || key == "normals" || key == "u" ||
          key == "v" || key == "w" || key == "half" || key == "forward" || key == "up" || key == "triangles" ||
          key == "rings")
        continue;
      if (value[0].is_number()) {
        if (value.size() == static_cast<std::size_t>(dimension()) && (key != "lo" || !o.contains("kdop")) &&
            (key != "hi" || !o.contains("kdop")))
          pool_.push_back(place_of(value));
      } else {
        for (const Json& p : value) pool_.push_back(place_of(p));
      }
    }
    if (o.contains("box")) {
      const Place lo = place_of(o["lo"]), hi = place_of(o["hi"]);
      for (const Place& p : corners_of_box(lo, hi, flat_ ? 4 : 8))
        if (chance(0.4)) pool_.push_back(p);
    }
    const char* radius = o.contains("radius") ? "radius" : o.contains("r") ? "r" : nullptr;
    if (radius) {  // on its surface
      Place p = place_of(o.contains("center") ? o["center"] : o.contains("p") ? o["p"] : o["base"]);
      p[whole(0, dimension() - 1)] += (chance(0.5) ? 1 : -1) * o[radius].get<double>();
      pool_.push_back(p);
    }
    if (o.contains("dir")) {
      Place p = place_of(o["origin"]), d = place_of(o["dir"]);
      for (int i = 0; i < 3; ++i) p[i] += d[i];
      pool_.push_back(p);
    }
  }

  std::mt19937_64& random_;
  Drawn& out_;
  bool flat_;
  double size_ = 1, scale_ = 1;
  Place center_ = {};
  Places pool_;
};

}  // namespace

Drawn draw(std::mt19937_64& random) {
  // Objects with many faces take a hundred times as long as the others.
  std::discrete_distribution<int> family = {4, 4, 4, 4, 2, 2, 2, 4, 4, 4, 1};
  Drawn out = {static_cast<Family>(family(random)), std::uniform_int_distribution<int>(0, 1)(random) == 0};
  Drawing(random, out).objects(std::uniform_int_distribution<int>(7, 12)(random));
  return out;
}

}  // namespace isect::proof
