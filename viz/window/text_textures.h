#pragma once
// Paragraphs as OpenGL textures, kept while they are in use.

#include <imgui.h>

#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "viz/text/text.h"

namespace isect::viz {

/// Every call, and the destructor, needs the context that was current when it was made.
class TextTextures {
 public:
  /// `scale`: framebuffer pixels per px. `a_frame`: the most square px of texts that a frame draws, not counting its
  /// first one.
  explicit TextTextures(double scale, double a_frame = std::numeric_limits<double>::infinity())
      : scale_(scale), a_frame_(a_frame) {}
  ~TextTextures();
  TextTextures(const TextTextures&) = delete;
  TextTextures& operator=(const TextTextures&) = delete;

  /// Returns its picture on the graphics card; none if it is empty or waits for the next frame.
  ImTextureID of(const Paragraph&);
  /// Returns the size of that picture, in px of the layout, without drawing it.
  ImVec2 size_of(const Paragraph&);
  /// Returns where its names stand, in px from its top left corner.
  const std::vector<NameBox>& names(const Paragraph&);
  /// Sets the number of framebuffer pixels per px from now on.
  void rescale(double scale);
  /// Ends a frame: texts that were not used during the last few hundred frames are dropped.
  void next_frame();
  /// Whether a text that the last frame wanted is still to be drawn.
  bool waiting() const { return waiting_; }
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
  double scale_, a_frame_, drawn_ = 0;
  bool late_ = false, waiting_ = false;
  int frame_ = 0;
  std::map<Paragraph, Kept, Before> kept_;
};

}  // namespace isect::viz
