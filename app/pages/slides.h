#pragma once
// Slides as LaTeX (beamer) and as one HTML file that steps by keys.

#include <string>
#include <vector>

#include "app/figures/blocks.h"

namespace isect::program {

struct Slide {
  std::string title;  ///< markup
  Blocks left;        ///< the whole width if nothing stands on the right
  Blocks right = {}, below = {};
  bool first = false;     ///< the title in large letters
  std::string note = {};  ///< markup, for the speaker alone
};

std::string beamer(const std::string& title, const std::vector<Slide>&);
std::string html_slides(const std::string& title, const std::vector<Slide>&);

}  // namespace isect::program
