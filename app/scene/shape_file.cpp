#include "app/scene/shape_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <utility>

#include "app/scene/shape_file_parts.h"
#include "viz/files.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

/// On lines with a semicolon a comma is a decimal one, as many countries write them: 0,5;1,25.
std::string with_decimal_points(std::string bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const auto line = bytes.begin() + static_cast<std::ptrdiff_t>(at),
               last = bytes.begin() + static_cast<std::ptrdiff_t>(end);
    if (std::find(line, last, ';') != last) std::replace(line, last, ',', '.');
    at = end + 1;
  }
  return bytes;
}

ShapeFile csv(const std::string& bytes, const std::string& file) {
  ShapeFile shape;
  bool first = true;
  std::size_t columns = 0;
  each_line(with_decimal_points(bytes), file, [&](Line& line) {
    constexpr std::string_view separators = " \t\r,;";
    std::vector<std::string_view> words;
    while (!line.ended(separators)) words.push_back(line.word(separators));
    if (words.empty() || words[0].starts_with('#')) return;
    const bool of_words = words[0].find_first_not_of("+-.0123456789eE") != std::string_view::npos;
    if (std::exchange(first, false) && of_words) return;
    if (columns == 0) columns = words.size();
    if (words.size() != columns || columns < 2 || columns > 3)
      line.refuse(fmt::format("{} number{}; two or three are expected, as many on every line", words.size(),
                              words.size() == 1 ? "" : "s"));
    Vec3 p = Vec3::Zero();
    for (std::size_t i = 0; i < columns; ++i) p[static_cast<int>(i)] = line.number(words[i]);
    shape.points.push_back(p);
  });
  shape.flat = columns == 2;
  return shape;
}

ShapeFile obj(const std::string& bytes, const std::string& file) {
  ShapeFile shape;
  each_line(bytes, file, [&](Line& line) {
    const std::string_view keyword = line.word();
    if (keyword == "v") shape.points.push_back(line.point());
    if (keyword != "f") return;
    std::vector<int> corners;
    while (!line.ended()) {
      std::string_view corner = line.word();
      corner = corner.substr(0, corner.find('/'));  // index/texture/normal
      const long given = line.whole(corner), count = static_cast<long>(shape.points.size());
      const long index = given < 0 ? count + given : given - 1;
      if (index < 0 || index >= count) line.refuse(fmt::format("vertex {}, and there are {} so far", given, count));
      corners.push_back(static_cast<int>(index));
    }
    if (corners.size() < 3) line.refuse("a face has three vertices at least");
    add_face(shape, corners);
  });
  return shape;
}

/// Facets that share corners by their coordinates.
class Facets {
 public:
  void add(const std::array<Vec3, 3>& corners) {
    std::array<int, 3> triangle = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = corners[i];
      const auto [found, is_new] = known_.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(shape_.points.size()));
      if (is_new) shape_.points.push_back(p);
      triangle[i] = found->second;
    }
    shape_.triangles.push_back(triangle);
  }
  ShapeFile made() { return std::move(shape_); }

 private:
  ShapeFile shape_;
  std::map<std::array<double, 3>, int> known_;
};

ShapeFile stl(const std::string& bytes, const std::string& file) {
  constexpr std::size_t head = 84, facet = 50;
  Facets facets;
  const auto count = bytes.size() >= head ? Bytes(bytes, file, head - 4).next<std::uint32_t>() : 0;
  if (bytes.size() >= head && bytes.size() == head + facet * std::size_t{count}) {  // binary, whatever it begins with
    Bytes data(bytes, file, head);
    for (std::uint32_t i = 0; i < count; ++i) {
      data.skip(12);  // the normal
      std::array<Vec3, 3> corners;
      for (Vec3& p : corners)
        for (int k = 0; k < 3; ++k) p[k] = data.next<float>();
      for (const Vec3& p : corners)
        if (!p.allFinite()) refuse(file, fmt::format("facet {} has a coordinate that is no finite number", i + 1));
      facets.add(corners);
      data.skip(2);
    }
    return facets.made();
  }
  if (!bytes.starts_with("solid")) refuse(file, "neither a binary STL of its length nor a text that begins with solid");
  std::vector<Vec3> corners;
  each_line(bytes, file, [&](Line& line) {
    const std::string_view keyword = line.word();
    if (keyword == "vertex") corners.push_back(line.point());
    if (keyword != "endfacet") return;
    if (corners.size() != 3) line.refuse(fmt::format("a facet of {} vertices; three are expected", corners.size()));
    facets.add({corners[0], corners[1], corners[2]});
    corners.clear();
  });
  if (!corners.empty()) refuse(file, "it ends within a facet");
  return facets.made();
}

}  // namespace

ShapeFile read_shape_file(const std::string& path) {
  static const std::map<std::string, ShapeFile (*)(const std::string&, const std::string&)> readers = {
      {".csv", csv}, {".obj", obj}, {".stl", stl}, {".ply", ply}};
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto reader = readers.find(ending);
  if (reader == readers.end())
    throw viz::BadInput(fmt::format("{}: a name that ends in .csv, .obj, .stl or .ply is expected", path));
  ShapeFile shape = reader->second(viz::read_regular_file(path), path);
  if (shape.points.empty()) refuse(path, "no points in it");
  if (std::max(shape.points.size(), shape.triangles.size()) > most_in_file)
    refuse(path, fmt::format("more than {} points or triangles", most_in_file));
  return shape;
}

}  // namespace isect::program::scene
