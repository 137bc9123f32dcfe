#include "lessons/points/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <isect/methods/point_point.h>
#include <isect/point_point.h>
#include "viz/camera.h"

namespace isect::lessons::points_lesson {

using namespace viz;

const Camera camera = {};

Setup::Setup(const Parameters& values)
    : p(std::get<Vec3>(values.at("p"))),
      q(std::get<Vec3>(values.at("q"))),
      r(std::get<Vec3>(values.at("r"))),
      tolerance(std::get<double>(values.at("tolerance"))) {
  const std::string& name = std::get<std::string>(values.at("unit"));
  unit = name == "huge" ? 0x1p600 : name == "tiny" ? 0x1p-600 : 1;
  is_nan = std::get<std::string>(values.at("z")) == "NaN";
  tp = unit * p, tq = unit * q, tr = unit * r;
  tested_within = unit * tolerance;
  if (is_nan) tq.z() = std::numeric_limits<double>::quiet_NaN();
}

std::vector<Said> said(const Setup& s) {
  using namespace point_point;
  return {{"exact", "exact", nearly_equal(s.tp, s.tq, s.tested_within)},
          {"squares", "squares", near_by_squares(s.tp, s.tq, s.tested_within)},
          {"distance", "distance", near_by_distance(s.tp, s.tq, s.tested_within)},
          {"coordinates", "coordinates", near_by_coordinates(s.tp, s.tq, s.tested_within)}};
}

void add_point(Scene& scene, const char* parameter, const Vec3& at, const std::string& label, Role role, Mark mark) {
  scene.items.emplace_back(Dot{at, mark, role});
  scene.items.emplace_back(Label{at, label, role});
  scene.handles.push_back({parameter, Handle::Kind::point, at, Vec3::Zero(), role});
}

void add_tolerance(Scene& scene, const Setup& s, const Vec3& center, double above) {
  const View view(camera, 1, 1);
  const std::string unit = s.unit > 1 ? " · 2^{600}" : s.unit < 1 ? " · 2^{−600}" : "";
  scene.items.emplace_back(viz::Heading{center + (above * s.tolerance + 0.2) * view.up(),
                                        "tolerance: " + shown(s.tolerance) + unit, Role::first, 1.8, false});
  scene.items.emplace_back(Ball{center, s.tolerance, Role::first});
  const Vec3 down = -Vec3::UnitY();
  scene.handles.push_back({"tolerance", Handle::Kind::along, center + s.tolerance * down, center, Role::first, down});
}

void add_range(Scene& scene, double distance_exponent, bool squared) {
  const View view(camera, 1, 1);
  constexpr double least = std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits,
                   most = std::numeric_limits<double>::max_exponent;
  const auto at = [&](double exponent, double up = 0) -> Vec3 {
    return 2 * exponent / most * view.right() + (up - 1.8) * view.up();
  };
  scene.items.emplace_back(Span{at(least), at(most), Role::muted, Pen::thick});
  const auto end = [&](double exponent, const char* text) {
    scene.items.emplace_back(viz::Heading{at(exponent, -0.3), text, Role::muted, 0, false});
  };
  end(least, "2^{−1074}"), end(0, "1"), end(most, "2^{1024}");
  scene.items.emplace_back(Line{at(0, -0.08), at(0, 0.08), Role::muted, Pen::hairline});
  scene.items.emplace_back(Dot{at(distance_exponent), Mark::disc, Role::text});
  scene.items.emplace_back(viz::Heading{at(distance_exponent, 0.25), "*d*", Role::text, 0, false});
  if (!squared) return;
  const double square = 2 * distance_exponent;
  const bool outside = square < least || square > most;
  scene.items.emplace_back(Dot{at(square), outside ? Mark::cross : Mark::disc, outside ? Role::miss : Role::text});
  scene.items.emplace_back(viz::Heading{at(square, 0.25), "*d*^2", outside ? Role::miss : Role::text, 0, false});
}

}  // namespace isect::lessons::points_lesson
