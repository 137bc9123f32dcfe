#pragma once
// Two panes: a method against another one, or a preset against another one, at one step and through one camera.

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "viz/window/layout.h"
#include "viz/window/scene_view.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Whether the lesson on show stands in two panes.
bool two_panes(const Player&, const Settings&);
/// Shows the next method or preset beside this one, or hides the second pane.
void toggle_panes(const Player&, Settings&, Toast&);

class SecondPane {
 public:
  SecondPane(Renderer& renderer, double scale, bool drawing) : scene_(renderer, scale, drawing, drawing) {}

  /// Shows both panes, with what tells them apart above them. `lead`: the scene of the first.
  void show(const ScenePane& first, Settings&, SceneView& lead, const PanesLayout&);
  /// Returns to one pane.
  void leave(Player& first, Settings&);
  /// Draws with the second player what belongs to its pane, among the names of its walk; what is changed there, the
  /// first takes over. Draws nothing once there is one pane.
  void on_its_side(const ScenePane& first, Settings&, const std::function<void(Player&)>& draw);
  /// Whether the second scene wants another frame (SceneView::behind), while there are two panes.
  bool behind() const { return other_ && scene_.behind(); }
  void rescale(double scale) { scene_.rescale(scale); }

 private:
  bool follow(Player& first, Settings&, Toast&);
  void show_other(const ScenePane& first, Settings&, const PanesLayout&);

  SceneView scene_;
  std::optional<Player> other_;
  std::set<std::string> names_;  ///< the names in its walk
  unsigned named_ = 0;           ///< the revision of that walk
};

}  // namespace isect::viz
