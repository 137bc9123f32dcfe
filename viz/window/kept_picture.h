#pragma once
// A copy of what the renderer drew last, for one part of the window, while the renderer draws another part.

#include <imgui.h>

namespace isect::viz {

/// Every call, and the destructor, needs the context that was current at the first take().
class KeptPicture {
 public:
  KeptPicture() = default;
  ~KeptPicture();
  KeptPicture(const KeptPicture&) = delete;
  KeptPicture& operator=(const KeptPicture&) = delete;

  /// Copies a texture of this many pixels.
  void take(unsigned texture, int width, int height);
  /// Returns the texture for Dear ImGui; v runs upwards. Null before the first take().
  ImTextureID id() const;

 private:
  unsigned texture_ = 0, framebuffer_ = 0;
};

}  // namespace isect::viz
