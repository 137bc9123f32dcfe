#include "web/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/scene/editor.h"
#include "app/scene/files/shape_file.h"
#include "app/scene/lesson.h"
#include "app/scene/save.h"
#include "viz/text/rich_text.h"

namespace isect::web {

namespace {

using program::scene::ShapeFile;
using viz::Vec3;

/// The most points, and the most triangles, of a file that a page draws at every move of the mouse.
constexpr std::size_t most_on_page = 20'000;

void need_few(const std::string& name, std::size_t count, const char* what) {
  if (count > most_on_page)
    throw viz::BadInput(fmt::format("{}: {} {}; a page takes up to {}, and the program isect up to {}", name, count,
                                    what, most_on_page, program::scene::most_in_file));
}

std::string in_quotes_of_json(const std::string& text) { return BrowserSession::Json(text).dump(); }

/// Writes a coordinate to a hundredth of the object's size, or in full where that has too many digits.
std::string written(double x, double size) {
  const double digits = std::floor(std::log10(size));
  if (!(std::abs(digits) <= 9)) return viz::to_text(x);
  std::string text = fmt::format("{:.{}f}", x, std::max(0, 2 - static_cast<int>(digits)));
  if (text.find('.') == text.npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

/// Writes a scene of the file's one object and, where that has an inside, of another one that asks about it.
std::string scene_of(const std::string& name, const ShapeFile& shape) {
  Vec3 lo = shape.points.front(), hi = lo;
  for (const Vec3& p : shape.points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  const double wide = (hi - lo).maxCoeff(), size = wide > 0 && std::isfinite(wide) ? wide : 1;
  const auto point = [&](const Vec3& p) {
    const std::string in_plane = written(p.x(), size) + ", " + written(p.y(), size);
    return "[" + in_plane + (shape.flat ? "" : ", " + written(p.z(), size)) + "]";
  };
  const auto within = [&](double x, double y, double z) -> Vec3 { return lo + (hi - lo).cwiseProduct(Vec3(x, y, z)); };
  const std::string file = in_quotes_of_json(name);
  const auto scene = [&](const std::string& type, const std::string& other, const std::string& ask) {
    return fmt::format(
        "{{\n  \"title\": {},\n  \"objects\": [\n    {{{}, \"file\": {}}}{}\n  ],\n  \"ask\": [{}]\n}}\n",
        in_quotes_of_json(viz::as_markup(std::filesystem::path(name).stem().string())), type, file,
        other.empty() ? "" : ",\n    " + other, ask);
  };
  if (!shape.triangles.empty() && !shape.flat) {
    const Vec3 origin = within(0, 0.4, 0.35) - Vec3(size / 2, 0, 0);
    return scene("\"mesh\": \"M\"",
                 fmt::format("{{\"ray\": \"r\", \"origin\": {}, \"dir\": [1, 0, 0]}}", point(origin)),
                 "[\"r\", \"M\"], {\"fit\": \"M\", \"volume\": \"box\"}, {\"hierarchy\": \"M\"}");
  }
  if (!shape.rings.empty() && shape.flat)
    return scene("\"polygon\": \"P\"", fmt::format("{{\"point\": \"p\", \"at\": {}}}", point(within(0.45, 0.55, 0))),
                 "[\"p\", \"P\"]");
  return scene("\"cloud\": \"C\"", "",
               "{\"fit\": \"C\", \"volume\": \"box\"}, {\"fit\": \"C\", \"volume\": \"sphere\"}");
}

/// Writes a scene that holds the points of the files it named, an object a line.
std::string with_points(const program::scene::File& file) {
  const auto scene = BrowserSession::Json::parse(file.text);
  std::string out;
  for (const auto& [field, value] : scene.items()) {
    std::string told = value.dump();
    if (field == "objects") {
      told.clear();
      for (const BrowserSession::Json& object : value) told += (told.empty() ? "[\n    " : ",\n    ") + object.dump();
      told += "\n  ]";
    }
    out += fmt::format("{}  {}: {}", out.empty() ? "{\n" : ",\n", in_quotes_of_json(field), told);
  }
  return out + "\n}\n";
}

}  // namespace

Scene read_scene(const std::string& text) {
  const program::scene::File file = program::scene::read_scene(text, "");
  const auto with_numbers = [text, file](const viz::Parameters& to) {
    try {
      return program::scene::with_numbers(text, file, to);
    } catch (const viz::BadInput&) {  // a point of another file was moved, which a page can't write
      return program::scene::with_numbers(with_points(file), file, to);
    }
  };
  const viz::Lesson& lesson = program::scene::kept_lesson_of(text, "");
  const viz::SceneEditor editor = program::scene::editor();
  const auto sides = [&lesson, of = editor.sides](const viz::Parameters& now) { return of(lesson, now); };
  const auto edited = [&lesson, made = editor.edited](const viz::Parameters& now, const viz::SceneEdit& edit) {
    const viz::Lesson& other = made(lesson, now, edit);
    return *program::scene::text_with(other, other.presets.front().parameters);
  };
  return {&lesson, with_numbers, sides, edited};
}

std::string take_file(const std::string& name, const std::string& bytes) {
  ShapeFile shape = program::scene::read_shape(bytes, name);
  need_few(name, shape.points.size(), "points");
  need_few(name, shape.triangles.size(), "triangles");
  std::string text = scene_of(name, shape);
  program::scene::give_shape_file(name, std::move(shape));
  return text;
}

}  // namespace isect::web
