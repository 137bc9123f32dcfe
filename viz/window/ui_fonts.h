#pragma once
// The window's fonts: DejaVu Sans and DejaVu Sans Mono, found by fontconfig, with every sign the lessons use.

#include <imgui.h>

namespace isect::viz {

struct UiFonts {
  ImFont *body, *small, *bold, *heading, *mono, *mono_small, *mono_large;
};

/// Fills the atlas of the current Dear ImGui context; `scale`: framebuffer pixels per px. Throws
/// std::runtime_error where no font file is found.
UiFonts load_fonts(double scale);

}  // namespace isect::viz
