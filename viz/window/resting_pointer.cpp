#include "viz/window/resting_pointer.h"

#include <cfloat>
#include <cmath>

#include "viz/window/widgets.h"

namespace isect::viz {

bool RestingPointer::begin_frame(bool lecture, double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  const bool pressed = ImGui::IsAnyMouseDown() || io.MouseWheel != 0, there = ImGui::IsMousePosValid(&io.MousePos);
  if (!at_) {
    if (!lecture || !there || pressed || seconds < pointer_patience) return false;
    at_ = io.MousePos;
  }
  // Dear ImGui rounds it down to whole px.
  const bool moved = there && !(std::abs(io.MousePos.x - at_->x) < 1 && std::abs(io.MousePos.y - at_->y) < 1);
  if (lecture && !moved && !pressed) {  // some back ends tell in each frame where it is
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    return false;
  }
  if (!there) io.MousePos = *at_;
  at_.reset();
  return true;
}

}  // namespace isect::viz
