#pragma once
// The window's fonts: DejaVu Sans and DejaVu Sans Mono, found by fontconfig, with every sign the lessons use.

#include <imgui.h>

namespace isect::viz {

/// px of the layout: one scale for everything that is read; nothing is smaller than the body but names in pictures.
/// In a lecture words and code grow with the window (viz/window/layout.h).
constexpr double body_size = 15, heading_size = 19, large_size = 20;

struct UiFonts {
  ImFont *body, *bold, *heading, *mono, *mono_large;
  double large = large_size;  ///< px of mono_large
};

/// Fills the atlas of the current Dear ImGui context; `scale`: framebuffer pixels per px; `large`: px of the lines that
/// are read from afar. Throws std::runtime_error where no font file is found.
UiFonts load_fonts(double scale, double large = large_size);

}  // namespace isect::viz
