#include "bench/targets.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/rows.h"

namespace isect::bench {
namespace {

using Kind = Target::Kind;

bool is(const Target& t, const Growth& g) { return g.test == t.test && (t.unit.empty() || g.unit == t.unit); }

/// The time at n, if it was measured there; powers of two and ten count as the same size within a twentieth.
std::optional<double> at(const Growth& g, double n) {
  for (std::size_t i = 0; i < g.n.size(); ++i)
    if (std::abs(g.n[i] / n - 1) < 0.05) return g.ns[i];
  return {};
}

/// The least time at n among isect's `method`, or among all methods of another library.
std::optional<double> at(const Target& t, const Report& report, const std::string& who, bool ours) {
  std::optional<double> least;
  for (const Growth& g : report.growths) {
    const bool own = g.library == "isect";
    const bool meant = own ? g.method == who : !ours && g.library == who;
    if (!is(t, g) || !meant) continue;
    if (const auto ns = at(g, t.n); ns && (!least || *ns < *least)) least = ns;
  }
  return least;
}

std::optional<double> ratio(const Target& t, const Report& report) {
  const std::vector<const Row*> rows = rows_of(report, t.test, "double", t.family.empty() ? "ordinary" : t.family);
  const Row *ours = nullptr, *theirs = nullptr;
  for (const Row* r : rows) {
    const bool own = r->library == "isect";
    if (own && r->method == t.ours) ours = r;
    const bool meant = t.theirs == "naive" ? r->standard : (own ? r->method : r->library) == t.theirs;
    if (meant && (theirs == nullptr || r->ns < theirs->ns)) theirs = r;  // a library's fastest way
  }
  if (ours == nullptr || theirs == nullptr || !(theirs->ns > 0)) return {};
  return ours->ns / theirs->ns;
}

/// Over all families and both scalars.
std::optional<double> worst(const Target& t, const Report& report) {
  std::optional<double> sum;
  for (const Row& r : report.rows) {
    if (r.test != t.test || r.library != "isect" || r.method != t.ours || r.judged == 0) continue;
    if (t.kind == Kind::wrong) sum = sum.value_or(0) + static_cast<double>(r.wrong());
    if (t.kind == Kind::ulps && r.ulps) sum = std::max(sum.value_or(0), r.ulps->most);
  }
  return sum;
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"ray-sphere with t, ordinary rays", Kind::ratio, "ray-sphere", "", "exact", "naive", 0, 2},
      {"ray-sphere: wrong verdicts", Kind::wrong, "ray-sphere", "", "exact", "", 0, 0},
      {"ray-sphere: error of t", Kind::ulps, "ray-sphere", "", "exact", "", 0, 4},
      {"one ray, many spheres", Kind::ratio, "ray-sphere, one ray", "", "batch", "naive", 0, 0.04},
      {"AABB-AABB", Kind::ratio, "aabb-aabb", "", "exact", "Eigen", 0, 0.4},
      {"one AABB, many AABBs", Kind::ratio, "aabb-aabb, one box", "", "batch", "Eigen", 0, 0.06},
      {"sphere-sphere", Kind::ratio, "sphere-sphere", "", "exact", "naive", 0, 1.3},
      {"sphere-AABB", Kind::ratio, "sphere-aabb", "", "exact", "CGAL", 0, 0.15},
      {"OBB-OBB", Kind::ratio, "obb-obb", "", "exact", "Bullet", 0, 1.0},
      {"OBB-OBB: wrong verdicts", Kind::wrong, "obb-obb", "", "exact", "", 0, 0},
      {"point in polygon, 100 vertices", Kind::growth, "point-in-polygon", "", "exact", "Boost", 100, 0.4, "query"},
      {"point in polygon, 10^4 vertices", Kind::growth, "point-in-polygon", "", "exact", "Boost", 1e4, 0.4, "query"},
      {"point in polygon, 10^6 vertices", Kind::growth, "point-in-polygon", "", "exact", "Boost", 1e6, 0.4, "query"},
      {"point in a smooth polygon, preprocessed, 10^6", Kind::growth, "point location, smooth", "", "grid", "GEOS", 1e6,
       0.15, "query"},
      {"point in a spiky polygon, preprocessed, 10^6", Kind::growth, "point location, spiky", "", "grid", "CGAL", 1e6,
       0.35, "query"},
      {"preprocessing a smooth polygon, 10^6", Kind::growth, "point location, smooth", "", "grid", "GEOS", 1e6, 1.5,
       "build"},
      {"point in a convex polygon, 10^6 vertices", Kind::time, "point-in-convex-polygon", "", "exact", "", 1e6, 60,
       "query"},
      {"all overlapping pairs of like boxes, 10^6", Kind::growth, "all pairs", "", "overlapping_pairs", "Embree", 1e6,
       0.2},
      {"all overlapping pairs, some boxes large, 10^6", Kind::growth, "all pairs, heavy-tailed", "",
       "overlapping_pairs", "Embree", 1e6, 0.7},
      {"hull of 10^6 points in a disc", Kind::growth, "hull 2D, disc", "", "exact", "CGAL", 1e6, 0.2},
      {"hull of 10^6 points on a circle", Kind::growth, "hull 2D, circle", "", "exact", "CGAL", 1e6, 1.1},
      {"hull of 10^6 points in space", Kind::growth, "hull 3D", "", "exact", "qhull", 1e6, {}},
      {"building a hierarchy of 10^6 triangles", Kind::growth, "bvh", "", "exact", "Embree", 1e6, {}, "build"},
      {"closest hit among 10^6 triangles", Kind::growth, "bvh", "", "exact", "Embree", 1e6, 3, "query"},
      {"smallest sphere around 10^6 points", Kind::growth, "smallest sphere", "", "exact", "CGAL", 1e6, {}},
  };
  return all;
}

std::optional<double> measured(const Target& t, const Report& report) {
  switch (t.kind) {
    case Kind::ratio:
      return ratio(t, report);
    case Kind::growth: {
      const auto ours = at(t, report, t.ours, true), theirs = at(t, report, t.theirs, false);
      return ours && theirs && *theirs > 0 ? std::optional<double>(*ours / *theirs) : std::nullopt;
    }
    case Kind::time:
      return at(t, report, t.ours, true);
    case Kind::wrong:
    case Kind::ulps:
      break;
  }
  return worst(t, report);
}

std::string wanted(const Target& t) {
  const std::string unit = t.kind == Kind::time    ? " ns"
                           : t.kind == Kind::ulps  ? " ulp"
                           : t.kind == Kind::wrong ? ""
                                                   : " × " + t.theirs;
  if (!t.at_most) return "report only," + unit;
  return t.kind == Kind::wrong ? "0" : fmt::format("at most {:g}{}", *t.at_most, unit);
}

bool met(const Target& t, double measured) { return !t.at_most || measured <= *t.at_most; }

}  // namespace isect::bench
