#pragma once
// The pointer of a lecture: while it rests, it is hidden and has no effect, so that nothing is lit or told under it
// while a presenter's keys step on.

#include <imgui.h>

namespace isect::viz {

class RestingPointer {
 public:
  /// Called before Dear ImGui begins a frame, `seconds` after the last one: takes the pointer away if it has rested
  /// long enough in a lecture.
  void begin_frame(bool lecture, double seconds);
  /// Called once Dear ImGui has begun it. `invisible`: the pointer is not shown, whether it rests or not.
  void hide(bool invisible);
  /// Called when the frame is built: gives the pointer back.
  void end_frame();

  bool hidden() const { return hidden_; }
  /// Whether it has moved again in this frame.
  bool woken() const { return woken_; }
  /// Returns the seconds until a lecture's pointer is hidden, if it does not move.
  double seconds_left() const { return rest_ < patience ? patience - rest_ : 0; }

 private:
  static constexpr double patience = 3;
  ImVec2 at_ = {}, last_ = {};  ///< where it is; where it was in the frame before
  double rest_ = 0;             ///< seconds since it was moved or pressed
  bool hidden_ = false, woken_ = false;
};

}  // namespace isect::viz
