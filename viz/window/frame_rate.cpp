#include "viz/window/frame_rate.h"

#include <imgui.h>

#include <chrono>

#include "viz/gl/offscreen.h"
#include "viz/window/frame_target.h"
#include "viz/window/window_ui.h"

namespace isect::viz {

double frames_per_second(const std::vector<const Lesson*>& lessons, double seconds) {
  constexpr int width = 1280, height = 800;
  Offscreen offscreen;
  WindowUi ui(lessons, {}, offscreen.renderer(), {}, {.reduced_motion = true});
  const FrameTarget target(width, height);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {width, height};
  const auto frame = [&] {
    ui.player().at_end() ? ui.player().first() : ui.player().next();
    io.DeltaTime = 1.0f / 60;
    ui.frame();
    ui.draw(target.framebuffer());
    glFinish();
  };
  for (int i = 0; i < 3; ++i) frame();  // compiles shaders, fills the fonts' texture

  const auto start = std::chrono::steady_clock::now();
  for (int frames = 1;; ++frames) {
    frame();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    if (passed.count() >= seconds && frames >= 10) return frames / passed.count();
  }
}

}  // namespace isect::viz
