#pragma once
// Joins the polygons of a file into the outlines of one: inside is what lies within an odd number of them.

#include <functional>
#include <string>

#include "app/scene/files/shape_file.h"

namespace isect::program::scene {

class PolygonBuilder {
 public:
  /// Throws viz::BadInput with the place of what is being read.
  using Refuse = std::function<void(const std::string& why)>;
  explicit PolygonBuilder(Refuse refuse) : refuse_(std::move(refuse)) {}

  void begin_polygon() { ++polygons_; }
  void begin_ring() { begin_ = shape_.points.size(); }
  void position(const viz::Vec3&, std::size_t coordinates);
  /// Ends a ring, whose last point must be its first.
  void end_ring();

  ShapeFile made();

 private:
  Refuse refuse_;
  ShapeFile shape_;
  std::size_t begin_ = 0, coordinates_ = 0;  ///< the latter: 0 until there is a position
  int polygons_ = 0;
};

}  // namespace isect::program::scene
