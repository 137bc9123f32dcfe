#include "app/scene/files/polygon_builder.h"

#include <fmt/format.h>

#include "viz/lang/message.h"

namespace isect::program::scene {

void PolygonBuilder::position(const viz::Vec3& p, std::size_t coordinates) {
  if (coordinates_ == 0) coordinates_ = coordinates;
  if (coordinates != coordinates_)
    refuse_(fmt::format("{} coordinates, where others have {}", coordinates, coordinates_));
  if (shape_.points.size() == most_in_file) refuse_(fmt::format("more than {} corners", most_in_file));
  shape_.points.push_back(p);
}

void PolygonBuilder::end_ring() {
  const std::size_t count = shape_.points.size() - begin_;
  if (count < 4)
    refuse_(fmt::format("{} positions; an outline has four at least, as the last repeats the first", count));
  if (shape_.points[begin_] != shape_.points.back()) refuse_("an outline that does not end where it begins");
  shape_.points.pop_back();
  shape_.rings.push_back(static_cast<int>(count) - 1);
}

ShapeFile PolygonBuilder::made() {
  shape_.flat = coordinates_ == 2;
  if (polygons_ > 1)
    shape_.note = viz::tr("Its {n} polygons are read as one: where two of them overlap is outside.",
                          {{"n", std::to_string(polygons_)}});
  return std::move(shape_);
}

}  // namespace isect::program::scene
