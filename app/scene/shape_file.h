#pragma once
// Points and triangles from files of other programs: CSV, OBJ, STL and PLY. Coordinates stay the doubles that the text
// means; binary files hold floats, or doubles.

#include <array>
#include <string>
#include <vector>

#include "viz/scene.h"

namespace isect::program::scene {

struct ShapeFile {
  std::vector<viz::Vec3> points;              ///< z = 0 in the plane
  std::vector<std::array<int, 3>> triangles;  ///< indices of points; larger faces are cut into fans
  bool flat = false;                          ///< two coordinates a point
};

/// The most points, and the most triangles, of a file.
constexpr std::size_t most_in_file = 1'000'000;

/// By its name's ending: .csv (x,y or x,y,z a line; a first line of words is skipped), .obj, .stl or .ply, text or
/// binary. Equal corners of an STL's facets are one point. Throws viz::FileError where it can't be read, viz::BadInput
/// with its name and line, or byte, where it is broken.
ShapeFile read_shape_file(const std::string& path);

}  // namespace isect::program::scene
