#include "app/scene/objects.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "app/scene/types/rows.h"
#include "viz/text/rich_text.h"

namespace isect::program::scene {

using viz::Vec3;

const std::vector<TypeSpec>& types() {
  static const std::vector<TypeSpec> all = [] {
    std::vector<TypeSpec> rows;
    for (const auto& some :
         {straight_types(), round_types(), box_types(), outline_types(), polytope_types(), many_types()})
      std::ranges::copy(some, std::back_inserter(rows));
    std::ranges::sort(rows, {}, &TypeSpec::type);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].type != static_cast<Type>(i)) throw std::logic_error("a type of objects has no row, or two");
    return rows;
  }();
  return all;
}

const TypeSpec& spec(Type type) { return types()[static_cast<std::size_t>(type)]; }

std::string other_name(const TypeSpec& type) { return type.in_plane == type.words ? "" : type.in_plane; }

Vec3 NamedValues::point(const Object& o, const std::string& field) const {
  return std::get<Vec3>(parameters.at(o.name + "." + field));
}
double NamedValues::number(const Object& o, const std::string& field) const {
  return std::get<double>(parameters.at(o.name + "." + field));
}
bool NamedValues::has(const Object& o, const std::string& field) const {
  return parameters.contains(o.name + "." + field);
}

std::string in_words(Type t, bool flat) { return flat ? spec(t).in_plane : spec(t).words; }
std::string with_article(Type t) {
  const std::string name = spec(t).name;
  return (std::string("aeiou").find(name[0]) == std::string::npos ? "a " : "an ") + name;
}

bool runs_along_a_line(Type t) { return t == Type::ray || t == Type::line || t == Type::segment; }

std::vector<Vec3> NamedValues::points(const Object& o) const {
  std::vector<Vec3> all = o.fixed.points;
  if (all.empty())
    for (const int size : o.rings)
      for (int i = 0; i < size; ++i) all.push_back(point(o, std::to_string(all.size() + 1)));
  if (const Vec3 way = has(o, "at") ? point(o, "at") : Vec3::Zero(); !way.isZero(0))
    for (Vec3& p : all) p += way;
  return all;
}

std::vector<std::vector<Vec3>> NamedValues::rings(const Object& o) const {
  const std::vector<Vec3> all = points(o);
  std::vector<std::vector<Vec3>> rings;
  auto from = all.begin();
  for (const int size : o.rings) rings.emplace_back(from, from + size), from += size;
  return rings;
}

std::vector<Vec3> NamedValues::extent(const Object& o) const {
  return spec(o.type).extent ? spec(o.type).extent(*this, o) : points(o);
}

Json NamedValues::list(const Vec3& p) const {
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
