// Everything larger or smaller, on the whole screen, at any density.

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"

namespace size_test {
using namespace isect;
using namespace isect::viz;

TEST_CASE("Ctrl and + or - changes the size of everything, Ctrl+0 takes it back", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1920, 1080);
  const float bar = window.rect("top bar").width();
  const Rect play = window.rect("play");
  for (int i = 0; i < 5; ++i) window.key(key::plus, true);
  CHECK(window.ui.settings().size == Approx(1.5));
  CHECK(window.ui.scale() == Approx(1.5));
  CHECK(window.rect("top bar").width() == Approx(bar / 1.5).margin(1));
  CHECK(window.rect("play").width() == play.width());  // px of a layout with fewer of them
  CHECK(window.picture().width == 1920);
  window.click("play");  // the pointer is where it seems
  CHECK(window.player().clock().playing());
  window.key(key::minus, true);
  CHECK(window.ui.settings().size == Approx(1.4));
  window.key(key::zero, true);
  CHECK(window.ui.scale() == 1);
  CHECK(window.rect("top bar").width() == Approx(bar).margin(0.5));
}

TEST_CASE("nothing grows beyond what the least layout leaves", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800);
  for (int i = 0; i < 40; ++i) window.key(key::equal, true);
  window.frames(2);
  CHECK(window.ui.scale() == Approx(1.6));
  CHECK(window.rect("top bar").width() == Approx(800).margin(0.5));
  for (int i = 0; i < 60; ++i) window.key(key::minus, true);
  CHECK(window.ui.scale() == Approx(0.5));
}

TEST_CASE("a window that a display made too small shows all of it smaller", "[window]") {
  for (const auto& [width, height] : {std::pair(420.0f, 320.0f), {300.0f, 200.0f}, {160.0f, 100.0f}, {20.0f, 10.0f}}) {
    WindowDriver window(lessons::all_lessons(), width, height, place_at("ray-sphere", "two-roots"));
    for (const char* panes : {"", "v"}) {
      CAPTURE(width, height, panes);
      window.type(panes);
      window.frames(3);
      window.key(key::end);
      CHECK(window.picture().width == static_cast<int>(width));
      if (width < 160) continue;  // drawn without harm is all that can be asked
      CHECK(window.rect("top bar").width() > 799);
      CHECK(window.rect("scene").height() > 100);
    }
  }
}

TEST_CASE("a kept size holds on a screen of double density", "[window]") {
  Settings settings;
  settings.size = 1.5;
  WindowDriver window(lessons::all_lessons(), 1920, 1080, {}, settings, {.scale = 2, .reduced_motion = true});
  CHECK(window.ui.scale() == Approx(3));
  CHECK(window.rect("top bar").width() == Approx(1280).margin(1));
}

TEST_CASE("F11 asks for the whole screen and back", "[window]") {
  WindowDriver window(lessons::all_lessons());
  CHECK_FALSE(window.ui.full_screen());
  window.key(key::f11);
  CHECK(window.ui.full_screen());
  window.key(key::f11);
  CHECK_FALSE(window.ui.full_screen());
}

}  // namespace size_test
