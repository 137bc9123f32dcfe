#pragma once
// The camera of a player's reader: it frames the walk until the reader moves it, and again with every preset, unless
// the reader has pinned it.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "viz/player/camera_rig.h"
#include "viz/player/played_walk.h"

namespace isect::viz {

class ReaderCamera {
 public:
  /// `reduced_motion`: glides arrive at once.
  explicit ReaderCamera(bool reduced_motion = false) : rig_(reduced_motion) {}

  /// Return the view at this moment, and the one at which it will come to rest.
  const Camera& now() const { return rig_.now(); }
  const Camera& goal() const { return rig_.goal(); }
  bool moving() const { return rig_.moving(); }
  /// Whether it is the reader's own: moved by hand or pinned. Then no step frames it anew.
  bool moved() const { return moved_ || pinned_; }
  bool pinned() const { return pinned_; }    ///< no preset frames it anew, either
  double aspect() const { return aspect_; }  ///< width / height of the scene

  /// Returns the projection that the reader has set; none: the lesson's, or the step's.
  const std::optional<bool>& projection() const { return rig_.projection(); }
  void forget_projection() { rig_.forget_projection(); }

  /// Returns the lesson's view of the walk, at the scale that all presets share; with another walk beside it, of both.
  /// `own`: that of the step, if it has one. `perspective`: the projection, if it is not the lesson's or the step's
  /// own.
  Camera opening(const PlayedWalk&, const std::optional<StepView>& own, const Scene& shown,
                 std::optional<bool> perspective = {}) const;
  /// Returns the opening direction, or the step's own, with the whole walk in view, and these scenes.
  Camera whole(const PlayedWalk&, const std::optional<StepView>& own = {},
               const std::vector<const Scene*>& more = {}) const;
  /// Whether the whole scene is in this view.
  bool has_in_view(const Camera&, const Scene&) const;
  /// Returns the reader's own direction with the whole scene in view, and all of its handles.
  Camera holding(const Scene&) const;
  /// From now on opening() has that walk in view, too; null: no longer. Returns whether that is a change.
  bool accompany(std::shared_ptr<const Walk>);
  void set_aspect(double aspect) { aspect_ = aspect; }

  void advance(double seconds) { rig_.advance(seconds); }
  void pin(bool pinned) { pinned_ = pinned; }
  void reduce_motion(bool reduced) { rig_.reduce_motion(reduced); }
  /// Ends a glide at once.
  void arrive();
  /// Set a view; `moved`: it is the reader's own.
  void jump(const Camera&, bool moved);
  void glide(const Camera&, bool moved, double seconds = CameraRig::usual_glide);
  /// Lets the reader move it.
  void move(const std::function<void(CameraRig&)>&);
  /// Goes where another camera goes.
  void take(const ReaderCamera&);

 private:
  CameraRig rig_;
  double aspect_ = 1;
  bool moved_ = false, pinned_ = false;
  std::shared_ptr<const Walk> beside_;  ///< in the other pane
};

}  // namespace isect::viz
