#pragma once
// A window at the question of a sample lesson, and a reader's hands on its keyboard.

#include <string>
#include <utility>
#include <vector>

#include "tests/catch.h"
#include "tests/viz/window_driver.h"

namespace isect::viz {

/// The window before step 2 of the first lesson, whose question asks for more than a choice.
struct AtQuestion {
  explicit AtQuestion(std::vector<const Lesson*> these, float height = 800)
      : lessons(std::move(these)), window(lessons, 1280, height) {
    window.player().go_to(1);
    window.key(key::right);
    window.frames(2);
    REQUIRE(window.player().quiz().asks_more());
  }
  /// Types as a reader does, a character a frame or more.
  void type(const std::string& text) {
    for (const char c : text) window.type(std::string(1, c));
    window.frames(4);
  }
  void enter() {
    window.key(key::enter);
    window.frames(3);
  }
  const Answered& answered() {
    REQUIRE(window.player().quiz().answered());
    return *window.player().quiz().answered();
  }

  std::vector<const Lesson*> lessons;
  WindowDriver window;
};

}  // namespace isect::viz
