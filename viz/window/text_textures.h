#pragma once
// Paragraphs as OpenGL textures, kept while they are in use.

#include <imgui.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viz/text.h"

namespace isect::viz {

/// A picture on the graphics card, with its size in px of the layout.
struct TextImage {
  ImTextureID texture;
  ImVec2 size;
};

/// Needs the context that was current when it was made, in every call and at its end.
class TextTextures {
 public:
  /// `scale`: framebuffer pixels per px.
  explicit TextTextures(double scale) : scale_(scale) {}
  ~TextTextures();
  TextTextures(const TextTextures&) = delete;
  TextTextures& operator=(const TextTextures&) = delete;

  TextImage of(const Paragraph&);
  /// Where its names stand, in px from its top left corner.
  const std::vector<NameBox>& names(const Paragraph&);
  /// From now on so many framebuffer pixels per px.
  void rescale(double scale);
  /// Ends a frame: what has not been asked for during the last few hundred frames is dropped.
  void next_frame();
  std::size_t size() const { return kept_.size(); }

 private:
  void drop();
  struct Kept {
    TextImage image;
    unsigned name;
    int last_used;
    std::optional<std::vector<NameBox>> names = {};
  };
  Kept* kept(const Paragraph&);
  double scale_;
  int frame_ = 0;
  std::map<std::string, Kept> kept_;
};

}  // namespace isect::viz
