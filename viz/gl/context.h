#pragma once
// An OpenGL context with no display, whatever library makes it. osmesa.h and egl.h make one each.

#include <memory>

#include "viz/gl/renderer.h"

namespace isect::viz {

class Context {
 public:
  virtual ~Context() = default;
  virtual void bind() = 0;     ///< make it current
  virtual void release() = 0;  ///< make none current
  virtual GetProc get_proc() const = 0;
};

}  // namespace isect::viz
