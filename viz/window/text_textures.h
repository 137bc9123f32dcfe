#pragma once
// Paragraphs as OpenGL textures, kept while they are in use.

#include <imgui.h>

#include <map>
#include <optional>
#include <vector>

#include "viz/text.h"

namespace isect::viz {

/// Needs the context that was current when it was made, in every call and at its end.
class TextTextures {
 public:
  /// `scale`: framebuffer pixels per px.
  explicit TextTextures(double scale) : scale_(scale) {}
  ~TextTextures();
  TextTextures(const TextTextures&) = delete;
  TextTextures& operator=(const TextTextures&) = delete;

  /// Its picture on the graphics card; none of an empty one.
  ImTextureID of(const Paragraph&);
  /// The size of that picture, in px of the layout. The picture is not drawn for it.
  ImVec2 size_of(const Paragraph&);
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
    ImVec2 size;
    unsigned texture = 0;  ///< none drawn yet
    int last_used = 0;
    std::optional<std::vector<NameBox>> names = {};
  };
  struct Before {
    bool operator()(const Paragraph&, const Paragraph&) const;
  };
  Kept& kept(const Paragraph&);
  double scale_;
  int frame_ = 0;
  std::map<Paragraph, Kept, Before> kept_;
};

}  // namespace isect::viz
