#pragma once
// A pointer that rests during a lecture: the keys step on, and it would light whatever comes to lie under it.

#include <imgui.h>

#include <optional>

namespace isect::viz {

class RestingPointer {
 public:
  /// Called before Dear ImGui begins a frame. `seconds`: since the pointer last moved. Hides that of a lecture
  /// after `pointer_patience`: until it moves or a button is pressed, it is nowhere. Returns whether it has come back.
  bool begin_frame(bool lecture, double seconds);
  bool hidden() const { return at_.has_value(); }

 private:
  std::optional<ImVec2> at_;  ///< where it rests; none: it is not hidden
};

}  // namespace isect::viz
