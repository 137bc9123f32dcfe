#pragma once
// Further looks of a preset or a scene that `isect check --dir` guards besides the usual one, as its file lists them:
//
//   "guard": [{"theme": "dark"}, {"size": "640x480"}, {"theme": "print", "width": "8cm", "format": "tikz"}]
//
// Each step with a picture gets a baseline of each, beside that of the usual look: 03-foot.dark.png,
// 03-foot.640x480.png, 03-foot.print-8cm.tikz. Theme, size, width and format are those of `isect render`.

#include <string>
#include <vector>

namespace isect::program {

/// One look. What is usual is empty: the screen's theme, 960x600 pixels, for TikZ the width that `render` gives it.
struct Guard {
  std::string theme, size, width;
  std::string format = "png";  ///< png, svg or tikz

  /// Returns "dark-640x480": theme, then size or width in centimetres; empty if only the format is another.
  std::string name() const;
  /// Returns the name of a step's baseline: "03-foot.dark.png" for "03-foot".
  std::string file(const std::string& stem) const;
  bool operator==(const Guard&) const = default;
};

/// Returns the looks that a preset's or a scene's text lists; none if it lists none, or is no JSON. Throws
/// viz::BadInput, which names the entry, from 1, and the field, also if a look is listed twice or is the usual one.
std::vector<Guard> guards_in(const std::string& text);

}  // namespace isect::program
