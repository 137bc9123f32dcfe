#include "app/scene/objects.h"

#include <algorithm>
#include <iterator>

#include "app/scene/shapes.h"
#include "viz/rich_text.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;
using Kind = FieldSpec::Kind;

std::vector<Vec3> corners_of(const Setting& s, const Object& o) {
  if (o.type == Type::frustum) return viz::solid(frustum_of(s, o), viz::Role::second).vertices;
  return s.flat ? outline_of(s, o) : solid_of(s, o).vertices;
}

}  // namespace

const std::vector<TypeSpec>& types() {
  static const std::vector<TypeSpec> all = {
      {Type::point, "point", {{"at", Kind::point, "where it lies"}}},
      {Type::segment, "segment", {{"from", Kind::point, "one end"}, {"to", Kind::point, "the other end"}}},
      {Type::ray,
       "ray",
       {{"origin", Kind::point, "where t = 0"},
        {"dir", Kind::vector, "the direction, of any length but 0"},
        {"tmin", Kind::number, "where it begins; 0 if not given", true},
        {"tmax", Kind::number, "where it ends; nowhere if not given", true}}},
      {Type::line,
       "line",
       {{"origin", Kind::point, "where t = 0"}, {"dir", Kind::vector, "the direction, of any length but 0"}}},
      {Type::plane,
       "plane",
       {{"normal", Kind::vector, "the normal n, of any length but 0"}, {"d", Kind::number, "n . x + d = 0"}}},
      {Type::sphere,
       "sphere",
       {{"center", Kind::point, "the centre"}, {"radius", Kind::number, "the radius", false, 0}}},
      {Type::box, "box", {{"lo", Kind::point, "the lowest corner"}, {"hi", Kind::point, "the highest corner"}}},
      {Type::obb,
       "obb",
       {{"center", Kind::point, "the centre"},
        {"u", Kind::vector, "the first axis, of length 1"},
        {"v", Kind::vector, "the second axis, of length 1"},
        {"w", Kind::vector, "the third axis, of length 1; none in the plane", true},
        {"half", Kind::point, "the half-lengths along the axes"}}},
      {Type::capsule,
       "capsule",
       {{"p", Kind::point, "one end of its axis"},
        {"q", Kind::point, "the other end"},
        {"r", Kind::number, "the radius", false, 0}}},
      {Type::triangle, "triangle", {}},
      {Type::polygon, "polygon", {}},
      {Type::kdop, "kdop", {}},
      {Type::frustum,
       "frustum",
       {{"eye", Kind::point, "where its planes would meet"},
        {"forward", Kind::vector, "where the eye looks, of any length but 0"},
        {"up", Kind::vector, "what is up there, not along forward"},
        {"angle", Kind::number, "from bottom to top, in degrees", false, 1, 170},
        {"aspect", Kind::number, "width to height; 1 if not given", true, 0.01, 100},
        {"near", Kind::number, "distance of the near plane", false, 0},
        {"far", Kind::number, "distance of the far plane", false, 0}}},
      {Type::hull, "hull", {}},
      {Type::mesh, "mesh", {}},
      {Type::cloud, "cloud", {}},
  };
  return all;
}

const TypeSpec& spec(Type type) { return *std::ranges::find(types(), type, &TypeSpec::type); }

Vec3 Setting::point(const Object& o, const std::string& field) const {
  return std::get<Vec3>(parameters.at(o.name + "." + field));
}
double Setting::number(const Object& o, const std::string& field) const {
  return std::get<double>(parameters.at(o.name + "." + field));
}
bool Setting::has(const Object& o, const std::string& field) const { return parameters.contains(o.name + "." + field); }

std::string in_words(Type t, bool flat) {
  switch (t) {
    case Type::sphere:
      return flat ? other_name_of_sphere : "sphere";
    case Type::obb:
      return "oriented box";
    case Type::kdop:
      return "k-DOP";
    case Type::cloud:
      return "point cloud";
    default:
      return spec(t).name;
  }
}
std::string with_article(Type t) {
  const std::string name = spec(t).name;
  return (std::string("aeiou").find(name[0]) == std::string::npos ? "a " : "an ") + name;
}

bool runs_along_a_line(Type t) { return t == Type::ray || t == Type::line || t == Type::segment; }

std::vector<Vec3> Setting::points(const Object& o) const {
  if (!o.fixed.points.empty()) return o.fixed.points;
  std::vector<Vec3> all;
  for (const int size : o.rings)
    for (int i = 0; i < size; ++i) all.push_back(point(o, std::to_string(all.size() + 1)));
  return all;
}

std::vector<std::vector<Vec3>> Setting::rings(const Object& o) const {
  const std::vector<Vec3> all = points(o);
  std::vector<std::vector<Vec3>> rings;
  auto from = all.begin();
  for (const int size : o.rings) rings.emplace_back(from, from + size), from += size;
  return rings;
}

std::vector<Vec3> Setting::extent(const Object& o) const {
  const auto around = [](const Vec3& c, double r) {
    return std::vector<Vec3>{c - Vec3::Constant(r), c + Vec3::Constant(r)};
  };
  switch (o.type) {
    case Type::point:
      return {point(o, "at")};
    case Type::segment:
      return {point(o, "from"), point(o, "to")};
    case Type::ray:
      return {point(o, "origin")};
    case Type::sphere:
      return around(point(o, "center"), number(o, "radius"));
    case Type::box:
      return {point(o, "lo"), point(o, "hi")};
    case Type::obb:
      return around(point(o, "center"), point(o, "half").norm());
    case Type::capsule: {
      std::vector<Vec3> all = around(point(o, "p"), number(o, "r"));
      std::ranges::copy(around(point(o, "q"), number(o, "r")), std::back_inserter(all));
      return all;
    }
    case Type::triangle:
    case Type::polygon:
    case Type::hull:
    case Type::mesh:
    case Type::cloud:
      return points(o);
    case Type::kdop:
    case Type::frustum:
      return corners_of(*this, o);
    case Type::line:
    case Type::plane:
      return {};
  }
  return {};
}

Json Setting::list(const Vec3& p) const {
  Json all = {p.x(), p.y()};
  if (!flat) all.push_back(p.z());
  return all;
}

std::string shown_name(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  const std::string letters = "**" + viz::as_markup(name.substr(0, digits)) + "**";
  return digits == name.size() ? letters : letters + "_{" + name.substr(digits) + "}";
}

}  // namespace isect::program::scene
