#pragma once
// Scene + camera + theme -> drawing. Silhouettes are analytic, hidden edges dashed, labels placed so that no two meet.

#include <optional>

#include "viz/camera.h"
#include "viz/drawing.h"
#include "viz/lesson.h"
#include "viz/theme.h"

namespace isect::viz {

/// What the pointer or a test may want to know of a composed scene.
struct PlacedLabel {
  std::string text;
  TextBox box;
};
struct Composed {
  std::vector<Shape> shapes;
  std::vector<PlacedLabel> labels;
  std::vector<Object> objects = {};  ///< of a scene: its items, in order, then the floor and the handles
};

/// The scene alone, within the view's rectangle. With `handles`, draws the grips of the scene's handles.
Composed compose(const Scene&, const View&, const Theme&, bool handles = false);

/// What a scene's items cover on the plane that faces the camera: right and up, in world units from the origin.
struct Box2 {
  Vec2 lo, hi;
};
Box2 extent(const Scene&, const Camera&);

/// A camera like `camera` whose target and half_height frame all the scenes in a viewport of this aspect
/// (width / height), leaving `margin` (a share of the height) free all round.
Camera frame(const Camera& camera, const std::vector<const Scene*>& scenes, double aspect, double margin = 0.08);

/// A camera centred on `walk`, at the one scale at which each of `all` fits, so that presets compare; larger where `walk`
/// would not take three quarters of what it takes alone.
Camera frame_alike(const Camera& camera, const Walk& walk, const std::vector<Walk>& all, double aspect);

/// A figure: title above, picture, the scene's t-axis and the step's formula or verdict below.
struct Figure {
  Drawing drawing;
  std::vector<PlacedLabel> labels;
  View view;  ///< of the picture part
};
Figure figure(const Step&, const Camera&, ThemeName, double width, double height);
/// Width / height of a figure's picture part, for framing. `walk` decides whether there is a t-axis below it.
double picture_aspect(const Walk& walk, ThemeName, double width, double height);

}  // namespace isect::viz
