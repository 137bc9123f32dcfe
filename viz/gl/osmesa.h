#pragma once
// OSMesa: Mesa's software renderer as a plain library.

#include "viz/gl/context.h"

namespace isect::viz {

/// Creates a context. Throws NoBackend; always, where it was built without OSMesa.
std::unique_ptr<Context> osmesa_context();

}  // namespace isect::viz
