#pragma once
// Drawing -> pixels with OpenGL 3.3 core. The same code under OSMesa, EGL and a GLFW window.

#include <memory>
#include <string>

#include "viz/drawing.h"
#include "viz/text/text.h"

namespace isect::viz {

/// Looks up OpenGL's functions in a context.
using GetProc = void* (*)(const char*);

/// A rectangle of a picture, in pixels from its top left corner.
struct PixelBox {
  int left = 0, top = 0, width = 0, height = 0;
  bool operator==(const PixelBox&) const = default;
};

/// Returns the pixels that a drawing covers at this scale. Throws std::runtime_error unless both sides are positive.
PixelBox pixels(const Drawing&, double scale);

/// Needs a current context; loads the functions with `get_proc` (again for every context). Throws
/// std::runtime_error where OpenGL 3.3 is missing or the framebuffer is incomplete. Keeps the textures of
/// texts it has drawn, so a second frame is quick. Its own context must be current whenever it is called or
/// destroyed.
class Renderer {
 public:
  explicit Renderer(GetProc);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws into an own multisampled framebuffer, `scale` pixels per unit of the drawing. Where the picture
  /// is the same as the last one, it is not drawn again. The result stays in texture() until the next call; nothing
  /// else of the context's state is promised.
  void draw(const Drawing&, double scale = 1);
  /// Draws the picture in less time: by the pixel, so that slanted edges are jagged.
  void sketch(const Drawing&, double scale = 1);
  /// Draws only the picture's `part`; beyond the drawing's edge lies background.
  void draw(const Drawing&, double scale, const PixelBox& part);
  unsigned texture() const;     ///< resolved colour, for ImGui::Image (v runs upwards)
  Picture read() const;         ///< the last drawing as a picture
  std::string name() const;     ///< GL_RENDERER
  std::string version() const;  ///< GL_VERSION, which names Mesa's own
  /// Loads the functions again, after those of another context were loaded.
  void reload();

 private:
  void make(const Drawing&, double scale, const PixelBox& part);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace isect::viz
