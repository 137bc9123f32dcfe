#include "viz/window/text_textures.h"

#include <tuple>
#include <utility>

#include "viz/gl/gl.h"

namespace isect::viz {
namespace {

constexpr int frames_kept = 300;

auto all_of(const Paragraph& p) {
  const Colour& c = p.colour;
  return std::tie(p.markup, p.width, p.size, p.line_pitch, p.bold, p.math, c.r, c.g, c.b, c.a);
}

}  // namespace

bool TextTextures::Before::operator()(const Paragraph& a, const Paragraph& b) const { return all_of(a) < all_of(b); }

TextTextures::~TextTextures() { drop(); }

void TextTextures::drop() {
  for (const auto& [paragraph, kept] : kept_) glDeleteTextures(1, &kept.texture);
  kept_.clear();
}

void TextTextures::rescale(double scale) {
  drop();
  scale_ = scale;
}

TextTextures::Kept& TextTextures::kept(const Paragraph& paragraph) {
  const auto [at, fresh] = kept_.try_emplace(paragraph);
  Kept& one = at->second;
  if (fresh) {
    const Vec2 pixels = extent(paragraph, scale_);
    one.size = {static_cast<float>(pixels.x() / scale_), static_cast<float>(pixels.y() / scale_)};
  }
  one.last_used = frame_;
  return one;
}

ImTextureID TextTextures::of(const Paragraph& paragraph) {
  Kept& one = kept(paragraph);
  if (one.texture == 0 && one.size.x > 0 && one.size.y > 0) {
    const double area = one.size.x * one.size.y;
    late_ = late_ || (drawn_ > 0 && drawn_ + area > a_frame_);  // then all that follow wait, too, from the top down
    if (!late_) one.texture = gl::make_texture(raster(paragraph, scale_)), drawn_ += area;
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(one.texture));
}

ImVec2 TextTextures::size_of(const Paragraph& paragraph) { return kept(paragraph).size; }

const std::vector<NameBox>& TextTextures::names(const Paragraph& paragraph) {
  Kept& one = kept(paragraph);
  if (!one.names) one.names = name_boxes(paragraph);
  return *one.names;
}

void TextTextures::next_frame() {
  ++frame_;
  drawn_ = 0, waiting_ = std::exchange(late_, false);
  for (auto it = kept_.begin(); it != kept_.end();) {
    if (frame_ - it->second.last_used < frames_kept) {
      ++it;
      continue;
    }
    glDeleteTextures(1, &it->second.texture);
    it = kept_.erase(it);
  }
}

}  // namespace isect::viz
