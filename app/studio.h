#pragma once
// Draws the figures of one run: a step of an excerpt, in a style, as a drawing and as a file's bytes.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/piece.h"
#include "app/style.h"
#include "viz/offscreen.h"
#include "viz/paper.h"

namespace isect::program {

class Studio {
 public:
  /// A rendering back end is started only where a format needs one. Throws viz::NoBackend.
  Studio(const Style&, const std::string& backend);

  /// On paper no narrower than its labels need, which is told once all are drawn. What is empty all round is taken away
  /// before the size on paper is given.
  viz::Drawing draw(const Excerpt&, int step);
  /// All of one size: each in the middle of it.
  std::vector<viz::Drawing> draw(const Excerpt&, const std::vector<int>& steps);
  /// Several steps as one drawing, side by side, each under its letter and title; on paper only. `columns` a row, or
  /// `fewer` where the strip would be wider than was asked for.
  viz::Drawing draw_strip(const Excerpt&, int columns, bool fewer, bool captions);
  std::string write(const Piece&, const viz::Drawing&, const viz::Format&);
  /// Several steps in one file, one after the other.
  std::string film(const Piece&, const std::vector<viz::Drawing>&, double seconds, const viz::Format&);
  std::string renderer(const viz::Format&) const;
  /// Figures that are wider than what was asked for: "ray-sphere/tangent/03-distance: 4.1 cm".
  const std::vector<std::string>& widened() const { return widened_; }

 private:
  using Drawings = std::vector<viz::Drawing>;
  /// Where no height is given, as high as the walk's pictures need.
  viz::OnPaper on_paper(const Excerpt&, const viz::Walk&, int step, viz::PaperSize, bool title);
  Drawings whole(const Excerpt&, const std::vector<int>& steps, const viz::PaperSize&);
  viz::Drawing whole_strip(const Excerpt&, int columns, bool captions, const viz::PaperSize&);
  /// What `draw` makes at the size at which it is as large as asked for once cropped.
  Drawings cropped_to_paper(const std::function<Drawings(const viz::PaperSize&)>& draw) const;
  bool is_widened(double width) const;
  void tell_widened(const std::string& which, double width);
  viz::Imprint imprint_of(const Piece&, const viz::Drawing&) const;
  viz::Metadata metadata_of(const Piece&) const;
  double pixels_a_unit() const { return style_.paper ? style_.dpi / 72 : 1; }

  const Style& style_;
  std::unique_ptr<viz::Offscreen> offscreen_;
  std::vector<std::string> widened_;
};

/// Which figures could not be as narrow as was asked: honestly wider, rather than with labels that meet.
void say_widened(const Studio&);

/// The camera for a picture of this step whose width to height is `aspect`: the one of the preset's file, which
/// shows as much from the middle to the top edge as where it was copied; otherwise at one scale for all presets of the
/// lesson, but nearer where that leaves the picture empty.
viz::Camera camera_for(const Excerpt&, const viz::Step&, double aspect);

}  // namespace isect::program
