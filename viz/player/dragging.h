#pragma once
// How a handle follows a pointer or the arrow keys, in the window and on a page.

#include <functional>
#include <utility>

#include "viz/player/player.h"
#include "viz/player/snap.h"

namespace isect::viz {

/// The result of moving something; its new place is in the player.
struct Moved {
  std::string told = {};     ///< what is there, after snapping
  std::string refused = {};  ///< why it stays where it is; empty: it does not
};

/// Returns where a handle goes when it is to stand at a pixel: it stays in its plane or on its line if it has one.
Vec3 brought(const View&, const Handle&, const Vec2& pixel);
/// Returns the handle as it is now; null if the scene has no such handle any more.
const Handle* same_handle(const Scene&, const Handle&);

/// A movement that is to end where the case changes. Its search asks the lesson about a hundred questions, which a
/// window spreads over several frames, while nothing moves.
class Snap {
 public:
  /// `otherwise` is called if the case changes nowhere.
  Snap(BorderSearch search, std::function<Moved(Player&)> otherwise)
      : search_(std::move(search)), otherwise_(std::move(otherwise)) {}

  /// Asks one more question; returns false if none is left.
  bool go_on() { return search_.go_on(); }
  /// Asks the remaining questions, then brings the player to what was found.
  Moved settle(Player&);

 private:
  BorderSearch search_;
  std::function<Moved(Player&)> otherwise_;
};

/// Return the search that drag_to and nudge do with `snapping`.
Snap snapping_drag(const Player&, const Handle&, const Vec3& start, const Vec3& to);
Snap snapping_nudge(const Player&, const View&, const Handle&, const Vec2& way);

/// Drags the handle from `start` on. With `snapping` only to where the case changes, next to the pointer.
Moved drag_to(Player&, const Handle&, const Vec3& start, const Vec3& to, bool snapping);
/// Presses an arrow key once; `way` is one pixel long. With `snapping` to where the case changes next.
Moved nudge(Player&, const View&, const Handle&, const Vec2& way, bool snapping);

}  // namespace isect::viz
