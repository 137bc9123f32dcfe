#pragma once
// How a case of each test is drawn; nothing where the case does not show what its family is about, so that another is
// taken.

#include <array>
#include <optional>
#include <string>

#include <isect/shapes.h>
#include "lessons/speed_against_error/sketch.h"

namespace isect::lessons::speed_against_error_lesson {

using Drawn = std::optional<Drawing>;

// drawings_round.cpp
Drawn drawing(const std::string& family, const Sphere<double, 3>&, const Sphere<double, 3>&);
Drawn drawing(const std::string& family, const Sphere<double, 3>&, const Aabb<double, 3>&);
Drawn drawing(const std::string& family, const Ray<double, 3>&, const Sphere<double, 3>&);
// drawings_flat.cpp
Drawn drawing(const std::string& family, const Obb<double, 3>&, const Obb<double, 3>&);
Drawn drawing(const std::string& family, const Ray<double, 3>&, const Triangle<double, 3>&);
Drawn drawing(const std::string& family, const std::array<Point<double, 2>, 3>&);
Drawn drawing(const std::string& family, const Point<double, 2>&, const Ring<double, 2>&);

}  // namespace isect::lessons::speed_against_error_lesson
