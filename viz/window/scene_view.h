#pragma once
// The interactive scene: composed from the current step, drawn by the Renderer, held and turned by the
// pointer.

#include <optional>

#include "viz/compose/compose.h"
#include "viz/gl/renderer.h"
#include "viz/player/dragging.h"
#include "viz/window/kept_picture.h"
#include "viz/window/map_view.h"
#include "viz/window/window_session.h"

namespace isect::viz {

class SceneView {
 public:
  /// `scale`: framebuffer pixels per px of the layout. Without `drawing` it only places names; without `placing` it
  /// does neither.
  SceneView(Renderer& renderer, double scale, bool drawing = true, bool placing = true)
      : renderer_(renderer), scale_(scale), drawing_(drawing), placing_(placing) {}

  /// Draws the scene with its marks, and does what the pointer asks for.
  void show(WindowSession&, const Rect&);
  const std::vector<PlacedLabel>& labels() const { return labels_; }
  /// Whether the next frame is wanted: not all is drawn yet, a key goes on turning it, or a snap is being searched.
  bool behind() const { return behind_ || turning_ >= 0 || search_; }
  void rescale(double scale) { scale_ = scale; }

 private:
  void draw(WindowSession&, const Rect&, const View&);
  void pointer(WindowSession&, const View&, bool hovered, bool active);
  void wheel(WindowSession&, const View&);
  void keyboard(WindowSession&, const View&);
  void drag_held(WindowSession&, const View&);
  void begin_snap(const Player&, Snap);
  void go_on_snapping(WindowSession&);
  void end_search(WindowSession&);
  std::optional<Handle> handle_near(const WindowSession&, const View&, const Vec2& pixel) const;

  Renderer& renderer_;
  double scale_;
  bool drawing_, placing_, behind_ = false;
  std::vector<PlacedLabel> labels_;
  KeptPicture picture_;
  std::string drawn_;           ///< what the picture shows, as one line: it is not drawn twice
  double turning_ = -1;         ///< seconds for which keys have turned or shifted it; < 0: they do not
  bool sketched_ = false;       ///< drawn coarsely during a drag, smoothly once the button is released
  std::optional<Handle> held_;  ///< while a handle is dragged: the handle as it is now
  const Lesson* held_in_ = nullptr;
  /// A snap whose search takes more than a frame, and what was on show when it began.
  struct Search {
    Snap snap;
    unsigned revision;
    bool ended = false;
    int frames = 0;  ///< so far
  };
  std::optional<Search> search_;
  std::string forbidden_;         ///< why it does not follow the pointer; empty: it does
  MapDrag map_drag_;              ///< while the step shows the map of cases
  Vec3 start_ = Vec3::Zero();     ///< where it stood when it was taken
  Parameters begun_;              ///< the setting then
  Vec2 pressed_ = Vec2::Zero();   ///< the pointer that took it
  Vec2 followed_ = Vec2::Zero();  ///< the pointer that it has followed or is being snapped to
  bool snapping_ = false;         ///< Shift was held in the frame before
  Vec2 grip_ = Vec2::Zero();      ///< from the held handle to the pointer that took it
  Vec2 last_ = Vec2::Zero();      ///< the pointer in the frame before
};

}  // namespace isect::viz
