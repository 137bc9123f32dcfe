#pragma once
// The few OpenGL objects that a Renderer consists of; the window keeps its texts as textures, too.

#include <glad/gl.h>

#include <stdexcept>
#include <string>

#include "viz/gl/renderer.h"

namespace isect::viz::gl {

/// Loads OpenGL's functions for the current context. Throws where 3.3 is missing.
void load(GetProc);

std::runtime_error failure(const std::string& what);

/// A program of these two shaders. Throws with the compiler's message.
class Program {
 public:
  Program(const char* vertex_shader, const char* fragment_shader);
  ~Program() { glDeleteProgram(id_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void use() const { glUseProgram(id_); }
  int uniform(const char* name) const { return glGetUniformLocation(id_, name); }

 private:
  unsigned id_ = glCreateProgram();
};

/// A framebuffer with so many samples per pixel (0: one) and a stencil, and the texture it is resolved into.
class Target {
 public:
  explicit Target(int samples);
  ~Target();
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  /// Makes it the framebuffer that is drawn into. Throws where it can't have this size.
  void bind(int width, int height);
  void resolve() const;
  /// Returns the resolved colours, rows from the top, opaque.
  Picture read() const;
  unsigned texture() const { return texture_; }

 private:
  void resize(int width, int height);

  unsigned framebuffers_[2], buffers_[2], texture_;  // multisampled, resolved; colour, stencil
  int samples_, width_ = 0, height_ = 0;
};

/// Makes a texture of a picture, to be shown pixel for pixel.
unsigned make_texture(const Picture&);

}  // namespace isect::viz::gl
