#pragma once
// Scenes of one's own as a page: examples step by step, and how a scene is written.

#include <string>
#include <vector>

#include "app/book/page.h"
#include "viz/page_svg.h"

namespace isect::program::book {

inline constexpr const char* scene_file = "scene.html";

/// A scene file that the page begins with.
struct ExampleScene {
  std::string name, text;
};
const std::vector<ExampleScene>& example_scenes();

/// Of use where the lessons run beside it.
Page scene_page(viz::PageColours&);

}  // namespace isect::program::book
