#include "web/request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

#include "viz/text/number_text.h"

namespace isect::web {

namespace {

using viz::BadInput;
using viz::Vec2;
using viz::Vec3;
using Json = nlohmann::ordered_json;

/// Reads the numbers of a text, between which there stands `sign`.
std::vector<double> numbers_in(const std::string& text, char sign) {
  std::vector<double> all;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(sign, from), text.size());
    all.push_back(viz::number_from(text.substr(from, end - from)));
    from = end + 1;
  }
  return all;
}

/// Reads a point. In the plane the third number may be left out.
Vec3 point_from(const viz::Lesson& lesson, const viz::Parameter& p, const std::string& typed) {
  std::string text = typed;
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  if (first != text.npos && text[first] == '(' && text[last] == ')') text = text.substr(first + 1, last - first - 1);
  const std::vector<double> x = numbers_in(text, text.find(';') != text.npos ? ';' : ',');
  if (x.size() == 3) return {x[0], x[1], x[2]};
  if (x.size() == 2 && lesson.flat) return {x[0], x[1], 0};
  throw BadInput(fmt::format("{}: \"{}\" is not allowed; give {}", p.name, typed, viz::wanted(p)));
}

}  // namespace

Vec2 point_in(const Json& request) { return {request.at("x").get<double>(), request.at("y").get<double>()}; }

Vec2 way_in(const Json& request) { return {request.at("x").get<double>(), request.at("y").get<double>()}; }

void set_typed(const viz::Lesson& lesson, viz::Parameters& to, const std::string& name, const std::string& text) {
  const auto p = std::ranges::find(lesson.parameters, name, &viz::Parameter::name);
  if (p == lesson.parameters.end()) return viz::set(lesson, to, name, text);  // which says what there is
  if (std::holds_alternative<double>(p->initial)) return viz::set_value(lesson, to, name, viz::number_from(text));
  if (std::holds_alternative<Vec3>(p->initial)) return viz::set_value(lesson, to, name, point_from(lesson, *p, text));
  viz::set(lesson, to, name, text);
}

std::string camera_text(const viz::Camera& c) {
  return fmt::format("{},{},{},{},{},{},{}", c.azimuth, c.elevation, c.half_height, c.target.x(), c.target.y(),
                     c.target.z(), c.perspective ? 1 : 0);
}

viz::Camera camera_from(const std::string& text, const viz::Lesson& lesson) {
  const std::vector<double> n = numbers_in(text, ',');
  if (n.size() != 7 || !(n[2] > 0)) throw BadInput("camera: seven numbers, the third more than 0");
  viz::Camera camera = viz::opening(lesson);
  camera.azimuth = n[0], camera.elevation = std::clamp(n[1], -1.5707963, 1.5707963), camera.half_height = n[2];
  camera.target = {n[3], n[4], n[5]}, camera.perspective = n[6] != 0 && !lesson.flat;
  return camera;
}

std::string bytes_of(const std::string& base64) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> worth = {};
  worth.fill(-1);
  for (std::size_t i = 0; i < letters.size(); ++i) worth[static_cast<unsigned char>(letters[i])] = static_cast<int>(i);
  std::string bytes;
  bytes.reserve(base64.size() / 4 * 3 + 3);
  unsigned held = 0;  // of the last letters, those bits that make no byte yet, below others that have made one
  int count = 0;
  for (const char letter : base64.substr(0, base64.find('='))) {
    const int six = worth[static_cast<unsigned char>(letter)];
    if (six < 0) throw BadInput("this is no base64");
    held = held << 6 | static_cast<unsigned>(six), count += 6;
    if (count >= 8) count -= 8, bytes += static_cast<char>(held >> count & 0xFFu);
  }
  return bytes;
}

}  // namespace isect::web
