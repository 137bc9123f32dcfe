#pragma once
// A file of hard cases of one kind, in the schema of `isect query`: inputs, what is hard about them, the true answer.

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include <isect/shapes.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"

namespace isect::cases {

using Json = nlohmann::ordered_json;
using bench::Numbers;
using bench::Random;
using oracle::Rational;

/// Inputs by the names that `isect query` reads, and the truth by those that it answers.
struct Case {
  Json inputs, expected;
  bool f32 = false;  ///< asked in floats, which the inputs are
};

/// The expected answer for input that has no meaning: NaN, or an infinity where none belongs.
inline Case policy(Json inputs, bool f32) { return {std::move(inputs), {{"policy", "an error or a plain no"}}, f32}; }

class CaseFile {
 public:
  explicit CaseFile(std::string kind) : kind_(std::move(kind)) {}

  const std::string& kind() const { return kind_; }
  std::size_t size() const { return cases_.size(); }

  /// `note` says what is hard about the case.
  void add(const std::string& note, const Case&);

  /// Adds cases from a generator with a seed of its own: `count` of them, with verdicts mixed as evenly as possible.
  /// `draw` may return nothing.
  void family(const std::string& note, int count, const std::function<std::optional<Case>(Random&)>& draw);

  /// The file's text, one case a line; numbers have as few digits as identify them.
  std::string text() const;

 private:
  struct Noted {
    std::string note;
    Case what;
  };
  std::string kind_;
  std::vector<Noted> cases_;
};

/// The value on one line; numbers have as few digits as identify them.
std::string written(const Json&);

/// All kinds, in the order of `isect query --help`.
std::vector<CaseFile> all();

// What a file of the project's own generators holds.
CaseFile orient2d();
CaseFile interval_interval();
CaseFile point_point();
CaseFile point_box();
CaseFile point_sphere();
CaseFile point_obb();
CaseFile point_capsule();
CaseFile point_cylinder();
CaseFile point_cone();
CaseFile point_line();
CaseFile point_plane();
CaseFile plane_sphere();
CaseFile plane_box();
CaseFile plane_cylinder();
CaseFile plane_cone();
CaseFile box_box();
CaseFile sphere_sphere();
CaseFile sphere_box();
CaseFile sphere_capsule();
CaseFile sphere_cylinder();
CaseFile sphere_cone();
CaseFile capsule_capsule();
CaseFile obb_obb();
CaseFile kdop_kdop();
CaseFile triangle_box();
CaseFile ray_sphere();
CaseFile ray_box();
CaseFile ray_plane();
CaseFile ray_obb();
CaseFile ray_capsule();
CaseFile ray_cylinder();
CaseFile ray_cone();
CaseFile segment_cylinder();
CaseFile segment_cone();
CaseFile cylinder_solid();
CaseFile cone_solid();
CaseFile ray_outline();
CaseFile line_triangle();
CaseFile segment_plane();
CaseFile segment_box();
CaseFile segment_segment();
CaseFile ray_polygon();
CaseFile pip();
CaseFile polygon_polygon();
CaseFile convex_polygons();
CaseFile polygon_plane();
CaseFile polygon_box();
CaseFile segment_polygon();
CaseFile convex_hull2d();
CaseFile polygon_normal();
CaseFile bounding_volume_fit();

}  // namespace isect::cases
