#pragma once
// A page for users' own scenes: examples step by step, and how a scene is written.

#include <string>
#include <vector>

#include "app/book/page_shell.h"
#include "viz/formats/page_svg.h"

namespace isect::program::book {

inline constexpr const char* scene_file = "scene.html";

/// A scene file with which the page begins.
struct ExampleScene {
  std::string name, text;
};
const std::vector<ExampleScene>& example_scenes();

/// Makes the page; it is useful if the compiled lessons are beside it.
Page scene_page(viz::PageColours&);

}  // namespace isect::program::book
