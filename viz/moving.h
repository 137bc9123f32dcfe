#pragma once
// How a handle follows a pointer or the arrow keys, in the window and on a page.

#include <functional>
#include <utility>

#include "viz/player.h"
#include "viz/snap.h"

namespace isect::viz {

/// What came of moving something: where it went is in the player.
struct Moved {
  std::string told = {};     ///< what is there, after snapping
  std::string refused = {};  ///< why it stays where it is; empty: it does not
};

/// Where a handle is brought when it is to stand at a pixel: it stays in its plane where it has one.
Vec3 brought(const View&, const Handle&, const Vec2& pixel);
/// The handle as it is now; null: there is none of its kind any more.
const Handle* same_handle(const Scene&, const Handle&);

/// A movement that is to end where the case changes: it takes a search of about a hundred questions to the lesson,
/// which a window asks over several frames, while all stays where it is.
class Snap {
 public:
  /// `otherwise` is done where the case changes nowhere.
  Snap(BorderSearch search, std::function<Moved(Player&)> otherwise)
      : search_(std::move(search)), otherwise_(std::move(otherwise)) {}

  /// Asks one question more; false: all is asked.
  bool go_on() { return search_.go_on(); }
  /// Brings the player to what was found, after asking what is left to ask.
  Moved settle(Player&);

 private:
  BorderSearch search_;
  std::function<Moved(Player&)> otherwise_;
};

/// What drag_to and nudge do with `snapping`.
Snap snapping_drag(const Player&, const Handle&, const Vec3& start, const Vec3& to);
Snap snapping_nudge(const Player&, const View&, const Handle&, const Vec2& way);

/// A drag, from `start` on. With `snapping` only as far as where the case changes, next to the pointer.
Moved drag_to(Player&, const Handle&, const Vec3& start, const Vec3& to, bool snapping);
/// One press of an arrow key, whose way is one pixel long. With `snapping` to where the case changes next.
Moved nudge(Player&, const View&, const Handle&, const Vec2& way, bool snapping);

}  // namespace isect::viz
