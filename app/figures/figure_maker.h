#pragma once
// Draws the figures of one run: a step of an excerpt, in a style, as a drawing and as a file's bytes.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/figures/figure_info.h"
#include "app/figures/film.h"
#include "app/figures/one_scale.h"
#include "app/figures/style.h"
#include "viz/compose/paper.h"
#include "viz/gl/offscreen.h"

namespace isect::program {

class FigureMaker {
 public:
  /// Starts a rendering back end only if a format needs one. Throws viz::NoBackend.
  FigureMaker(const Style&, const std::string& backend);

  /// Draws a step. On paper it is no narrower than its labels need; say_widened reports that once all are drawn. Empty
  /// margins are cropped before the size on paper is fitted. If the excerpt is drawn at one scale with others, all of
  /// these have one size.
  viz::Drawing draw(const Excerpt&, int step);
  /// Draws several steps, all of one size: each in the middle of it.
  std::vector<viz::Drawing> draw(const Excerpt&, const std::vector<int>& steps);
  std::vector<viz::Drawing> draw(const Excerpt&, const std::vector<Shot>&);
  /// Draws the chosen steps as one drawing, side by side, each above its letter and title; on paper only. Several
  /// settings are drawn at one scale. `columns` per row, or `fewer` if the strip would be wider than was asked for.
  viz::Drawing draw_strip(Excerpts, int columns, bool fewer, bool captions);
  /// Writes one drawing as a file that needs no other.
  std::string write(const FigureInfo&, const viz::Drawing&, const viz::Format&);
  /// Writes it for a folder: of TikZ the faces of a large mesh are a picture beside the file.
  FigureFile write_for_folder(const FigureInfo&, const viz::Drawing&, const viz::Format&);
  /// Writes shots into one file, one after the other, from the drawing of each.
  std::string film(const FigureInfo&, const std::vector<Shot>&, const std::vector<viz::Drawing>&, const viz::Format&);
  std::string renderer(const viz::Format&) const;
  const Style& style() const { return style_; }
  /// Returns the figures that are wider than was asked for: "ray-sphere/tangent/03-distance: 4.1 cm".
  const std::vector<std::string>& widened() const { return widened_; }

 private:
  using Drawings = std::vector<viz::Drawing>;
  /// How a step is seen.
  struct Sight {
    std::string whose;
    std::function<double()> shape;  ///< width / height of what is seen in all steps
    std::function<viz::Camera(double aspect)> camera;
  };
  static Sight sight(const Excerpt&, const viz::Walk&, int step);
  static Sight sight(const OneScale&, Excerpts, int step);
  /// Draws a step on paper; if no height is given, as high as the walk's pictures need.
  viz::OnPaper on_paper(const viz::Walk&, int step, const Sight&, viz::PaperSize, bool title);
  /// Draws all steps of a walk on paper, as wide as the one that needs most.
  std::vector<viz::Figure> equally_wide(const viz::Walk&, const std::function<Sight(int step)>&, viz::PaperSize,
                                        bool title);
  Drawings whole(const Excerpt&, const std::vector<Shot>&, const viz::PaperSize&);
  viz::Drawing whole_strip(Excerpts, int columns, bool captions, const viz::PaperSize&);
  /// Draws steps with the scale that they have alone.
  Drawings draw_alone(const Excerpt&, const std::vector<Shot>&);
  /// Draws the chosen steps of all settings at one scale and in one size, one after the other.
  Drawings draw_alike(Excerpts);
  /// Draws steps with the scale that the excerpt has with others; these are drawn once.
  Drawings draw_with_others(const Excerpt&, const std::vector<Shot>&);
  /// Returns what `draw` makes at the size at which the cropped result is as large as asked for.
  Drawings cropped_to_paper(const std::function<Drawings(const viz::PaperSize&)>& draw) const;
  bool is_widened(double width) const;
  void tell_widened(const std::string& which, double width);
  viz::Imprint imprint_of(const FigureInfo&, const viz::Drawing&) const;
  viz::Metadata metadata_of(const FigureInfo&) const;
  double pixels_a_unit() const { return style_.paper ? style_.dpi / 72 : 1; }

  const Style& style_;
  std::unique_ptr<viz::Offscreen> offscreen_;
  std::vector<std::string> widened_;
  std::map<std::shared_ptr<const std::vector<Excerpt>>, Drawings> alike_;  ///< what draw_alike made
};

/// Says on stderr, of a TikZ picture of a large mesh on stdout, that a folder would have its faces as a picture.
void say_faces_inside(const viz::Drawing&, const viz::Format&);
/// Reports the figures that could not be as narrow as was asked: they are wider, so that no labels meet.
void say_widened(const FigureMaker&);

/// Returns the camera for a picture of this step with this `aspect`, width / height: the one of the preset's file,
/// which shows as much from the middle to the top edge as where it was copied; otherwise the step's own, or at one
/// scale for all presets of the lesson, but nearer where that leaves the picture empty.
viz::Camera camera_for(const Excerpt&, const viz::Step&, double aspect);

}  // namespace isect::program
