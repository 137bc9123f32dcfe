#include "app/scene/files/shape_file.h"

#include <filesystem>
#include <map>
#include <utility>

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

std::map<std::string, ShapeFile>& given_files() {
  static std::map<std::string, ShapeFile> all;
  return all;
}

std::string name_of_file(const std::string& path) { return std::filesystem::path(path).filename().string(); }

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

void give_shape_file(const std::string& name, ShapeFile shape) {
  given_files().insert_or_assign(name_of_file(name), std::move(shape));
}

ShapeFile read_shape_file(const std::string& path) {
  if (const auto given = given_files().find(name_of_file(path)); given != given_files().end()) return given->second;
  if (!readers().contains(lower(std::filesystem::path(path).extension().string()))) return read_shape({}, path);
  return read_shape(viz::read_regular_file(path), path);
}

}  // namespace isect::program::scene
