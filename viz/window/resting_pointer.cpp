#include "viz/window/resting_pointer.h"

#include <cfloat>
#include <utility>

namespace isect::viz {

void RestingPointer::begin_frame(bool lecture, double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  at_ = io.MousePos;
  const ImVec2 before = std::exchange(last_, at_);
  const bool moved = at_.x != before.x || at_.y != before.y;
  const bool used = moved || io.MouseDown[0] || io.MouseDown[1] || io.MouseWheel != 0;
  rest_ = used ? 0 : rest_ + seconds;
  const bool was_hidden = std::exchange(hidden_, lecture && rest_ >= patience);
  woken_ = was_hidden && !hidden_;
  if (hidden_) io.MousePos = {-FLT_MAX, -FLT_MAX};
}

void RestingPointer::hide(bool invisible) {
  const ImVec2& now = ImGui::GetIO().MousePos;
  if (hidden_ && ImGui::IsMousePosValid(&now)) {  // an event of this frame has moved it
    at_ = last_ = now, rest_ = 0;
    hidden_ = false, woken_ = true;
  }
  if (hidden_ || invisible) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
}

void RestingPointer::end_frame() {
  if (hidden_) ImGui::GetIO().MousePos = at_;
}

}  // namespace isect::viz
