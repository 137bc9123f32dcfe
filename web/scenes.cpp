#include "web/scenes.h"

#include "app/scene/files/shape_file.h"
#include "app/scene/lesson.h"
#include "app/scene/save.h"
#include "viz/files.h"

namespace isect::program::scene {

/// A page reads no other files, so it goes without their readers.
ShapeFile read_shape_file(const std::string& path) { return viz::read_regular_file(path), ShapeFile(); }

}  // namespace isect::program::scene

namespace isect::web {

Scene read_scene(const std::string& text) {
  const program::scene::File file = program::scene::read_scene(text, "");
  return {&program::scene::kept_lesson_of(text, ""),
          [text, file](const viz::Parameters& to) { return program::scene::with_numbers(text, file, to); }};
}

}  // namespace isect::web
