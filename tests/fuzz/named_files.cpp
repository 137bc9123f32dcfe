// The files that scenes of the targets may name: a few that are always there, in place of those on the disk.

#include "app/scene/files/shape_file.h"
#include "viz/formats/files.h"

namespace isect::program::scene {

ShapeFile read_shape_file(const std::string& path) {
  ShapeFile shape;
  if (path.ends_with("mesh.obj")) {
    shape.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    shape.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  } else if (path.ends_with("points.csv")) {
    shape.points = {{0, 0, 0}, {2, 1, 0}, {-1, 0.5, 0}};
    shape.flat = true;
  } else if (path.ends_with("rings.wkt")) {
    shape.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}};
    shape.rings = {4, 3};
    shape.flat = true;
  } else {
    throw viz::FileError("cannot read '" + path + "': there is no such file");
  }
  return shape;
}

}  // namespace isect::program::scene
