#include "app/scene/files/shape_file.h"

#include <filesystem>
#include <map>

#include "app/scene/files/reading.h"
#include "viz/formats/files.h"

namespace isect::program::scene {

namespace {

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all = {
      {".csv", read_table},       {".tsv", read_table},    {".txt", read_table}, {".xyz", read_xyz},
      {".obj", read_obj},         {".stl", read_stl},      {".ply", read_ply},   {".off", read_off},
      {".geojson", read_geojson}, {".json", read_geojson}, {".wkt", read_wkt}};
  return all;
}

}  // namespace

std::string readable_endings() {
  std::string all;
  for (const auto& [ending, reader] : readers()) all += (all.empty() ? "" : ", ") + ending;
  return all;
}

ShapeFile read_shape(const std::string& bytes, const std::string& name) {
  const auto reader = readers().find(lower(std::filesystem::path(name).extension().string()));
  if (reader == readers().end()) refuse(name, "a name that ends in one of these is expected: " + readable_endings());
  ShapeFile shape = reader->second(bytes, name);
  if (shape.points.empty()) refuse(name, "no points in it");
  return shape;
}

ShapeFile read_shape_file(const std::string& path) {
  if (!readers().contains(lower(std::filesystem::path(path).extension().string()))) return read_shape({}, path);
  return read_shape(viz::read_regular_file(path), path);
}

}  // namespace isect::program::scene
