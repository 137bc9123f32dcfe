#pragma once
// EGL without a surface: what takes OSMesa's place from Mesa 25.1 on.

#include "viz/context.h"

namespace isect::viz {

/// Throws NoBackend; always, where it was built without EGL.
std::unique_ptr<Context> egl_context();

}  // namespace isect::viz
