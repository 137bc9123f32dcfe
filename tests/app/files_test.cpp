// Files of other programs: each dialect that programs write, with its right reading beside it; random shapes in all of
// them, whose answers are those of the plain file; and files at random.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "app/scene/files/shape_file.h"
#include "app/scene/lesson.h"
#include "tests/app/refusals.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"
#include "viz/lesson.h"

namespace files_test {
using namespace isect::test;
using isect::program::scene::read_shape;
using isect::program::scene::ShapeFile;
using isect::viz::Vec3;
using Json = nlohmann::ordered_json;

namespace {

// The folder of dialects.

std::filesystem::path folder() { return ISECT_FILES; }

/// The table of readings. Some readings have a name, as many files mean the same.
Json readings() {
  const Json table = Json::parse(contents(folder() / "readings.json"));
  Json all = Json::object();
  for (const auto& [file, given] : table["files"].items()) {
    all[file] = given;
    if (given.is_string()) all[file] = table["shapes"].at(given);
    if (!given.is_object() || !given.contains("like")) continue;
    all[file] = table["shapes"].at(given["like"]);
    all[file].update(given);
  }
  return all;
}

Json listed(const std::vector<Vec3>& points, bool flat) {
  Json all = Json::array();
  for (const Vec3& p : points) {
    all.push_back({p.x(), p.y()});
    if (!flat) all.back().push_back(p.z());
  }
  return all;
}

/// The area of all triangles; exact for small whole numbers.
double area(const ShapeFile& shape) {
  double sum = 0;
  for (const auto& [a, b, c] : shape.triangles) {
    const auto p = [&](int i) -> const Vec3& { return shape.points[static_cast<std::size_t>(i)]; };
    sum += (p(b) - p(a)).cross(p(c) - p(a)).norm() / 2;
  }
  return sum;
}

/// Faces of more than four corners may be cut in several ways: as their edges bound the triangles, these cover the face
/// and nothing else if and only if they have its area.
void check_reading(const ShapeFile& shape, const Json& expected) {
  CHECK(listed(shape.points, shape.flat) == expected["points"]);
  CHECK(Json(shape.rings) == expected.value("rings", Json::array()));
  if (expected.contains("area")) {
    CHECK(area(shape) == expected["area"]);
    CHECK(shape.triangles.size() == expected["count"]);
  } else {
    CHECK(Json(shape.triangles) == expected.value("triangles", Json::array()));
  }
  const std::string note = expected.value("note", ""), told = shape.note_of_faces + shape.note;
  CHECK_THAT(told, Contains(note));
  CHECK(told.empty() == note.empty());
}

// Random shapes, written in every dialect. Coordinates are eighths, which are floats.

using Dialects = std::vector<std::pair<std::string, std::string>>;  ///< a file's name, and what it holds

struct Mesh {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
};

/// Corners in the order of their directions from (0, 0), counter-clockwise, less than half a turn apart.
std::vector<Vec3> star(std::mt19937& random) {
  std::uniform_int_distribution<int> steps(1, 24), count(2, 3);
  std::vector<Vec3> ring;
  for (const auto& [x, y] : {std::pair(1, 0), {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}})
    if (ring.size() < 3 || count(random) == 2) ring.push_back(Vec3(x, y, 0) * steps(random) / 8.0);
  if (ring.size() < 6) ring.push_back(Vec3(-1, -2, 0) * steps(random) / 8.0);
  return ring;
}

/// A prism over a star: a face below, one above, of many corners and with notches, and squares around.
Mesh prism(std::mt19937& random) {
  std::vector<Vec3> ring = star(random);
  std::ranges::sort(ring, {}, [](const Vec3& p) { return std::atan2(p.y(), p.x()); });
  const int n = static_cast<int>(ring.size());
  Mesh mesh = {ring, {{}, {}}};
  for (const Vec3& p : ring) mesh.points.push_back(p + Vec3(0, 0, 1.5));
  for (int i = 0; i < n; ++i) mesh.faces[0].push_back(i), mesh.faces[1].insert(mesh.faces[1].begin(), n + i);
  for (int i = 0; i < n; ++i) mesh.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  return mesh;
}

/// The triangles as a mesh, its points numbered in the order in which they occur.
Mesh in_triangles(const ShapeFile& shape) {
  Mesh mesh;
  std::map<int, int> numbers;
  for (const auto& t : shape.triangles) {
    mesh.faces.emplace_back();
    for (const int i : t) {
      const auto [found, is_new] = numbers.try_emplace(i, static_cast<int>(mesh.points.size()));
      if (is_new) mesh.points.push_back(shape.points[static_cast<std::size_t>(i)]);
      mesh.faces.back().push_back(found->second);
    }
  }
  return mesh;
}

template <class T>
std::string raw(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big_endian) std::ranges::reverse(bytes);
  return bytes;
}
std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size()) text.replace(at, what.size(), by);
  return text;
}
std::string row(const Vec3& p, const std::string& separator = " ", bool flat = false) {
  return fmt::format("{}{}{}", p.x(), separator, p.y()) + (flat ? "" : separator + fmt::format("{}", p.z()));
}
constexpr const char* mark = "\xef\xbb\xbf";

std::string vertices(const Mesh& m, const std::string& before = "", const std::string& behind = "") {
  std::string text;
  for (const Vec3& p : m.points) text += before + row(p) + behind + "\n";
  return text;
}
std::string faces(const Mesh& m, const std::string& before, int first, const std::string& behind = "", int less = 0) {
  std::string text;
  for (const auto& face : m.faces) {
    text += before == "n" ? std::to_string(face.size()) : before;
    for (const int i : face) text += " " + std::to_string(i + first - less) + behind;
    text += "\n";
  }
  return text;
}

Dialects in_obj(const Mesh& m) {
  const std::string v = vertices(m, "v "), f = faces(m, "f", 1), all = v + f;
  const int count = static_cast<int>(m.points.size());
  return {{"mark.obj", mark + all},
          {"crlf.obj", replaced(all, "\n", "\r\n")},
          {"cr.obj", replaced(all, "\n", "\r")},
          {"first.obj", f + v},
          {"capitals.OBJ", replaced(replaced(all, "v ", "V "), "f ", "F ")},
          {"negative.obj", v + faces(m, "f", 0, "", count)},
          {"continued.obj", v + replaced(f, " ", " \\\n")},
          {"comments.obj", "# by a test\n" + replaced(all, "\n", " # here\n")},
          {"textures.obj", v + "vt 0 0\n" + faces(m, "f", 1, "/1")},
          {"normals.obj", v + "vn 0 0 1\n" + faces(m, "f", 1, "//1")},
          {"all.obj", "mtllib a.mtl\no a\n" + v + "vt 0 0\nvn 0 0 1\nusemtl b\ns 1\n" + faces(m, "f", 1, "/1/1")},
          {"weights.obj", vertices(m, "v ", " 1") + f},
          {"colours.obj", vertices(m, "v ", " 0.5 0.25 1") + f},
          {"blanks.obj", replaced(replaced(all, " ", "\t "), "\n", " \n\n ")}};
}

std::string ply_header(const Mesh& m, const std::string& format, const std::string& number = "float") {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment by a test\nelement vertex {}\nproperty {} x\nproperty {} y\nproperty {} z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, m.points.size(), number, number, number, m.faces.size());
}
template <class Number>
std::string binary_ply(const Mesh& m, bool big, const std::string& number) {
  std::string bytes = ply_header(m, big ? "binary_big_endian" : "binary_little_endian", number);
  for (const Vec3& p : m.points)
    for (const double x : p) bytes += raw(static_cast<Number>(x), big);
  for (const auto& face : m.faces) {
    bytes += static_cast<char>(face.size());
    for (const int i : face) bytes += raw(std::int32_t{i}, big);
  }
  return bytes;
}
Dialects in_ply_and_off(const Mesh& m) {
  const std::string v = vertices(m), f = faces(m, "n", 0), text = ply_header(m, "ascii") + v + f;
  const std::string counts = fmt::format("{} {} 0\n", m.points.size(), m.faces.size());
  const std::string header = ply_header(m, "ascii");
  const std::size_t points = header.find("element vertex"), of_faces = header.find("element face"),
                    end = header.find("end_");
  return {{"text.ply", text},
          {"mark.ply", mark + text},
          {"crlf.ply", replaced(text, "\n", "\r\n")},
          {"cr.ply", replaced(text, "\n", "\r")},
          {"faces-first.ply", header.substr(0, points) + header.substr(of_faces, end - of_faces) +
                                  header.substr(points, of_faces - points) + header.substr(end) + f + v},
          {"index.ply", replaced(text, "vertex_indices", "vertex_index")},
          {"little.ply", binary_ply<float>(m, false, "float")},
          {"big.ply", binary_ply<float>(m, true, "float32")},
          {"doubles.ply", binary_ply<double>(m, false, "double")},
          {"plain.off", "OFF\n" + counts + v + f},
          {"beside.off", "OFF " + counts + "\n# points\n" + v + "# faces\n" + f},
          {"no-word.off", counts + v + f},
          {"colours.off", "COFF\n" + counts + vertices(m, "", " 255 0 0 255") + replaced(f, "\n", " 0 255 0\n")},
          {"crlf.off", replaced("OFF\n" + counts + v + f, "\n", "\r\n")}};
}

/// The mesh in the formats that hold triangles only.
Dialects in_stl_and_strips(const Mesh& m) {
  std::string text = "solid of a test\n", strips, binary = std::string("solid, in bytes").append(65, ' ');
  binary += raw(static_cast<std::uint32_t>(m.faces.size()));
  for (const auto& face : m.faces) {
    text += " facet normal 0 0 0\n  outer loop\n";
    binary += std::string(12, '\0');
    for (const int i : face) {
      const Vec3& p = m.points[static_cast<std::size_t>(i)];
      text += "   vertex " + row(p) + "\n";
      for (const double x : p) binary += raw(static_cast<float>(x));
      strips += fmt::format("{} ", i);
    }
    text += "  endloop\n endfacet\n";
    binary += std::string(2, '\0');
    strips += "-1 ";
  }
  text += "endsolid of a test\n";
  std::string capitals = text;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const std::string header =
      replaced(ply_header(m, "ascii"), fmt::format("face {}\nproperty list uchar", m.faces.size()),
               "tristrips 1\nproperty list int");
  return {{"text.stl", text},
          {"mark.stl", mark + text},
          {"cr.stl", replaced(text, "\n", "\r")},
          {"blank.stl", "\n " + replaced(text, "\n", "\r\n")},
          {"capitals.STL", capitals},
          {"binary.stl", binary},
          {"strips.ply", header + vertices(m) + fmt::format("{} ", m.faces.size() * 4) + strips + "\n"}};
}

Dialects in_tables(const std::vector<Vec3>& points, bool flat) {
  const std::string names = flat ? "x,y" : "x,y,z";
  const auto rows = [&](const std::string& separator, const std::string& before = "", const std::string& behind = "") {
    std::string text;
    for (const Vec3& p : points) text += before + row(p, separator, flat) + behind + "\n";
    return text;
  };
  const std::string plain = rows(",");
  return {{"plain.csv", plain},
          {"mark.csv", mark + plain},
          {"mark-and-names.csv", mark + names + "\n" + plain},
          {"crlf.csv", replaced(plain, "\n", "\r\n")},
          {"cr.csv", replaced(plain, "\n", "\r")},
          {"id.csv", "id," + names + ",note\n" + rows(",", "7,", ",\"a, b\"")},
          {"quoted.csv", "\"" + replaced(names, ",", "\",\"") + "\"\n" + rows("\",\"", "\"", "\"")},
          {"decimal-commas.csv", replaced(replaced(rows(";"), ".", ","), ";", " ; ")},
          {"excel.csv", mark + ("sep=;\r\n" + replaced(names, ",", ";") + "\r\n") +
                            replaced(replaced(rows(";"), ".", ","), "\n", "\r\n")},
          {"comments.csv", "# by a test\n\n" + replaced(plain, "\n", " # here\n# there\n")},
          {"tabs.tsv", replaced(rows("\t"), ".", ",")},
          {"blanks.txt", rows("  ", " ", " ")},
          {"numpy.txt", "# " + replaced(names, ",", " ") + "\n" + rows(" ")},
          {"plain.xyz", rows(" ")},
          {"named.xyz", "//I " + replaced(names, ",", " ") + "\n" + rows(" ", "9 ")}};
}

using Rings = std::vector<std::vector<Vec3>>;

Dialects in_geojson_and_wkt(const Rings& rings) {
  std::string json, wkt;
  for (const auto& ring : rings) {
    json += json.empty() ? "[" : ", [", wkt += wkt.empty() ? "(" : ", (";
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Vec3& p = ring[i % ring.size()];
      json += (i == 0 ? "[" : ", [") + row(p, ", ", true) + "]", wkt += (i == 0 ? "" : ", ") + row(p, " ", true);
    }
    json += "]", wkt += ")";
  }
  const std::string polygon = R"({"type": "Polygon", "coordinates": [)" + json + "]}";
  const std::string feature = R"({"type": "Feature", "properties": {"name": "a"}, "geometry": )" + polygon + "}";
  return {
      {"polygon.geojson", polygon},
      {"mark.geojson", mark + polygon},
      {"lines.geojson", replaced(polygon, " ", "\r\n  ")},
      {"multi.json", R"({"coordinates": [[)" + json + R"(]], "type": "MultiPolygon"})"},
      {"feature.geojson", feature},
      {"collection.geojson", R"({"type": "FeatureCollection", "bbox": [0, 0, 1, 1], "features": [)" + feature + "]}"},
      {"geometries.geojson", R"({"type": "GeometryCollection", "geometries": [)" + polygon + "]}"},
      {"polygon.wkt", "POLYGON (" + wkt + ")\n"},
      {"small.wkt", "polygon(" + replaced(wkt, ", ", ",") + ")"},
      {"lines.wkt", "POLYGON\n(" + replaced(wkt, ", ", ",\r\n") + ")"},
      {"multi.wkt", "MULTIPOLYGON((" + wkt + "))"},
      {"srid.wkt", "SRID=4326;POLYGON (" + wkt + ")"},
      {"collection.wkt", std::string(mark) + "GEOMETRYCOLLECTION (POLYGON (" + wkt + "))"},
      {"tagged.wkt", "GEOMETRYCOLLECTIONZ(POLYGON (" + wkt + "))"}};
}

/// The answers of a scene, with a shape from a file or written in it.
class Scenes {
 public:
  Scenes(std::string others, std::string ask) : others_(std::move(others)), ask_(std::move(ask)) {}

  Json answers(const std::string& object) const {
    const std::string text = R"({"objects": [)" + object + ", " + others_ + R"(], "ask": )" + ask_ + "}";
    return isect::program::scene::answers(isect::program::scene::read_scene(text, shell_.work().string()));
  }
  Json answers_of(const std::string& type, const std::string& name, const std::string& bytes) const {
    write(shell_.work() / name, bytes);
    return answers(fmt::format(R"({{"{}": "M", "file": "{}"}})", type, name));
  }
  void check_all(const std::string& type, const Dialects& dialects, const Json& expected) const {
    for (const auto& [name, bytes] : dialects) {
      INFO(name << "\n" << bytes.substr(0, 600));
      CHECK(answers_of(type, name, bytes) == expected);
    }
  }

 private:
  Shell shell_;
  std::string others_, ask_;
};

std::vector<std::string> verdicts(const Json& answers) {
  std::vector<std::string> all;
  for (const Json& one : answers) all.push_back(one["verdict"]);
  return all;
}

}  // namespace

TEST_CASE("every dialect of a file has its right reading, or an error that tells the place", "[files]") {
  const Json all = readings();
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    found += entry.path().filename() != "readings.json";
  CHECK(found == all.size());
  CHECK(found >= 200);
  for (const auto& [name, expected] : all.items()) {
    INFO(name);
    REQUIRE(std::filesystem::exists(folder() / name));
    try {
      const ShapeFile shape = read_shape(contents(folder() / name), name);
      INFO("it was read, and is wrong: " << expected.dump());
      REQUIRE_FALSE(expected.contains("error"));
      check_reading(shape, expected);
    } catch (const isect::viz::BadInput& e) {
      CHECK_THAT(e.what(), Contains(name + ": ") && Contains(expected.value("error", "no error: it is right")));
    }
  }
}

TEST_CASE("a mesh is the same mesh in every dialect of OBJ, PLY, OFF and STL", "[files]") {
  std::mt19937 random(2026);
  std::uniform_int_distribution<int> eighths(-24, 24);
  for (int scene = 0; scene < 70; ++scene) {
    const auto number = [&] { return eighths(random) / 8.0; };
    const Mesh mesh = prism(random);
    const Scenes scenes(fmt::format(R"({{"ray": "r", "origin": [{}, {}, 5], "dir": [0, 0.125, -1]}},
                            {{"point": "p", "at": [{}, {}, 0.5]}}, {{"sphere": "S", "center": [{}, {}, 2], "radius": 1}})",
                                    number(), number(), number(), number(), number(), number()),
                        R"([["r", "M"], ["p", "M"], ["S", "M"], {"fit": "M", "volume": "box"}])");
    const std::string plain = vertices(mesh, "v ") + faces(mesh, "f", 1);
    const Json expected = scenes.answers_of("mesh", "plain.obj", plain);
    scenes.check_all("mesh", in_obj(mesh), expected);
    scenes.check_all("mesh", in_ply_and_off(mesh), expected);

    const Mesh cut = in_triangles(read_shape(plain, "plain.obj"));
    const Json of_triangles = scenes.answers_of("mesh", "cut.obj", vertices(cut, "v ") + faces(cut, "f", 1));
    CHECK(verdicts(of_triangles) == verdicts(expected));
    scenes.check_all("mesh", in_stl_and_strips(cut), of_triangles);
  }
}

TEST_CASE("a cloud is the same cloud in every dialect of a table", "[files]") {
  std::mt19937 random(45);
  std::uniform_int_distribution<int> eighths(-24, 24), count(1, 12);
  for (int scene = 0; scene < 65; ++scene) {
    const bool flat = scene % 2 == 0;
    std::vector<Vec3> points;
    for (int i = count(random); i >= 0; --i)
      points.push_back(Vec3(eighths(random), eighths(random), flat ? 0 : eighths(random)) / 8.0);
    const Scenes scenes(flat ? R"({"circle": "S", "center": [0.5, 0], "radius": 2})"
                             : R"({"sphere": "S", "center": [0.5, 0, 0], "radius": 2})",
                        R"([["M", "S"], {"fit": "M", "volume": "box"}])");
    const Json expected = scenes.answers(R"({"cloud": "M", "points": )" + listed(points, flat).dump() + "}");
    scenes.check_all("cloud", in_tables(points, flat), expected);
    if (!flat) {
      const Mesh mesh = {points, {}};
      scenes.check_all("cloud",
                       {{"points.obj", vertices(mesh, "v ")},
                        {"points.ply", ply_header(mesh, "ascii") + vertices(mesh)},
                        {"points.off", fmt::format("OFF\n{} 0 0\n", points.size()) + vertices(mesh)}},
                       expected);
    }
  }
}

TEST_CASE("a polygon is the same polygon in every dialect of GeoJSON, WKT and a table", "[files]") {
  std::mt19937 random(7946);
  std::uniform_int_distribution<int> eighths(-24, 24);
  for (int scene = 0; scene < 65; ++scene) {
    Rings rings = {star(random)};
    std::ranges::sort(rings[0], {}, [](const Vec3& p) { return std::atan2(p.y(), p.x()); });
    if (scene % 2 == 1) {
      rings.push_back(rings[0]);
      for (Vec3& p : rings[1]) p /= 4;
    }
    const Scenes scenes(
        fmt::format(R"({{"point": "p", "at": [{}, {}]}}, {{"ray": "r", "origin": [{}, -4], "dir": [0.25, 1]}})",
                    eighths(random) / 32.0, eighths(random) / 32.0, eighths(random) / 8.0),
        R"([["p", "M"], ["r", "M"]])");
    Json all = Json::array();
    for (const auto& ring : rings) all.push_back(listed(ring, true));
    const Json expected = scenes.answers(R"({"polygon": "M", "rings": )" + all.dump() + "}");
    scenes.check_all("polygon", in_geojson_and_wkt(rings), expected);
    if (rings.size() == 1) scenes.check_all("polygon", in_tables(rings[0], true), expected);
  }
}

TEST_CASE("a face with holes and notches is cut into triangles of its area, exactly", "[files]") {
  std::mt19937 random(1975);
  std::uniform_int_distribution<int> turn(0, 100), thirds(0, 1);
  for (int i = 0; i < 400; ++i) {
    std::vector<Vec3> outer = star(random);
    std::ranges::sort(outer, {}, [](const Vec3& p) { return std::atan2(p.y(), p.x()); });
    // A hole at a quarter of its size, which an edge along a direction from the middle leads to and back from.
    std::vector<Vec3> face = outer;
    const std::size_t at = static_cast<std::size_t>(turn(random)) % outer.size();
    if (i % 2 == 1) {
      face.clear();
      for (std::size_t k = 0; k <= outer.size(); ++k) face.push_back(outer[(at + k) % outer.size()]);
      for (std::size_t k = 0; k <= outer.size(); ++k)
        face.push_back(outer[(at + 2 * outer.size() - k) % outer.size()] / 4);
    }
    double expected = 0;
    Mesh mesh;
    mesh.faces.emplace_back();
    const int pose = i % 3;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3 &p = face[k], &q = face[(k + 1) % face.size()];
      expected += (p.x() * q.y() - p.y() * q.x()) / 2;
      // Two of the planes are upright; in the third, x and y are as they were, and so are areas seen along z.
      mesh.points.push_back(pose == 0   ? Vec3(p.x(), p.y(), 0)
                            : pose == 1 ? Vec3(0, p.x(), p.y())
                                        : Vec3(p.y(), 0, p.x()));
      mesh.faces[0].push_back(static_cast<int>(k));
    }
    const std::string bytes = vertices(mesh, "v ") + faces(mesh, "f", 1);
    INFO(bytes);
    const ShapeFile shape = read_shape(bytes, "face.obj");
    CHECK(area(shape) == expected);
    CHECK((shape.note.empty() && shape.note_of_faces.empty()));
  }
}

TEST_CASE("a file at random is read, or refused with the place of what is wrong", "[files]") {
  const char* const long_run = std::getenv("ISECT_LONG");
  std::mt19937 random(std::random_device::min() + 45);
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().filename() != "readings.json") files.emplace_back(entry.path().filename(), contents(entry.path()));
  std::ranges::sort(files);
  const std::vector<std::string> pieces = {"0",
                                           "-1",
                                           "9",
                                           "1e308",
                                           "\n",
                                           "\r",
                                           " ",
                                           ",",
                                           ";",
                                           "(",
                                           ")",
                                           "[",
                                           "]",
                                           "\"",
                                           "\\\n",
                                           "#",
                                           "nan",
                                           "99999999999",
                                           "\xef\xbb\xbf",
                                           std::string(1, '\0'),
                                           "f 1 2 3",
                                           "{",
                                           "}"};
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (int i = 0; i < (long_run ? 2'000'000 : 20'000); ++i) {
    const auto& [name, bytes] = files[below(files.size())];
    std::string changed = bytes;
    for (std::size_t k = 0; k <= below(3); ++k) {
      const std::size_t at = below(changed.size() + 1), length = std::min(below(9), changed.size() - at);
      switch (below(4)) {
        case 0:
          changed.erase(at, length);
          break;
        case 1:
          changed.insert(at, pieces[below(pieces.size())]);
          break;
        case 2:
          changed.insert(at, changed.substr(below(changed.size() + 1), below(40)));
          break;
        default:
          if (at < changed.size()) changed[at] = static_cast<char>(below(256));
      }
    }
    INFO(name << ", changed:\n" << changed);
    try {
      const ShapeFile shape = read_shape(changed, name);
      bool sound = !shape.points.empty();
      for (const Vec3& p : shape.points) sound = sound && p.allFinite() && (!shape.flat || p.z() == 0);
      for (const auto& t : shape.triangles)
        for (const int corner : t) sound = sound && corner >= 0 && corner < static_cast<int>(shape.points.size());
      int corners = 0;
      for (const int ring : shape.rings) sound = sound && ring >= 3, corners += ring;
      if (!sound || (corners != 0 && corners != static_cast<int>(shape.points.size())))
        FAIL("what was read is no shape");
    } catch (const isect::viz::BadInput& e) {
      const std::string why = e.what();
      bool told = why.starts_with(name + ": ");
      bool placed = false;
      for (const char* place :
           {"line ", "facet ", "face ", "vertex ", "tristrips ", "at byte ", " bytes", "no points in it", "before ",
            "its header ", "its vertices ", "its element ", "a name that ends"})
        placed = placed || why.find(place) != why.npos;
      if (!told || !placed) FAIL(why);
    }
  }
}

TEST_CASE("what is nested deep, long or written on many lines is refused soon, in a short message", "[files]") {
  const auto refusal = [](const std::string& bytes, const std::string& name) {
    return refusal_of([&] { read_shape(bytes, name); });
  };
  const auto polygon = [](const std::string& outline) {
    return R"({"type": "Polygon", "coordinates": [)" + outline + "]}";
  };
  constexpr std::size_t deep = 300'000;
  CHECK(refusal(polygon(std::string(deep, '[') + std::string(deep, ']')), "deep.json") ==
        "deep.json: line 1: a list of lists is no position; two or three numbers are expected");
  std::string numbers = "1";
  for (int i = 0; i < 1000; ++i) numbers += ",1";
  CHECK(refusal(polygon("[[" + numbers + "]]"), "long.json") ==
        "long.json: line 1: [1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1... is no position; two or three numbers are "
        "expected");

  std::string accents = "a";
  for (int i = 0; i < 30; ++i) accents += "\xc3\xa4";
  CHECK(refusal("v 0 0 " + accents, "words.obj") ==
        "words.obj: line 1: \"" + accents.substr(0, 39) + "...\" is no finite number");

  std::string continued = "v 0 0 0\nf ";
  for (int i = 0; i < 1'000'000; ++i) continued += "\\\n1 ";
  const auto begin = std::chrono::steady_clock::now();
  CHECK(refusal(continued, "lines.obj") == "lines.obj: line 2: a face of more than 2000 vertices");
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));  // it took the square of the lines
}

TEST_CASE("what a file holds beyond its shape, or not as it may be meant, is told with the answer", "[files]") {
  const Shell shell;
  write(shell.work() / "bent.obj", "v 0 0 0\nv 2 0 0\nv 2 2 1\nv 0 2 0\nl 1 2\nf 1 2 3 4\n");
  write(shell.work() / "s.json", R"({"objects": [{"mesh": "M", "file": "bent.obj"},
    {"ray": "r", "origin": [1, 0.5, 5], "dir": [0, 0, -1]}], "ask": [["r", "M"]]})");
  const Ran ran = shell("isect scene s.json");
  CHECK(ran.out == "r meets M\n");
  CHECK_THAT(ran.err, Contains("s.json: M: The corners of a face (the first: line 6) lie up to ") &&
                          Contains("off one plane") && Contains("left out (the first: line 5)"));
  CHECK_THAT(shell("isect explain s.json --step 1").out, Contains("off one plane"));
  write(shell.work() / "face.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nl 1 2\nf 1 2 3 4\n");
  write(shell.work() / "o.json", R"({"objects": [{"polygon": "P", "file": "face.obj"}]})");
  CHECK_THAT(shell("isect scene o.json").err, Contains("o.json: P: A point or a line has no area, and is left out"));
  write(shell.work() / "two.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 0))\nPOLYGON ((2 0, 6 0, 6 4, 2 0))\n");
  write(shell.work() / "p.json", R"({"objects": [{"polygon": "P", "file": "two.wkt"}, {"point": "p", "at": [3, 0.5]}],
    "ask": [["p", "P"]]})");
  const Ran two = shell("isect scene p.json");
  CHECK(two.out == "p lies outside P\n");
  CHECK_THAT(two.err, Contains("p.json: P: Its 2 polygons are read as one: where two of them overlap is outside."));
}

TEST_CASE("polygons with holes come from files, short and long ones", "[files]") {
  const Shell shell;
  const auto verdict = [&](const std::string& file, const std::string& at) {
    write(shell.work() / "s.json", R"({"objects": [{"polygon": "P", "file": ")" + file +
                                       R"("}, {"point": "p", "at": )" + at + R"(}], "ask": [["p", "P"]]})");
    const Ran ran = shell("isect scene s.json");
    INFO(file << ran.err);
    CHECK(ran.status == 0);
    return ran.out;
  };
  for (const std::string file : {"geojson-hole.geojson", "wkt-hole.wkt"}) {
    std::filesystem::copy(folder() / file, shell.work() / file);
    CHECK(verdict(file, "[1.5, 1.5]") == "p lies outside P\n");
    CHECK(verdict(file, "[3, 3]") == "p lies inside P\n");
    CHECK(verdict(file, "[1, 1.5]") == "p lies on the boundary of P\n");
  }
  // A figure of a short file can be opened without it, with its hole.
  CHECK(shell("isect render s.json --step 1").status == 0);
  std::filesystem::remove(shell.work() / "wkt-hole.wkt");
  CHECK(shell("isect show figures/scene/s/01-objects.png").status == 77);  // no display, and no complaint before that
  // One corner of a mesh's only face after the other, in space.
  std::filesystem::copy(folder() / "obj-square-turned.obj", shell.work() / "face.obj");
  write(shell.work() / "f.json", R"({"objects": [{"polygon": "P", "file": "face.obj"},
    {"ray": "r", "origin": [1, 1, 5], "dir": [0, 0, -1]}], "ask": [["r", "P"]]})");
  CHECK(shell("isect scene f.json").out == "r meets P\n");
  std::filesystem::copy(folder() / "off-plain.off", shell.work() / "plain.off");
  std::filesystem::copy(folder() / "stl-two-facets.stl", shell.work() / "two.stl");
  write(shell.work() / "f.json", R"({"objects": [{"polygon": "P", "file": "two.stl"}]})");
  CHECK_THAT(shell("isect scene f.json").err, Contains("two.stl holds more than one face"));

  std::string points;
  for (int i = 0; i <= 10'000; ++i) points += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", i, i * i);
  write(shell.work() / "l.json", R"({"objects": [{"polygon": "P", "points": [)" + points + "]}]}");
  const Ran many = shell("isect scene l.json");
  CHECK(many.status == 2);
  CHECK_THAT(many.err, Contains("objects[0].points: 10001 points; here 10000 are the most, in a \"file\" 1000000"));
}

TEST_CASE("whoever waits for a pipe is told so", "[files]") {
  const Shell shell;
  const std::string scene =
      R"({"objects": [{"point": "p", "at": [0, 0]}, {"point": "q", "at": [0, 0]}], "ask": [["p", "q"]]})";
  write(shell.work() / "s.json", scene);
  const Ran slow = shell("mkfifo p\n(sleep 1.5; cat s.json > p) &\nisect scene p\nwait");
  CHECK(slow.status == 0);
  CHECK(slow.out == "p and q coincide\n");
  CHECK(slow.err == "p: waiting for what somebody is to write there\n");
  const Ran at_once = shell("mkfifo q\ncat s.json > q &\nisect scene q\nwait");
  CHECK(at_once.out == "p and q coincide\n");
  CHECK(at_once.err.empty());
}

}  // namespace files_test
