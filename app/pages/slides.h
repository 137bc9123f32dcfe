#pragma once
// Slides as LaTeX (beamer) and as one HTML file that steps by keys.

#include <string>
#include <vector>

#include "app/figures/blocks.h"
#include "app/pages/template.h"

namespace isect::program {

struct Slide {
  std::string title;  ///< markup
  Blocks left;        ///< the whole width if nothing stands on the right
  Blocks right = {}, below = {};
  bool first = false;     ///< the title in large letters
  std::string note = {};  ///< markup, for the speaker alone
  bool overlaid = false;  ///< in LaTeX it is one frame with the overlaid slides beside it, which it replaces in place
};

/// How slides look around their pictures.
struct SlideLook {
  std::string beamer_theme = {};  ///< of LaTeX; empty: its default
  /// Colours of dark slides, "14181d"; empty: they are white.
  std::string ground = {}, text = {}, lit = {}, structure = {};
  bool is_dark() const { return !ground.empty(); }
};

PageParts beamer(const std::string& title, const std::vector<Slide>&, const SlideLook& = {});
std::string html_slides(const std::string& title, const std::vector<Slide>&, const SlideLook& = {});

}  // namespace isect::program
