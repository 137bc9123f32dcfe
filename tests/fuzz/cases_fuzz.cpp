// Well-formed cases of every kind, their numbers drawn from the input: swapping the two shapes turns the relation
// around, and scaling all lengths by a power of two changes no verdict.

#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <isect/convex_hull.h>
#include "app/query/query.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/source.h"

namespace {

using Json = nlohmann::json;

/// How a field looks, and how it changes when all lengths are scaled: a length or a point does, a direction does not.
enum class Form {
  point,
  direction,
  length,
  interval,
  polygon,
  rings,
  box,
  obb,
  slabs,
  normals,
  segment,
  capsule,
  convex
};
struct FieldSpec {
  const char* name;
  Form form;
};
struct KindSpec {
  const char* kind;
  int least, most;  ///< dimensions
  std::vector<FieldSpec> fields;
};

const std::vector<KindSpec>& specs() {
  using enum Form;
  static const std::vector<KindSpec> all = {
      {"orient2d", 2, 2, {{"a", point}, {"b", point}, {"c", point}}},
      {"pip", 2, 2, {{"rings", rings}, {"point", point}}},
      {"ray_sphere", 2, 3, {{"origin", point}, {"dir", direction}, {"center", point}, {"radius", length}}},
      {"ray_box", 2, 3, {{"origin", point}, {"dir", direction}, {"lo", point}, {"hi", point}, {"tmax", length}}},
      {"ray_plane", 3, 3, {{"origin", point}, {"dir", direction}, {"normal", direction}, {"d", length}}},
      {"ray_polygon", 3, 3, {{"origin", point}, {"dir", direction}, {"polygon", polygon}}},
      {"point_point", 2, 3, {{"a", point}, {"b", point}, {"tol", length}}},
      {"interval_interval", 2, 2, {{"a", interval}, {"b", interval}}},
      {"box_box", 2, 3, {{"alo", point}, {"ahi", point}, {"blo", point}, {"bhi", point}}},
      {"sphere_sphere", 2, 3, {{"c1", point}, {"r1", length}, {"c2", point}, {"r2", length}}},
      {"sphere_box", 2, 3, {{"center", point}, {"radius", length}, {"lo", point}, {"hi", point}}},
      {"sphere_capsule", 2, 3, {{"center", point}, {"radius", length}, {"p", point}, {"q", point}, {"r", length}}},
      {"capsule_capsule", 2, 3, {{"a", capsule}, {"b", capsule}}},
      {"obb_obb", 3, 3, {{"a", obb}, {"b", obb}}},
      {"kdop_kdop", 2, 3, {{"normals", normals}, {"a", slabs}, {"b", slabs}}},
      {"ray_obb", 3, 3, {{"origin", point}, {"dir", direction}, {"", obb}}},
      {"ray_capsule", 2, 3, {{"origin", point}, {"dir", direction}, {"p", point}, {"q", point}, {"r", length}}},
      {"ray_outline", 2, 2, {{"origin", point}, {"dir", direction}, {"rings", rings}}},
      {"line_triangle", 3, 3, {{"origin", point}, {"dir", direction}, {"tri", polygon}}},
      {"segment_segment", 2, 2, {{"a", segment}, {"b", segment}}},
      {"segment_plane", 2, 3, {{"segment", segment}, {"normal", direction}, {"d", length}}},
      {"segment_box", 2, 3, {{"segment", segment}, {"lo", point}, {"hi", point}}},
      {"convex_polygons", 2, 2, {{"a", convex}, {"b", convex}}},
      {"polygon_plane", 2, 3, {{"polygon", polygon}, {"normal", direction}, {"d", length}}},
      {"polygon_box", 2, 3, {{"polygon", polygon}, {"lo", point}, {"hi", point}}},
      {"polygon_polygon", 2, 2, {{"a", rings}, {"b", rings}}},
      {"segment_polygon", 2, 2, {{"segment", segment}, {"rings", rings}}},
      {"point_box", 2, 3, {{"point", point}, {"lo", point}, {"hi", point}}},
      {"point_sphere", 2, 3, {{"point", point}, {"center", point}, {"radius", length}}},
      {"point_obb", 3, 3, {{"point", point}, {"", obb}}},
      {"point_capsule", 2, 3, {{"point", point}, {"p", point}, {"q", point}, {"r", length}}},
      {"point_line", 2, 3, {{"point", point}, {"origin", point}, {"dir", direction}}},
      {"point_plane", 2, 3, {{"point", point}, {"normal", direction}, {"d", length}}},
      {"plane_sphere", 3, 3, {{"normal", direction}, {"d", length}, {"center", point}, {"radius", length}}},
      {"plane_box", 3, 3, {{"normal", direction}, {"d", length}, {"lo", point}, {"hi", point}}},
      {"point_cylinder", 3, 3, {{"point", point}, {"p", point}, {"q", point}, {"r", length}}},
      {"point_cone", 3, 3, {{"point", point}, {"apex", point}, {"base", point}, {"r", length}}},
      {"ray_cylinder", 3, 3, {{"origin", point}, {"dir", direction}, {"p", point}, {"q", point}, {"r", length}}},
      {"ray_cone", 3, 3, {{"origin", point}, {"dir", direction}, {"apex", point}, {"base", point}, {"r", length}}},
      {"plane_cylinder", 3, 3, {{"normal", direction}, {"d", length}, {"p", point}, {"q", point}, {"r", length}}},
      {"plane_cone", 3, 3, {{"normal", direction}, {"d", length}, {"apex", point}, {"base", point}, {"r", length}}},
      {"sphere_cylinder", 3, 3, {{"center", point}, {"radius", length}, {"p", point}, {"q", point}, {"r", length}}},
      {"sphere_cone", 3, 3, {{"center", point}, {"radius", length}, {"apex", point}, {"base", point}, {"r", length}}},
      {"segment_cylinder", 3, 3, {{"segment", segment}, {"p", point}, {"q", point}, {"r", length}}},
      {"segment_cone", 3, 3, {{"segment", segment}, {"apex", point}, {"base", point}, {"r", length}}},
      {"cylinder_solid", 3, 3, {{"p", point}, {"q", point}, {"r", length}, {"normals", normals}, {"slabs", slabs}}},
      {"cone_solid", 3, 3, {{"apex", point}, {"base", point}, {"r", length}, {"normals", normals}, {"slabs", slabs}}},
      {"triangle_box", 3, 3, {{"tri", polygon}, {"lo", point}, {"hi", point}}},
  };
  return all;
}

Json list(Source& source, int count) {
  Json numbers = Json::array();
  for (int i = 0; i < count; ++i) numbers.push_back(source.number());
  return numbers;
}
Json points(Source& source, int count, int dimension) {
  Json all = Json::array();
  for (int i = 0; i < count; ++i) all.push_back(list(source, dimension));
  return all;
}

constexpr int slab_count = 4;

Json field(Source& source, Form form, int n, const char* kind) {
  switch (form) {
    case Form::length:
      return source.number();
    case Form::interval:
      return list(source, 2);
    case Form::segment:
      return points(source, 2, n);
    case Form::normals:
      return points(source, slab_count, n);
    case Form::polygon:
      return points(
          source, kind == std::string("triangle_box") || kind == std::string("line_triangle") ? 3 : source.below(7), n);
    case Form::rings: {
      Json rings = Json::array();
      for (int i = source.below(3); i >= 0; --i) rings.push_back(points(source, source.below(9), n));
      return rings;
    }
    case Form::convex: {
      isect::Ring<double, 2> drawn = {{0, 0}, {1, 0}, {0, 1}};
      for (int i = source.below(7); i > 0; --i) {
        const double x = source.number();
        drawn.push_back({x, source.number()});
      }
      Json vertices = Json::array();
      for (const auto& v : isect::convex_hull(drawn)) vertices.push_back({v[0], v[1]});
      return vertices;
    }
    case Form::slabs:
      return {{"lo", list(source, slab_count)}, {"hi", list(source, slab_count)}};
    case Form::obb: {
      Json axes = points(source, n, n);
      if (source.below(2) == 0)  // often an honest box
        for (int i = 0; i < n; ++i)
          for (int k = 0; k < n; ++k) axes[i][k] = i == k ? 1 : 0;
      return {{"c", list(source, n)}, {"u", axes}, {"e", list(source, n)}};
    }
    case Form::capsule:
      return {{"p", list(source, n)}, {"q", list(source, n)}, {"r", source.number()}};
    default:
      return list(source, n);
  }
}

/// All numbers of a field 2^10 times as large; `exact` turns false when one does not fit.
Json scaled(const Json& value, bool& exact) {
  if (value.is_number()) {
    const double x = value.get<double>(), y = std::ldexp(x, 10);
    exact = exact && std::ldexp(y, -10) == x && (x == 0 || std::abs(x) >= 0x1p-1022);
    return y;
  }
  Json all = value;
  for (Json& entry : all) entry = scaled(entry, exact);
  return all;
}

Json result(const Json& request) {
  const isect::query::Answer answer = isect::query::answer(request.dump());
  require(!answer.error, "a well-formed case is answered", request.dump() + "\n" + answer.text);
  return Json::parse(answer.text)["result"];
}

/// The fields that are not real numbers: verdicts, relations, counts.
Json verdicts(const Json& result) {
  Json kept = Json::object();
  for (const auto& [key, value] : result.items())
    if (value.is_string() || value.is_boolean() || value.is_number_integer()) kept[key] = value;
  kept.erase("t"), kept.erase("t0"), kept.erase("t1"), kept.erase("t_in"), kept.erase("t_out");
  kept.erase("t_first_surface"), kept.erase("t_enter_solid");  // "inf" is a text
  kept.erase("segment_hit_0_1");                               // t grows with the lengths
  return kept;
}

std::string turned(const std::string& relation) {
  const auto swap = [&](const std::string& from, const std::string& to) {
    std::string text = relation;
    return text.replace(text.find(from), from.size(), to);
  };
  if (relation.find("a_contains_b") != std::string::npos) return swap("a_contains_b", "b_contains_a");
  if (relation.find("b_contains_a") != std::string::npos) return swap("b_contains_a", "a_contains_b");
  return relation;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Source source(data, size);
  const KindSpec& spec = specs()[source.below(static_cast<int>(specs().size()))];
  const int n = spec.least + source.below(spec.most - spec.least + 1);
  Json request = {{"kind", spec.kind}}, larger = request;
  if (source.below(8) == 0) request["trace"] = true;
  bool exact = true;
  for (const FieldSpec& f : spec.fields) {
    const Json value = field(source, f.form, n, spec.kind);
    Json grown = f.form == Form::direction || f.form == Form::normals ? value : scaled(value, exact);
    if (f.form == Form::obb) grown["u"] = value["u"];
    if (*f.name == 0) {
      request.update(value), larger.update(grown);
    } else {
      request[f.name] = value, larger[f.name] = grown;
    }
  }

  const Json answer = result(request);
  const bool certain = request["kind"] != "polygon_box";  // which cuts what an earlier cut rounded
  if (exact && certain)
    require(verdicts(answer) == verdicts(result(larger)), "scaling changes no verdict", request.dump());

  static constexpr const char* pairs[][2] = {{"a", "b"}, {"alo", "blo"}, {"ahi", "bhi"}, {"c1", "c2"}, {"r1", "r2"}};
  if (answer.contains("relation") && (request.contains("b") || request.contains("blo") || request.contains("c2"))) {
    Json swapped = request;
    for (const auto& [a, b] : pairs)
      if (request.contains(a)) swapped[a] = request[b], swapped[b] = request[a];
    require(result(swapped)["relation"] == turned(answer["relation"]), "a swap turns the relation", request.dump());
  }
  return 0;
}
