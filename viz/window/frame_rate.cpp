#include "viz/window/frame_rate.h"

#include <glad/gl.h>
#include <imgui.h>

#include <chrono>

#include "viz/offscreen.h"
#include "viz/window/window_ui.h"

namespace isect::viz {
namespace {

constexpr int width = 1280, height = 800;

/// Where the frames go.
class Target {
 public:
  Target() {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  }
  ~Target() {
    glDeleteRenderbuffers(1, &colour_);
    glDeleteFramebuffers(1, &framebuffer_);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  unsigned framebuffer() const { return framebuffer_; }

 private:
  unsigned framebuffer_ = 0, colour_ = 0;
};

}  // namespace

double frames_per_second(const std::vector<const Lesson*>& lessons, double seconds) {
  Offscreen offscreen;
  WindowUi ui(lessons, {}, offscreen.renderer(), {}, {.reduced_motion = true});
  const Target target;
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
