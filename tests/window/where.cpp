// Prints where a widget of the window stands at 1280 x 800, so that a test with a real pointer can aim at it:
// where LESSON STEP WIDGET -> "x y"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "lessons/lessons.h"
#include "tests/viz/window_driver.h"

using namespace isect::viz;

int main(int argc, char** argv) try {
  if (argc != 4) throw std::runtime_error("usage: where LESSON STEP WIDGET");
  Place place;
  place.lesson = argv[1];
  place.step = std::atoi(argv[2]) - 1;
  const WindowDriver window(isect::lessons::all_lessons(), 1280, 800, place);
  const Rect r = window.rect(argv[3]);
  std::printf("%.0f %.0f\n", r.middle_x(), r.middle_y());
} catch (const std::exception& failed) {
  std::fprintf(stderr, "where: %s\n", failed.what());
  return 1;
}
