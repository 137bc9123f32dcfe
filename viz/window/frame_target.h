#pragma once
// The target of frames of the window that nobody sees.

#include <glad/gl.h>

namespace isect::viz {

/// A framebuffer of this many pixels in the current context; it is bound.
class FrameTarget {
 public:
  FrameTarget(int width, int height) {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  }
  ~FrameTarget() {
    glDeleteRenderbuffers(1, &colour_);
    glDeleteFramebuffers(1, &framebuffer_);
  }
  FrameTarget(const FrameTarget&) = delete;
  FrameTarget& operator=(const FrameTarget&) = delete;

  unsigned framebuffer() const { return framebuffer_; }

 private:
  unsigned framebuffer_ = 0, colour_ = 0;
};

}  // namespace isect::viz
