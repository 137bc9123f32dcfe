// Any bytes as a scene file: a refusal in words, or a scene, whose text takes other numbers and reads the same again. A
// small scene is told as a lesson, asked, and answered as a line of a query, too.

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "app/scene/line.h"
#include "app/scene/save.h"
#include "tests/fuzz/require.h"
#include "viz/formats/files.h"
#include "viz/lesson.h"

namespace {

namespace scene = isect::program::scene;
namespace viz = isect::viz;

void require_same(const scene::File& a, const scene::File& b, const std::string& text) {
  require(a.flat == b.flat && a.title == b.title && a.parameters == b.parameters, "the same numbers", text);
  require(a.objects.size() == b.objects.size() && a.asked.size() == b.asked.size() && a.notes.size() == b.notes.size(),
          "as many objects, questions and notes", text);
  for (std::size_t i = 0; i < a.objects.size(); ++i)
    require(a.objects[i].type == b.objects[i].type && a.objects[i].name == b.objects[i].name &&
                a.objects[i].rings == b.objects[i].rings,
            "the same objects", text);
}

/// All numbers half as large: a sphere stays a sphere, and a box a box.
viz::Parameters halved(viz::Parameters parameters) {
  for (auto& [name, value] : parameters) {
    if (double* x = std::get_if<double>(&value)) *x /= 2;
    if (viz::Vec3* v = std::get_if<viz::Vec3>(&value)) *v /= 2;
  }
  return parameters;
}

void check_writing(const std::string& text, const scene::File& file) {
  require(scene::with_numbers(text, file, file.parameters) == text, "no other number, no other text", text);
  require_same(scene::read_scene(file.text, ""), file, text);
  const viz::Parameters to = halved(file.parameters);
  std::string changed;
  try {
    changed = scene::with_numbers(text, file, to);
  } catch (const viz::BadInput&) {  // a number in a file of its own
    return;
  }
  try {
    require(scene::read_scene(changed, "").parameters == to, "the numbers that were written", changed);
  } catch (const viz::BadInput&) {  // half a smallest number is none
  }
}

/// Whether it can be asked many times a second.
bool is_small(const scene::File& file) {
  std::size_t points = file.parameters.size();
  for (const scene::Object& o : file.objects) points += o.fixed.points.size() + o.fixed.normals.size();
  return file.objects.size() <= 6 && file.asked.size() <= 15 && points <= 60;
}

void check_answers(const std::string& text, const scene::File& file) {
  const scene::Json line = scene::Json::parse(scene::answer_line(scene::Json::parse(file.text).dump(), 1).text);
  require(line.contains("result") != line.contains("error"), "a result or an error", text);
  std::string refused;
  try {
    const scene::Json all = scene::answers(file);
    require(!line.contains("result") || line["result"].size() == all.size(), "as many answers to a line", text);
  } catch (const viz::BadInput& e) {
    refused = e.what();
  }
  try {
    const viz::Lesson lesson = scene::lesson_of(text, "");
    require(!lesson.walk(file.parameters).steps.empty(), "a step", text);
    lesson.walk(halved(file.parameters));
  } catch (const viz::BadInput& e) {
    require(*e.what() != '\0', "a refusal that says why", text + refused);
  }
}

void check(const std::string& text) {
  scene::holds_objects(text);
  const bool meant = scene::is_scene(text);
  const scene::File file = scene::read_scene(text, "");
  require(meant, "what reads as a scene is one", text);
  check_writing(text, file);
  if (is_small(file)) check_answers(text, file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const viz::BadInput&) {
  } catch (const viz::FileError&) {
  }
  return 0;
}
