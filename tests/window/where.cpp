// Prints where a widget of the window stands at 1280 x 800, so that a test with a real pointer can aim at it:
// where LESSON STEP WIDGET -> "x y"
// or how many times Down is to be pressed until the keyboard holds it, the parameters being open:
// where LESSON STEP WIDGET downs -> "n"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "lessons/lessons.h"
#include "tests/viz/window_driver.h"

using namespace isect::viz;

int main(int argc, char** argv) try {
  const bool downs = argc == 5 && std::strcmp(argv[4], "downs") == 0;
  if (argc != 4 && !downs) throw std::runtime_error("usage: where LESSON STEP WIDGET [downs]");
  ReaderState state;
  state.lesson = argv[1];
  state.step = std::atoi(argv[2]) - 1;
  Settings settings;
  settings.parameters_open = downs;
  WindowDriver window(isect::lessons::all_lessons(), 1280, 800, state, settings);
  if (!downs) {
    const Rect r = window.rect(argv[3]);
    std::printf("%.0f %.0f\n", r.middle_x(), r.middle_y());
    return 0;
  }
  for (int n = 1; n < 200; ++n) {
    window.key(key::down);
    if (window.ui.focus() != argv[3]) continue;
    std::printf("%d\n", n);
    return 0;
  }
  throw std::runtime_error(std::string("Down leads to no widget called ") + argv[3]);
} catch (const std::exception& failed) {
  std::fprintf(stderr, "where: %s\n", failed.what());
  return 1;
}
