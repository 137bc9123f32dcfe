#pragma once
// EGL without a surface: it replaces OSMesa from Mesa 25.1 on.

#include "viz/gl/context.h"

namespace isect::viz {

/// Creates a context. Throws NoBackend; always, where it was built without EGL.
std::unique_ptr<Context> egl_context();

}  // namespace isect::viz
