#include "viz/window/text_textures.h"

#include <fmt/format.h>

#include "viz/gl.h"

namespace isect::viz {
namespace {

constexpr int frames_kept = 300;

std::string key_of(const Paragraph& p) {
  const Colour& c = p.colour;
  return fmt::format("{}|{}|{}|{}{}|{:.4f},{:.4f},{:.4f},{:.4f}|{}", p.width, p.size, p.line_pitch, p.bold, p.math, c.r,
                     c.g, c.b, c.a, p.markup);
}

}  // namespace

TextTextures::~TextTextures() { drop(); }

void TextTextures::drop() {
  for (const auto& [key, kept] : kept_) glDeleteTextures(1, &kept.name);
  kept_.clear();
}

void TextTextures::rescale(double scale) {
  drop();
  scale_ = scale;
}

TextTextures::Kept* TextTextures::kept(const Paragraph& paragraph) {
  const std::string key = key_of(paragraph);
  auto found = kept_.find(key);
  if (found == kept_.end()) {
    const Picture picture = raster(paragraph, scale_);
    if (picture.width == 0 || picture.height == 0) return nullptr;
    const unsigned name = gl::make_texture(picture);
    const ImVec2 size{static_cast<float>(picture.width / scale_), static_cast<float>(picture.height / scale_)};
    const TextImage image{reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name)), size};
    found = kept_.emplace(key, Kept{image, name, frame_}).first;
  }
  found->second.last_used = frame_;
  return &found->second;
}

TextImage TextTextures::of(const Paragraph& paragraph) {
  const Kept* const one = kept(paragraph);
  return one ? one->image : TextImage{nullptr, {0, 0}};
}

const std::vector<NameBox>& TextTextures::names(const Paragraph& paragraph) {
  static const std::vector<NameBox> none;
  Kept* const one = kept(paragraph);
  if (!one) return none;
  if (!one->names) one->names = name_boxes(paragraph);
  return *one->names;
}

void TextTextures::next_frame() {
  ++frame_;
  for (auto it = kept_.begin(); it != kept_.end();) {
    if (frame_ - it->second.last_used < frames_kept) {
      ++it;
      continue;
    }
    glDeleteTextures(1, &it->second.name);
    it = kept_.erase(it);
  }
}

}  // namespace isect::viz
