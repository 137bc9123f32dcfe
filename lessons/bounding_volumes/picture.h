#pragma once
// Pictures of an object in its bounding volumes: each alone with its definition, and all side by side.

#include "lessons/bounding_volumes/object.h"

namespace isect::lessons::bounding_volumes_lesson {

inline const viz::Camera camera = {};

viz::Item drawn(const TriangleMesh<double>&, viz::Role);

/// "void 3.8 ×", in sizes of the object.
std::string void_of(const Measured&, double object);
/// A line of text below a drawing.
viz::Item below(const std::vector<viz::Item>&, const std::string& text);

// A volume's own numbers, drawn on it.
std::vector<viz::Item> corners(const Aabb<double, 3>&);
/// The vertex farthest from the centre. Among those equally far up to rounding, the one whose radius looks longest.
viz::Vec3 farthest(const TriangleMesh<double>&, const Sphere<double, 3>& ball);
std::vector<viz::Item> radius(const Sphere<double, 3>&, const viz::Vec3& farthest);
std::vector<viz::Item> axes(const Obb<double, 3>&);
/// The two planes of slab i around the object, with its normal.
std::vector<viz::Item> slab(const Kdop<double, 3>&, std::size_t i);

/// The slab whose planes are seen neither face-on nor edge-on; not one along an axis, if there is another.
std::size_t seen_best(const Kdop<double, 3>&);

/// Side by side: the drawing, its void beside the object's own volume, a cell for each number kept, and the operations
/// of a test.
std::vector<viz::Item> side_by_side(const TriangleMesh<double>&, double object, const std::vector<Measured>&);

}  // namespace isect::lessons::bounding_volumes_lesson
