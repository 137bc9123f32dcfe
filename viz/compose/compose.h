#pragma once
// Scene + camera + theme -> drawing. Silhouettes are analytic, hidden edges dashed, labels placed so that no two meet.

#include <optional>

#include "viz/camera.h"
#include "viz/drawing.h"
#include "viz/lesson.h"
#include "viz/theme.h"

namespace isect::viz {

/// A label of a composed scene, for the pointer and for tests.
struct PlacedLabel {
  std::string text;
  TextBox box;
  std::optional<Vec2> leads_to = {};  ///< where its leader ends, if it has one
};
struct Composed {
  std::vector<Shape> shapes;
  std::vector<PlacedLabel> labels;
  std::vector<Object> objects = {};  ///< of a scene: its items, in order, then the floor and the handles
};

/// Composes the scene alone, within the view's rectangle. With `handles`, draws the grips of the scene's handles.
Composed compose(const Scene&, const View&, const Theme&, bool handles = false);

/// The extent of a scene's items on the plane that faces the camera: right and up, in world units from the origin.
struct Box2 {
  Vec2 lo, hi;
};
Box2 extent(const std::vector<Item>&, const Camera&);

/// Returns a camera like `camera` whose target and half_height frame all the scenes in a viewport of this aspect (width
/// / height), leaving `margin` (a share of the height) free on all sides.
Camera frame(const Camera& camera, const std::vector<const Scene*>& scenes, double aspect, double margin = 0.05);

/// A camera centred on `walk`, at the one scale at which each of `all` fits, so that presets compare; larger where
/// `walk` would be less than nine tenths of the size that it has alone.
Camera frame_alike(const Camera& camera, const Walk& walk, const std::vector<Walk>& all, double aspect);

/// Returns a camera for one step of a walk so framed: nearer, and centred on the step's own scene, if that would take
/// little of the frame. Otherwise the same camera, so that most steps stand still.
Camera closer(const Camera& framed, const Scene&, double aspect);

/// Returns `framed`, the camera of a step whose whole walk was framed, with the place and the scale that the step's own
/// view says.
Camera placed(const std::optional<StepView>& view, Camera framed);
/// Returns the camera of a step of this walk: as frame_alike and then closer() have it, from where the step is seen.
/// `view`: the step's own; `scene`: what is drawn of it.
Camera step_camera(const Lesson&, const Walk&, const std::vector<Walk>& all, const std::optional<StepView>& view,
                   const Scene& scene, double aspect);

/// How a figure divides its height: title above, picture, the scene's t-axis and the step's formula and verdict below.
/// The same for all steps of a walk, so that the picture stands still from step to step.
struct PageLayout {
  Theme theme;
  double width = 0, height = 0;
  bool axis = false;                                          ///< there is a t-axis
  int title_lines = 1, formula_lines = 1, verdict_lines = 1;  ///< the most that a step needs
  bool wraps = false;  ///< texts keep their size: a long line goes on below; otherwise it shrinks

  double top() const;
  double bottom() const;
  double picture_height() const;  ///< never less than a fifth of the figure
};
/// Returns the layout of a picture on a screen, whose texts grow with it.
PageLayout page_layout(const Walk&, const ThemeChoice&, double width, double height, bool title = true);
/// Sizes in points. Height 0: as high as the figure needs.
struct PaperSize {
  double width = 0, height = 0, text_size = usual_text_size;
};
/// Returns the layout of a figure on paper, whose texts have one size whatever its width. `shown`: a step of the walk;
/// all scenes share a layout, and so do all charts.
PageLayout paper_layout(const Walk&, int shown, const ThemeChoice&, const PaperSize&, bool title = true);

struct Figure {
  Drawing drawing;
  std::vector<PlacedLabel> labels;
  View view;  ///< of the picture part
};
Figure figure(const Step&, const Camera&, const PageLayout&);
Figure figure(const Step&, const Camera&, const ThemeChoice&, double width, double height);
/// Tells what is wrong with a figure's labels: those that leave it, pairs that meet, texts below the least size.
std::vector<std::string> label_faults(const Drawing&, const std::vector<PlacedLabel>&, double least_size = 0);
std::vector<std::string> label_faults(const Figure&, double least_size = 0);
/// Returns width / height of a figure's picture part, for framing. `walk` decides whether there is a t-axis below it.
double picture_aspect(const Walk& walk, const ThemeChoice&, double width, double height);

}  // namespace isect::viz
