#include "viz/window/lesson_picture.h"

#include "viz/compose/compose.h"
#include "viz/walk/closing.h"

namespace isect::viz {

PixelBox draw_lesson(const Lesson& lesson, const Theme& theme, Renderer& renderer, double density) {
  constexpr double smaller = 2;  // than a scene: its texts can still be read
  const Walk walk = lesson.walk(lesson.presets.front().parameters);
  const Scene& scene = walk.steps[static_cast<std::size_t>(outcome(walk))].scene;
  const double width = smaller * picture_width, height = smaller * picture_height;
  const View view(frame(opening(lesson), {&scene}, width / height), width, height);
  const Drawing drawing{width, height, theme.background, compose(scene, view, theme).shapes};
  renderer.draw(drawing, density / smaller);
  return pixels(drawing, density / smaller);
}

}  // namespace isect::viz
