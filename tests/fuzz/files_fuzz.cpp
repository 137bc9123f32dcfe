// Any bytes as a file of points, a mesh or polygons: a shape whose indices are its own, or a refusal.

#include <cstdint>
#include <string>

#include "app/scene/files/shape_file.h"
#include "tests/fuzz/require.h"
#include "viz/lesson.h"

namespace {

using isect::program::scene::ShapeFile;

void check(const ShapeFile& shape, const std::string& bytes) {
  const auto count = static_cast<int>(shape.points.size());
  require(count > 0, "some points", bytes);
  for (const isect::viz::Vec3& p : shape.points) require(p.allFinite() && (!shape.flat || p.z() == 0), "finite", bytes);
  for (const auto& t : shape.triangles)
    for (const int i : t) require(i >= 0 && i < count, "corners that there are", bytes);
  int corners = 0;
  for (const int ring : shape.rings) require(ring >= 3, "outlines of three corners", bytes), corners += ring;
  require(corners == 0 || corners == count, "as many corners as points", bytes);
}

}  // namespace

/// The first byte selects the reader of the others.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr const char* names[] = {"f.csv", "f.xyz", "f.obj", "f.stl", "f.ply", "f.off", "f.geojson", "f.wkt"};
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    check(isect::program::scene::read_shape(bytes, names[data[0] % std::size(names)]), bytes);
  } catch (const isect::viz::BadInput&) {
  }
  return 0;
}
