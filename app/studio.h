#pragma once
// Draws the figures of one run: a step of an excerpt, in a style, as a drawing and as a file's bytes.

#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "app/style.h"
#include "viz/offscreen.h"

namespace isect::program {

class Studio {
 public:
  /// A rendering back end is started only where a format needs one. Throws viz::NoBackend.
  Studio(const Style&, const std::string& backend);

  /// On paper no narrower than its labels need, which is told once all are drawn.
  viz::Drawing draw(const Excerpt&, int step);
  std::string write(const Excerpt&, int step, const viz::Drawing&, const viz::Format&);
  std::string renderer(const viz::Format&) const;
  /// Figures that are wider than what was asked for: "ray-sphere/tangent/03-distance: 4.1 cm".
  const std::vector<std::string>& widened() const { return widened_; }

 private:
  viz::Figure on_paper(const Excerpt&, int step);

  const Style& style_;
  std::unique_ptr<viz::Offscreen> offscreen_;
  std::vector<std::string> widened_;
};

/// The camera for a picture of this step whose width to height is `aspect`: the one of the preset's file, which
/// shows as much from the middle to the top edge as where it was copied; otherwise at one scale for all presets of the
/// lesson, but nearer where that leaves the picture empty.
viz::Camera camera_for(const Excerpt&, int step, double aspect);

}  // namespace isect::program
