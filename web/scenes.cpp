#include "web/scenes.h"

#include "app/scene/lesson.h"
#include "app/scene/save.h"

namespace isect::web {

Scene read_scene(const std::string& text) {
  const program::scene::File file = program::scene::read_scene(text, "");
  return {&program::scene::kept_lesson_of(text, ""),
          [text, file](const viz::Parameters& to) { return program::scene::with_numbers(text, file, to); }};
}

}  // namespace isect::web
