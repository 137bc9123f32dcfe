#include "app/scene/read_objects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include <isect/polygon_triangles.h>

#include "app/scene/colours.h"
#include "app/scene/files/shape_file.h"
#include "app/scene/types.h"
#include "viz/formats/files.h"
#include "viz/lang/message.h"
#include "viz/text/rich_text.h"
#include "viz/text/spelling.h"

namespace isect::program::scene {

namespace {

constexpr std::size_t most_objects = 1000, most_vertices = 10'000, most_slabs = 64;
/// The most points of a file that a figure takes along, so that it can be opened without that file.
constexpr std::size_t most_taken_along = 2'000;
/// The most own colours: an object is the first or the second of its step.
constexpr std::size_t most_colours = viz::most_own_colours / 2;
/// The fields that objects of all types may have.
const std::vector<std::string> in_any = {"hidden", "color", "from step", "to step"};

class ObjectReader {
 public:
  ObjectReader(Source& source, const std::string& folder) : source_(source), folder_(folder) {}

  ReadObjects read() {
    const Json& all =
        source_.list(source_.member(source_.json(), {}, "objects"), {"objects"}, 1, most_objects, "objects");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Path path = {"objects", std::to_string(i)};
      out_.json.push_back(all[i]);
      read(with_types_own_name(all[i]), path);
    }
    return std::move(out_);
  }

 private:
  /// Accepts "circle", the sphere of the plane.
  static Json with_types_own_name(const Json& json) {
    if (!json.is_object()) return json;
    const auto other = std::ranges::find_if(types(), [&](const TypeSpec& t) {
      return !other_name(t).empty() && json.contains(other_name(t)) && !json.contains(t.name);
    });
    if (other == types().end()) return json;
    Json renamed = Json::object();
    for (const auto& [key, value] : json.items()) renamed[key == other->in_plane ? other->name : key] = value;
    return renamed;
  }

  void read(const Json& json, const Path& path) {
    if (!json.is_object() || json.empty())
      source_.refuse(path, "an object such as {\"sphere\": \"A\", ...} is expected");
    const auto known = std::ranges::find_if(types(), [&](const TypeSpec& t) { return json.contains(t.name); });
    if (known == types().end()) {
      std::vector<std::string> names;
      for (const TypeSpec& t : types()) names.push_back(t.name);
      const std::string first = json.begin().key();
      const std::string instead = spelling::instead(first, names, "allowed: " + spelling::listed(names));
      source_.refuse(below(path, first),
                     "no type of object" + instead + ", each with the object’s name, as in {\"sphere\": \"A\", ...}");
    }
    Object o = {known->type, source_.text(json[known->name], below(path, known->name))};
    check_name(o.name, below(path, known->name));
    if (o.type == Type::kdop)
      slabs(json, path, o);
    else if (known->fields.empty())
      points(json, path, o);
    else
      fields(json, path, *known, o);
    if (source_.flat() && known->in_plane.empty())
      source_.refuse(path,
                     fmt::format("{} has three coordinates; there is none in the plane", with_article(known->type)));
    if (!source_.flat() && !out_.json.back().contains(known->name))
      source_.refuse(path, fmt::format("a {} in space; a {}, a ball, is meant", known->in_plane, known->name));
    if (json.contains("hidden")) {
      if (!json["hidden"].is_boolean()) source_.refuse(below(path, "hidden"), "true or false is expected");
      o.hidden = json["hidden"];
    }
    if (json.contains("color")) colour(json["color"], below(path, "color"), o);
    o.steps = read_steps(source_, json, path);
    require_shape(o, path);
    out_.all.push_back(std::move(o));
  }

  void colour(const Json& json, const Path& path, Object& o) {
    const Chosen chosen = read_colour(source_, json, path);
    o.role = chosen.role, o.colour = chosen.rgb;
    if (chosen.rgb) colours_.insert(*chosen.rgb);
    if (colours_.size() > most_colours)
      source_.refuse(path, fmt::format("one more colour than the {} that a scene may have", most_colours));
  }

  /// Checks that the numbers make a shape: a frustum that is empty has no corners.
  void require_shape(const Object& o, const Path& path) const {
    if (o.type != Type::frustum && o.type != Type::kdop) return;
    try {
      static_cast<void>(NamedValues{out_.parameters, source_.flat()}.extent(o));
    } catch (const viz::BadInput& e) {
      source_.refuse(path, e.what());
    }
  }

  void check_name(const std::string& name, const Path& path) const {
    require_name(source_, name, path);
    if (std::ranges::find(out_.all, name, &Object::name) != out_.all.end())
      source_.refuse(path, fmt::format("\"{}\" is the name of another object", name));
  }

  viz::Setting& parameter(Object& o, const std::string& field) {
    o.fields.push_back(field);
    return out_.parameters[o.name + "." + field];
  }

  void fields(const Json& json, const Path& path, const TypeSpec& type, Object& o) {
    std::vector<std::string> allowed = {type.name};
    for (const FieldSpec& f : type.fields) allowed.push_back(f.name);
    source_.only(json, path, allowed, in_any);
    for (const FieldSpec& f : type.fields) {
      if (!json.contains(f.name) && f.optional) continue;
      const Json& value = source_.member(json, path, f.name);
      const Path to = below(path, f.name);
      viz::Setting& setting = parameter(o, f.name);
      if (f.means == Means::number || f.means == Means::radius || f.means == Means::end) {
        const double x = source_.number(value, to);
        if (x < f.lo) source_.refuse(to, fmt::format("{} is below {}", viz::to_text(x), viz::to_text(f.lo)));
        if (x > f.hi) source_.refuse(to, fmt::format("{} is above {}", viz::to_text(x), viz::to_text(f.hi)));
        setting = x;
      } else {
        setting = source_.vector(value, to);
      }
      if (f.means == Means::direction && std::get<viz::Vec3>(setting).isZero(0))
        source_.refuse(to, "a vector of any length but 0 is expected");
    }
    if (type.type == Type::obb && json.contains("w") == source_.flat())
      source_.refuse(path, source_.flat() ? "a third axis w in the plane" : "\"w\", the third axis, is missing");
    for (const ShapeRule& rule : type.rules)
      if (!rule.holds({out_.parameters, source_.flat()}, o))
        source_.refuse(below(path, rule.field), "give " + rule.allowed);
  }

  /// Reads "normals", and as many numbers "lo" and "hi".
  void slabs(const Json& json, const Path& path, Object& o) {
    source_.only(json, path, {"kdop", "normals", "lo", "hi"}, in_any);
    const Path to = below(path, "normals");
    const Json& normals = source_.list(source_.member(json, path, "normals"), to, 1, most_slabs, "normals");
    for (std::size_t i = 0; i < normals.size(); ++i) {
      o.fixed.normals.push_back(source_.vector(normals[i], below(to, std::to_string(i))));
      if (o.fixed.normals.back().isZero(0)) source_.refuse(to, "a vector of any length but 0 is expected");
    }
    for (const char* end : {"lo", "hi"}) {
      const Json& all = source_.list(source_.member(json, path, end), below(path, end), normals.size(), normals.size(),
                                     "numbers, one a normal,");
      for (std::size_t i = 0; i < all.size(); ++i)
        parameter(o, end + std::to_string(i + 1)) = source_.number(all[i], below(path, end));
    }
  }

  /// Reads "points": a list of points, or "file"; for a polygon with holes "rings": a list of such lists; for a mesh
  /// "triangles". "at" moves all of them.
  void points(const Json& json, const Path& path, Object& o) {
    const bool mesh = o.type == Type::mesh, outline = o.type == Type::triangle || o.type == Type::polygon;
    std::vector<std::string> allowed = {spec(o.type).name, "points"};
    if (o.type == Type::polygon) allowed.push_back("rings");
    if (o.type != Type::triangle) allowed.push_back("file");
    if (mesh) allowed.push_back("triangles");
    if (spec(o.type).with_at) allowed.push_back("at");
    source_.only(json, path, allowed, in_any);
    const int given = json.contains("points") + json.contains("rings") + json.contains("file");
    if (given != 1) {
      allowed.erase(allowed.begin());
      std::erase_if(allowed, [](const std::string& field) { return field == "triangles" || field == "at"; });
      source_.refuse(path,
                     given == 0 ? "\"points\" is missing" : fmt::format("give one of: {}", fmt::join(allowed, ", ")));
    }
    std::vector<std::vector<viz::Vec3>> rings;
    const std::size_t least = mesh || outline ? 3 : 1, most = o.type == Type::triangle ? 3 : most_vertices;
    if (json.contains("file"))
      rings = from_file(json, below(path, "file"), o);
    else if (json.contains("points"))
      rings.push_back(ring(json["points"], below(path, "points"), least, most));
    else
      for (const Json& one : source_.list(json["rings"], below(path, "rings"), 1, most_vertices, "lists of points"))
        rings.push_back(ring(one, below(path, "rings"), least, most));
    if (rings.size() > 1 && !source_.flat()) source_.refuse(path, "holes are for polygons in the plane");
    if (mesh && !json.contains("file")) o.fixed.triangles = triangles(json, path, rings.front().size());
    if (o.type == Type::polygon && !source_.flat() && o.note.empty()) o.note = off_plane_note(rings.front());
    keep(rings, o);
    if (json.contains("at")) parameter(o, "at") = source_.vector(json["at"], below(path, "at"));
  }

  /// Returns nothing for corners that are coplanar to six digits.
  static std::string off_plane_note(const std::vector<viz::Vec3>& corners) {
    viz::Vec3 lo = corners.front(), hi = lo;
    for (const viz::Vec3& v : corners) lo = lo.cwiseMin(v), hi = hi.cwiseMax(v);
    const double off = off_plane(corners);
    constexpr double as_written = 1e-6;
    if (!(off > as_written * (hi - lo).norm())) return "";
    return viz::tr("Its corners lie up to {off} off one plane: what is asked are the triangles that it is cut into.",
                   {{"off", viz::shown(off)}});
  }

  void keep(const std::vector<std::vector<viz::Vec3>>& rings, Object& o) {
    std::size_t count = 0;
    for (const auto& one : rings) o.rings.push_back(static_cast<int>(one.size())), count += one.size();
    const bool fixed = count > most_knobs || o.type == Type::mesh;
    for (const auto& one : rings)
      for (const viz::Vec3& p : one)
        if (fixed)
          o.fixed.points.push_back(p);
        else
          parameter(o, std::to_string(o.fields.size() + 1)) = p;
  }

  std::vector<viz::Vec3> ring(const Json& json, const Path& path, std::size_t least, std::size_t most) {
    std::vector<viz::Vec3> all;
    if (json.is_array() && json.size() > most_vertices && most == most_vertices)
      source_.refuse(path, fmt::format("{} points; here {} are the most, in a \"file\" {}", json.size(), most_vertices,
                                       most_in_file));
    source_.list(json, path, least, most, "points");
    for (std::size_t i = 0; i < json.size(); ++i)
      all.push_back(source_.vector(json[i], below(path, std::to_string(i))));
    return all;
  }

  std::vector<std::array<int, 3>> triangles(const Json& json, const Path& path, std::size_t points) const {
    std::vector<std::array<int, 3>> all;
    const Path to = below(path, "triangles");
    for (const Json& one : source_.list(source_.member(json, path, "triangles"), to, 1, most_vertices, "triangles")) {
      source_.list(one, to, 3, 3, "numbers of points, from 0,");
      std::array<int, 3> t = {};
      for (std::size_t i = 0; i < 3; ++i) {
        if (!one[i].is_number_integer() || one[i] < 0 || one[i] >= points)
          source_.refuse(to, fmt::format("{} is no number of a point; they are 0 to {}", one[i].dump(), points - 1));
        t[i] = one[i];
      }
      all.push_back(t);
    }
    return all;
  }

  std::vector<std::vector<viz::Vec3>> from_file(const Json& json, const Path& path, Object& o) {
    const std::string name = source_.text(json["file"], path);
    const std::string file = (std::filesystem::path(folder_) / name).lexically_normal().string();
    ShapeFile shape;
    try {
      shape = read_shape_file(file);
    } catch (const viz::BadInput& e) {
      source_.refuse(path, e.what());
    } catch (const viz::FileError& e) {
      throw viz::FileError(fmt::format("{} ({})", e.what(), source_.place(path)));
    }
    source_.need_dimension(shape.flat ? 2 : 3, path);
    if (o.type == Type::mesh && shape.triangles.empty()) source_.refuse(path, file + " holds no triangles");
    if (o.type == Type::polygon) become_outlines(shape, file, path);
    if (o.type == Type::mesh) o.fixed.triangles = shape.triangles;
    o.note = shape.note;
    if (o.type == Type::mesh && !shape.note_of_faces.empty())
      o.note = shape.note_of_faces + (o.note.empty() ? "" : " " + o.note);
    take_along(shape, file, o.type);
    std::vector<std::vector<viz::Vec3>> rings;
    auto from = shape.points.begin();
    for (const int size : shape.rings) rings.emplace_back(from, from + size), from += size;
    if (rings.empty() || o.type != Type::polygon) rings = {std::move(shape.points)};
    return rings;
  }

  /// Makes outlines of the corners of a polygon, of a mesh's only face, or of points in their order.
  void become_outlines(ShapeFile& shape, const std::string& file, const Path& path) const {
    if (!shape.triangles.empty()) {
      if (shape.only_face.empty())
        source_.refuse(path, file + " holds more than one face; a polygon is one, a \"mesh\" has many");
      std::vector<viz::Vec3> corners;
      for (const int i : shape.only_face) corners.push_back(shape.points[static_cast<std::size_t>(i)]);
      shape.points = std::move(corners);
    }
    if (shape.points.size() < 3) source_.refuse(path, file + " holds fewer than three points");
  }

  void take_along(const ShapeFile& shape, const std::string& file, Type type) {
    Json& json = out_.json.back();
    if (std::max(shape.points.size(), shape.triangles.size()) > most_taken_along) {
      json["file"] = file;  // relative to where the figure is opened
      return;
    }
    json.erase("file");
    Json points = Json::array();
    for (const viz::Vec3& p : shape.points) {
      points.push_back({p.x(), p.y()});
      if (!shape.flat) points.back().push_back(p.z());
    }
    if (type == Type::polygon && shape.rings.size() > 1) {
      auto from = points.begin();
      for (const int size : shape.rings) json["rings"].push_back(Json(from, from + size)), from += size;
      return;
    }
    json["points"] = std::move(points);
    if (type == Type::mesh) json["triangles"] = shape.triangles;
  }

  Source& source_;
  const std::string& folder_;
  ReadObjects out_;
  std::set<unsigned> colours_;
};

}  // namespace

ReadObjects read_objects(Source& source, const std::string& folder) { return ObjectReader(source, folder).read(); }

void require_name(const Source& source, const std::string& name, const Path& path) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  if (name.empty() || name.size() > 16 || !std::ranges::all_of(name, fits) || (name[0] >= '0' && name[0] <= '9'))
    source.refuse(path, "a name of 1 to 16 letters and digits is expected (a to z and A to Z), a letter first");
}

StepRange read_steps(const Source& source, const Json& json, const Path& path) {
  constexpr int most = 10'000;
  StepRange range;
  const auto read = [&](const char* field, int& to) {
    if (!json.contains(field)) return;
    const Json& step = json[field];
    if (!step.is_number_integer() || step < 1 || step > most)
      source.refuse(below(path, field), fmt::format("the number of a step is expected, from 1 to {}", most));
    to = step;
  };
  read("from step", range.first), read("to step", range.last);
  if (range.last < range.first) source.refuse(below(path, "to step"), "it is below \"from step\"");
  return range;
}

std::size_t object_named(const Source& source, const std::vector<Object>& objects, const Json& value,
                         const Path& path) {
  const std::string name = source.text(value, path);
  const auto found = std::ranges::find(objects, name, &Object::name);
  if (found != objects.end()) return static_cast<std::size_t>(found - objects.begin());
  std::vector<std::string> names;
  for (const Object& o : objects) names.push_back(o.name);
  source.refuse(path, fmt::format("no object is called \"{}\"{}", name,
                                  spelling::instead(name, names, "there are " + spelling::listed(names))));
}

}  // namespace isect::program::scene
