#include "tests/cases/case_file.h"

#include <charconv>
#include <map>

namespace isect::cases {

namespace {

template <class S>
std::string shortest(S x) {
  if (x == 0) return std::signbit(x) ? "-0.0" : "0";
  char digits[64];
  return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

/// A float's own digits, unless reading them as a double first would round to another.
std::string number(double x, bool f32) {
  if (!f32) return shortest(x);
  const std::string text = shortest(static_cast<float>(x));
  return static_cast<double>(static_cast<float>(std::strtod(text.c_str(), nullptr))) == x ? text : shortest(x);
}

void write(std::string& out, const Json& json, bool f32) {
  const char* between = "";
  if (json.is_number_float()) {
    out += number(json, f32);
  } else if (json.is_array()) {
    out += '[';
    for (const Json& entry : json) out += between, write(out, entry, f32), between = ", ";
    out += ']';
  } else if (json.is_object()) {
    out += '{';
    for (const auto& [key, value] : json.items())
      out += between + Json(key).dump() + ": ", write(out, value, f32), between = ", ";
    out += '}';
  } else {
    out += json.dump();
  }
}

/// The answer without its numbers.
std::string verdict(const Case& c) {
  Json words = c.expected;
  for (auto& [key, value] : words.items())
    if (value.is_number_float() || value.is_array()) value = "some";
  return words.dump();
}

}  // namespace

void CaseFile::add(const std::string& note, const Case& c) { cases_.push_back({note, c}); }

void CaseFile::family(const std::string& note, int count, const std::function<std::optional<Case>(Random&)>& draw) {
  Random random(bench::stream(1, (kind_ + ": " + note).c_str()));
  std::map<std::string, int> often;
  constexpr int patience = 200;  // draws, until any verdict is welcome
  for (int tries = 0, taken = 0; taken < count && tries < 3 * patience; ++tries) {
    const std::optional<Case> c = draw(random);
    if (!c) continue;
    int& times = often[verdict(*c)];
    if (times >= (count + 2) / 3 && tries < patience) continue;
    add(note, *c);
    ++times, ++taken;
  }
}

std::string CaseFile::text() const {
  std::string out = "{\"source\": \"tests/cases, written by make_cases\", \"kind\": \"" + kind_ + "\", \"cases\": [\n";
  for (const auto& [note, c] : cases_) {
    out += "{\"note\": " + Json(note).dump() + ", ";
    if (c.f32) out += "\"scalar\": \"f32\", ";
    for (const auto& [key, value] : c.inputs.items())
      out += Json(key).dump() + ": ", write(out, value, c.f32), out += ", ";
    out += "\"expected\": ";
    write(out, c.expected, false);
    out += &c == &cases_.back().what ? "}\n" : "},\n";
  }
  return out + "]}\n";
}

std::string written(const Json& json) {
  std::string out;
  write(out, json, false);
  return out;
}

std::vector<CaseFile> all() {
  return {orient2d(),
          interval_interval(),
          point_obb(),
          point_point(),
          point_box(),
          point_sphere(),
          point_capsule(),
          point_cylinder(),
          point_cone(),
          point_line(),
          point_plane(),
          plane_sphere(),
          plane_box(),
          plane_cylinder(),
          plane_cone(),
          box_box(),
          sphere_sphere(),
          sphere_box(),
          sphere_capsule(),
          sphere_cylinder(),
          sphere_cone(),
          capsule_capsule(),
          obb_obb(),
          kdop_kdop(),
          triangle_box(),
          ray_sphere(),
          ray_box(),
          ray_plane(),
          ray_obb(),
          ray_capsule(),
          ray_cylinder(),
          ray_cone(),
          segment_cylinder(),
          segment_cone(),
          cylinder_solid(),
          cone_solid(),
          ray_outline(),
          line_triangle(),
          segment_plane(),
          segment_box(),
          segment_segment(),
          ray_polygon(),
          pip(),
          polygon_polygon(),
          convex_polygons(),
          polygon_plane(),
          polygon_box(),
          segment_polygon(),
          convex_hull2d(),
          polygon_normal(),
          bounding_volume_fit()};
}

}  // namespace isect::cases
