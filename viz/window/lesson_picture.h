#pragma once
// Small pictures of lessons.

#include "viz/gl/renderer.h"
#include "viz/lesson.h"

namespace isect::viz {

/// The size in px of the layout.
constexpr float picture_width = 176, picture_height = 110;

/// Draws the outcome of the lesson's first preset into the renderer's texture. `density`: framebuffer pixels per px.
PixelBox draw_lesson(const Lesson&, const Theme&, Renderer&, double density);

}  // namespace isect::viz
