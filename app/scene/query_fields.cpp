// The fields of pairs of objects as `isect query` reads them.

#include <string>

#include "app/scene/pairs.h"
#include "app/scene/types.h"

namespace isect::program::scene {

namespace {

Json rings_of(const NamedValues& s, const Object& o) {
  Json rings = Json::array();
  for (const auto& ring : s.rings(o)) {
    rings.push_back(Json::array());
    for (const viz::Vec3& p : ring) rings.back().push_back(s.list(p));
  }
  return rings;
}

Json ray_fields(const NamedValues& s, const Object& o) {
  if (o.type == Type::segment)
    return {
        {"origin", s.list(o, "from")}, {"dir", s.list(viz::Vec3(s.point(o, "to") - s.point(o, "from")))}, {"tmax", 1}};
  Json ray = {{"origin", s.list(o, "origin")}, {"dir", s.list(o, "dir")}};
  if (o.type == Type::line) ray["tmin"] = "-inf";
  for (const char* end : {"tmin", "tmax"})
    if (s.has(o, end)) ray[end] = s.number(o, end);
  return ray;
}

/// Returns the fields of an object beside one of another type.
Json fields_of(const NamedValues& s, const Object& o) {
  switch (o.type) {
    case Type::point:
      return {{"point", s.list(o, "at")}};
    case Type::obb: {
      Json axes = {s.list(o, "u"), s.list(o, "v")};
      if (!s.flat) axes.push_back(s.list(o, "w"));
      return {{"c", s.list(o, "center")}, {"u", axes}, {"e", s.list(o, "half")}};
    }
    case Type::segment:
    case Type::ray:
    case Type::line:
      return ray_fields(s, o);
    default:
      break;
  }
  Json all;
  for (const FieldSpec& field : spec(o.type).fields) {
    const bool number = field.means == Means::number || field.means == Means::radius;
    all[field.name] = number ? Json(s.number(o, field.name)) : s.list(o, field.name);
  }
  return all;
}

/// Returns the fields of an outline, and of what it is asked about with.
Json with_outline(const Shaped& a, const Shaped& b) {
  const NamedValues& s = a.numbers;
  Json fields;
  if (a.type() == Type::point) {
    fields = {{"rings", rings_of(s, b.object)}};
    fields.update(fields_of(s, a.object));
  } else if (a.type() == Type::triangle) {
    fields = {{"tri", rings_of(s, a.object).front()}};
    fields.update(fields_of(s, b.object));
  } else {
    fields = fields_of(s, a.object);
    fields["polygon"] = rings_of(s, b.object).front();
  }
  return fields;
}

Json of_one_type(const NamedValues& s, const Object& a, const Object& b) {
  switch (a.type) {
    case Type::sphere:
      return {{"c1", s.list(a, "center")},
              {"r1", s.number(a, "radius")},
              {"c2", s.list(b, "center")},
              {"r2", s.number(b, "radius")}};
    case Type::box:
      return {{"alo", s.list(a, "lo")}, {"ahi", s.list(a, "hi")}, {"blo", s.list(b, "lo")}, {"bhi", s.list(b, "hi")}};
    case Type::segment:
      return {{"a", {s.list(a, "from"), s.list(a, "to")}}, {"b", {s.list(b, "from"), s.list(b, "to")}}};
    case Type::point:
      return {{"a", s.list(a, "at")}, {"b", s.list(b, "at")}};
    default:
      return {{"a", fields_of(s, a)}, {"b", fields_of(s, b)}};
  }
}

}  // namespace

Json query_of(const char* kind, const Shaped& a, const Shaped& b) {
  const auto is_outline = [](const Shaped& x) { return x.type() == Type::triangle || x.type() == Type::polygon; };
  Json fields;
  if (a.type() == b.type()) {
    fields = of_one_type(a.numbers, a.object, b.object);
  } else if (is_outline(a) || is_outline(b)) {
    fields = with_outline(a, b);
  } else {
    fields = fields_of(a.numbers, a.object);
    fields.update(fields_of(b.numbers, b.object));
  }
  Json query = {{"kind", kind}};
  query.update(fields);
  return query;
}

}  // namespace isect::program::scene
