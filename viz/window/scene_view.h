#pragma once
// The interactive scene: composed from the current step, drawn by the Renderer, held and turned by the
// pointer.

#include <functional>
#include <memory>
#include <optional>

#include "viz/chart/chart_pick.h"
#include "viz/compose/compose.h"
#include "viz/gl/renderer.h"
#include "viz/player/dragging.h"
#include "viz/window/kept_picture.h"
#include "viz/window/map_view.h"
#include "viz/window/scene_marks.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// The first pane or the only one; a second that a reader's hand moves along with it; one that stays as it is.
enum class Pane { lead, along, fixed };

/// What a pane's scene shows and changes.
struct ScenePane {
  Player& player;
  Ui& ui;
  Toast& toast;
  double& zoom;  ///< asked for by keys, until it is done: then 1
  Pane pane = Pane::lead;
  /// Adds a corner to the side of an outline that is seen at a pixel; removes the corner that a handle moves. They
  /// return false if there is none. Null: no outline can be changed.
  std::function<bool(const View&, const Vec2&)> add_corner = {};
  std::function<bool(const Handle&)> remove_corner = {};
  const Lesson* in_file = nullptr;  ///< the scene as its file has it, where the one on show was edited since; or null
  /// Returns the handles that can be dragged.
  const std::vector<Handle>& handles() const {
    static const std::vector<Handle> none;
    return pane == Pane::fixed ? none : player.scene().handles;
  }
};

class SceneView {
 public:
  /// `scale`: framebuffer pixels per px of the layout. Without `drawing` it only places names; without `placing` it
  /// does neither.
  SceneView(Renderer& renderer, double scale, bool drawing = true, bool placing = true)
      : renderer_(renderer), scale_(scale), drawing_(drawing), placing_(placing) {}

  /// Draws the scene with its marks and, below it, its time, and does what the pointer asks for.
  void show(const ScenePane&, const Rect&);
  const std::vector<PlacedLabel>& labels() const { return labels_; }
  /// Whether the next frame is wanted: not all is drawn yet, a key goes on turning it, or a snap is being searched.
  bool behind() const { return behind_ || turning_ >= 0 || search_; }
  void rescale(double scale) { scale_ = scale, tallest_verdict_ = {}; }
  /// Forgets what it has drawn: it shows another player from now on, whose numbers may be the same.
  void forget() { drawn_.clear(), marked_.clear(), tallest_verdict_ = {}; }

 private:
  void draw(const ScenePane&, const Rect&, const View&);
  /// Returns the camera that the scene is seen by: the player's or, where small multiples stand in other columns, one
  /// that frames those; the reader's own view keeps the lesson's columns.
  Camera arrange(Player&);
  void pointer(const ScenePane&, const View&, bool hovered, bool active);
  void chart_under_pointer(const ScenePane&, const Rect&, const View&, bool hovered);
  void handles_and_names(const ScenePane&, const Rect&, const View&, bool hovered, bool active);
  void tell_handle(const ScenePane&, const Rect&, const View&, const Handle&);
  // scene_hand.cpp
  void take_or_release(const ScenePane&, const View&, bool hovered);
  void keyboard(const ScenePane&, const View&);
  void turn_by_keys(const ScenePane&, const View&, const Vec2& down, double held_for);
  void drag_held(const ScenePane&, const View&);
  void begin_snap(const Player&, Snap);
  void go_on_snapping(Player&, Toast&);
  void end_search(Toast&);

  Renderer& renderer_;
  double scale_;
  bool drawing_, placing_, behind_ = false;
  std::vector<PlacedLabel> labels_;
  KeptPicture picture_;
  TallestVerdict tallest_verdict_;
  MessagePlace message_;
  std::string drawn_;                      ///< what the picture shows, as one line: it is not drawn twice
  double turning_ = -1;                    ///< seconds for which keys have turned or shifted it; < 0: they do not
  std::vector<ChartMark> marks_;           ///< of the chart, once the pointer was over it
  std::string marked_;                     ///< which chart they are of, as one line
  bool sketched_ = false;                  ///< drawn coarsely during a drag, smoothly once the button is released
  std::shared_ptr<const Scene> arranged_;  ///< small multiples in other columns; null: in the lesson's own
  std::shared_ptr<const Scene::Grid> arranged_of_;  ///< whose they are
  double arranged_for_ = 0;                         ///< the aspect
  std::optional<Handle> held_;                      ///< while a handle is dragged: the handle as it is now
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
  unsigned clicked_at_ = 0;       ///< the player's revision when the button was pressed once
  Vec3 start_ = Vec3::Zero();     ///< where it stood when it was taken
  Parameters begun_;              ///< the setting then
  Vec2 pressed_ = Vec2::Zero();   ///< the pointer that took it
  std::optional<Vec2> released_;  ///< the pointer that dragged it and let it go
  Vec2 followed_ = Vec2::Zero();  ///< the pointer that it has followed or is being snapped to
  bool snapping_ = false;         ///< Shift was held in the frame before
  Vec2 grip_ = Vec2::Zero();      ///< from the held handle to the pointer that took it
  Vec2 last_ = Vec2::Zero();      ///< the pointer in the frame before
};

}  // namespace isect::viz
