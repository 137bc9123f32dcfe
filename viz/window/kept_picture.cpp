#include "viz/window/kept_picture.h"

#include <glad/gl.h>

#include <cstdint>
#include <initializer_list>

namespace isect::viz {

KeptPicture::~KeptPicture() {
  if (texture_ == 0) return;
  glDeleteTextures(1, &texture_);
  glDeleteFramebuffers(1, &framebuffer_);
}

void KeptPicture::take(unsigned texture, int width, int height) {
  if (texture_ == 0) {
    glGenTextures(1, &texture_);
    glGenFramebuffers(1, &framebuffer_);
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, width, height, 0);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum way : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, way, GL_CLAMP_TO_EDGE);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

ImTextureID KeptPicture::id() const { return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_)); }

}  // namespace isect::viz
