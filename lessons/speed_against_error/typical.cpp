#include "lessons/speed_against_error/typical.h"

#include <array>
#include <map>
#include <optional>
#include <stdexcept>

#include "bench/obb_obb/families.h"
#include "bench/orient2d/families.h"
#include "bench/point_polygon/families.h"
#include "bench/prose.h"
#include "bench/ray_sphere/families.h"
#include "bench/ray_triangle/families.h"
#include "bench/rows.h"
#include "bench/sphere_aabb/families.h"
#include "bench/sphere_sphere/families.h"
#include "lessons/speed_against_error/drawings.h"
#include "lessons/speed_against_error/telling.h"
#include "viz/text/rich_text.h"

namespace isect::lessons::speed_against_error_lesson {

namespace {

constexpr int tries = 400;  ///< cases that are drawn until one shows what its family is about

/// A case of the family of that name in the list; nothing if there is none, or if none of the cases drawn will do.
template <class Families, class Draw>
Drawn one_of(const Families& families, const std::string& name, const Draw& draw) {
  for (const auto& family : families) {
    if (family.name != name) continue;
    bench::Random random(bench::stream(1, family.name));
    for (int i = 0; i < tries; ++i)
      if (const Drawn drawn = draw(family.draw(random))) return drawn;
  }
  return {};
}

/// The polygons of a family have few vertices here.
Drawn polygon_of(const std::string& name) try {
  const bench::PolygonFamily<double> family = bench::polygon_family<double>(name, name == "bow-tie"      ? 6
                                                                                  : name == "horizontal" ? 24
                                                                                                         : 12);
  bench::Random random(bench::stream(1, family.name));
  for (int i = 0; i < tries; ++i) {
    const bench::PolygonCase<double> c = family.draw(random);
    if (const Drawn drawn = drawing(name, c.point, *c.ring)) return drawn;
  }
  return {};
} catch (const std::invalid_argument&) {
  return {};  // the suite has no such family any more
}

Drawn drawn(const std::string& test, const std::string& family) {
  const auto pair = [&](const auto& c) { return drawing(family, c.a, c.b); };
  if (test == "sphere-sphere") return one_of(bench::sphere_sphere_draws<double>, family, pair);
  if (test == "sphere-aabb") return one_of(bench::sphere_aabb_draws<double>, family, pair);
  if (test == "obb-obb") return one_of(bench::obb_obb_draws<double>, family, pair);
  if (test == "ray-triangle") return one_of(bench::ray_triangle_draws<double>, family, pair);
  if (test == "ray-sphere")
    return one_of(bench::ray_sphere_families<double, 3>(), family,
                  [&](const auto& c) { return drawing(family, c.ray, c.sphere); });
  if (test == "orient2d")
    return one_of(bench::orient2d_draws<double>, family, [&](const bench::OrientCase<double>& c) {
      return drawing(family, std::array<Point<double, 2>, 3>{c.a, c.b, c.c});
    });
  return test == "point-polygon" ? polygon_of(family) : Drawn();
}

}  // namespace

std::vector<viz::Inset> typical(const std::string& test, const std::vector<std::string>& families) {
  std::vector<viz::Inset> all;
  for (const std::string& family : families)
    if (const Drawn one = drawn(test, family))
      all.push_back({one->sketch.items(), viz::as_markup(bench::sentence(bench::words(family))), one->note});
  return all;
}

std::string seen_from(const std::string& test) {
  static const std::map<std::string, std::string> all = {
      {"sphere-sphere", "They are seen in a plane through both centres."},
      {"sphere-aabb", "They are seen from where a gap between ball and box would show."},
      {"obb-obb", "They are seen from where a gap between the boxes would show; what is too slender is stretched."},
      {"ray-sphere", "They are seen in the plane of ray and centre."},
      {"ray-triangle",
       "They are seen along the ray, which is a point then. A ray along the plane is seen from above, and a needle is "
       "stretched."}};
  const auto found = all.find(test);
  return found == all.end() ? "" : found->second;
}

void Teller::typical_cases() {
  std::vector<std::string> families;
  for (const std::string& family : bench::families_of(rows_))
    if (const bench::Row* r = bench::standard_of(of(family)); r != nullptr && r->hard) families.push_back(family);
  const std::vector<viz::Inset> pictures = typical(test_, families);
  if (pictures.empty()) return;
  const int count = static_cast<int>(pictures.size()), columns = std::min(count, 4);
  const std::string from = seen_from(test_);
  viz::Step& step = script_.add("typical", "What the hard families are made of", hard_line,
                                "One case of each hard family, drawn at random as for the measurements." +
                                    (from.empty() ? "" : " " + from) +
                                    "\nWhere shapes touch but for a few ulp, no picture shows what is true.");
  step.scene = viz::arrangeable(pictures, columns, viz::Camera{.azimuth = 0, .elevation = 0});
}

}  // namespace isect::lessons::speed_against_error_lesson
