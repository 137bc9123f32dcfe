#pragma once
// What the renderer drew last, kept for one part of the window while the renderer goes on to another.

#include <imgui.h>

namespace isect::viz {

/// Needs the context that was current at its first take() in every call and at its end.
class KeptPicture {
 public:
  KeptPicture() = default;
  ~KeptPicture();
  KeptPicture(const KeptPicture&) = delete;
  KeptPicture& operator=(const KeptPicture&) = delete;

  /// Copies a texture of so many pixels.
  void take(unsigned texture, int width, int height);
  /// For Dear ImGui; v runs upwards. Nothing, before the first take().
  ImTextureID id() const;

 private:
  unsigned texture_ = 0, framebuffer_ = 0;
};

}  // namespace isect::viz
