#include "viz/gl/renderer.h"

#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "viz/gl/facet_pixels.h"
#include "viz/gl/gl.h"
#include "viz/gl/picture_changes.h"
#include "viz/gl/triangle_batch.h"

namespace isect::viz {
namespace {

/// Colours are blended as sRGB numbers, as cairo blends them, so that PNG and SVG agree.
/// All of it is within GLES 3.0 too, whose first line would be `#version 300 es`.
constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;
uniform vec2 units;   // clip units per unit of the drawing; y runs down in a drawing
uniform vec2 origin;  // where the drawing's corner lies in clip space
out vec2 at;
flat out vec4 ink;  // a triangle has one
void main() {
  at = uv;
  ink = colour;
  gl_Position = vec4(origin + units * place, 0.0, 1.0);
})";

constexpr const char* paint_shader = R"(#version 330 core
flat in vec4 ink;
out vec4 pixel;
void main() { pixel = ink; })";

constexpr const char* image_shader = R"(#version 330 core
in vec2 at;
uniform sampler2D image;
out vec4 pixel;
void main() { pixel = texture(image, at); })";

/// Solves |at - (1 - t) focus| = t for the larger t.
constexpr const char* gradient_shader = R"(#version 330 core
in vec2 at;
uniform vec2 focus;
uniform vec4 inner, outer;
out vec4 pixel;
void main() {
  vec2 d = at - focus;
  float a = 1.0 - dot(focus, focus), b = dot(d, focus);
  float t = (b + sqrt(b * b + a * dot(d, d))) / a;
  pixel = mix(inner, outer, clamp(t, 0.0, 1.0));
})";

}  // namespace

/// The textures of texts. Texts move more often than they change, so their places are not part of the key.
class TextCache {
 public:
  struct Entry {
    unsigned texture = 0;
    int width = 0, height = 0;
    Vec2 corner = Vec2::Zero();  // from the text's anchor, in units
    bool used = true;            // in this frame
  };

  TextCache() = default;
  ~TextCache() {
    for (auto& [key, entry] : entries_) glDeleteTextures(1, &entry.texture);
  }
  TextCache(const TextCache&) = delete;
  TextCache& operator=(const TextCache&) = delete;

  const Entry& find(const Text& text, double scale) {
    Entry& entry = entries_[key(text, scale)];
    entry.used = true;
    if (entry.texture == 0) upload(entry, text, scale);
    return entry;
  }

  /// Ends a frame: if too many pixels are kept, it drops those of texts that this frame did not use.
  void trim() {
    for (auto it = entries_.begin(); it != entries_.end();) {
      Entry& entry = it->second;
      if (pixels_ > most_pixels && !entry.used) {
        pixels_ -= entry.width * entry.height;
        glDeleteTextures(1, &entry.texture);
        it = entries_.erase(it);
      } else {
        entry.used = false;
        ++it;
      }
    }
  }

 private:
  using Key = std::tuple<std::string, double, double, bool, std::array<double, 9>, double>;
  static Key key(const Text& t, double scale) {
    const Colour &c = t.colour, &h = t.halo_colour;
    return {t.markup, t.size, t.align, t.bold, {c.r, c.g, c.b, c.a, t.halo, h.r, h.g, h.b, h.a}, scale};
  }

  void upload(Entry& entry, const Text& text, double scale) {
    Text at_zero = text;  // its pixels do not depend on where it stood first
    at_zero.at = Vec2::Zero();
    const Rastered pixels = raster(at_zero, scale);
    entry = {gl::make_texture(pixels.picture), pixels.picture.width, pixels.picture.height, pixels.corner};
    pixels_ += entry.width * entry.height;
  }

  static constexpr long most_pixels = 8'000'000;  // 32 MB
  std::map<Key, Entry> entries_;
  long pixels_ = 0;  // of all entries
};

namespace {

/// Sets what the pass does to the stencil and whether it writes colour. `mark`: for `once`.
void set_pass(Pass pass, int mark) {
  const bool coloured = pass != Pass::winding && pass != Pass::parity && pass != Pass::wipe;
  glColorMask(coloured, coloured, coloured, coloured);
  (pass == Pass::opaque ? glDisable : glEnable)(GL_BLEND);
  const auto stencil = [mark](GLenum test, GLenum then) {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(test, mark, 0xff);
    glStencilOp(GL_KEEP, then, then);
  };
  switch (pass) {
    case Pass::paint:
    case Pass::opaque:
    case Pass::gradient:
    case Pass::image:
      glDisable(GL_STENCIL_TEST);
      break;
    case Pass::winding:
      stencil(GL_ALWAYS, GL_KEEP);
      glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_INCR_WRAP, GL_INCR_WRAP);
      glStencilOpSeparate(GL_BACK, GL_KEEP, GL_DECR_WRAP, GL_DECR_WRAP);
      break;
    case Pass::parity:
      stencil(GL_ALWAYS, GL_INVERT);
      break;
    case Pass::inside:
      stencil(GL_NOTEQUAL, GL_KEEP);
      break;
    case Pass::finish:
      stencil(GL_NOTEQUAL, GL_ZERO);
      break;
    case Pass::once:
      stencil(GL_NOTEQUAL, GL_REPLACE);
      break;
    case Pass::wipe:
      stencil(GL_ALWAYS, GL_ZERO);
      break;
  }
}

void set_uniform(int at, const Vec2& v) { glUniform2f(at, static_cast<float>(v.x()), static_cast<float>(v.y())); }

void set_uniform(int at, const Colour& c) {
  glUniform4f(at, static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), static_cast<float>(c.a));
}

}  // namespace

struct Renderer::Impl {
  explicit Impl(GetProc proc) : get_proc((gl::load(proc), proc)) {
    glGenVertexArrays(1, &layout);
    glGenBuffers(1, &buffer);
    glBindVertexArray(layout);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    const auto attribute = [](unsigned index, int size, std::size_t offset) {
      glEnableVertexAttribArray(index);
      glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<void*>(offset));
    };
    attribute(0, 2, offsetof(Vertex, x));
    attribute(1, 2, offsetof(Vertex, u));
    attribute(2, 4, offsetof(Vertex, r));
    glBindVertexArray(0);
  }
  ~Impl() {
    glDeleteVertexArrays(1, &layout);
    glDeleteBuffers(1, &buffer);
  }

  /// Returns the triangles of the shapes that may be seen in the box.
  TriangleBatch batch(const Drawing& drawing, double scale, const PixelBox& part, const std::vector<DrawnShape>& shapes,
                      const Box& box) {
    TriangleBatch out(scale);
    for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
      const Shape& shape = drawing.shapes[i];
      if (!meet(shapes[i].box, box)) continue;
      if (const Facets* facets = std::get_if<Facets>(&shape); facets && sketched)
        add_pixels(out, *facets, scale, part);
      else
        std::visit([&](const auto& s) { add(out, s, scale); }, shape);
    }
    return out;
  }

  Box box_of(const Text& text, double scale) {
    if (!(text.size > 0) || !text.at.allFinite()) return {Vec2::Zero(), Vec2::Zero()};
    const TextCache::Entry& entry = texts.find(text, scale);
    const Vec2 corner = whole(text.at, scale) + entry.corner;
    return {corner, corner + Vec2(entry.width, entry.height) / scale};
  }
  /// On whole pixels, texel over pixel, glyphs stay as sharp as they were drawn.
  static Vec2 whole(const Vec2& at, double scale) { return (at * scale).array().round() / scale; }

  void add_pixels(TriangleBatch& out, const Facets& facets, double scale, const PixelBox& part) {
    const auto [picture, corner] = raster(facets, scale, part);
    if (picture.width == 0) return;
    facet_textures.push_back(gl::make_texture(picture));
    out.add_image(facet_textures.back(), {corner, corner + Vec2(picture.width, picture.height) / scale});
  }

  static void add(TriangleBatch& out, const auto& shape, double) { out.add(shape); }
  void add(TriangleBatch& out, const Text& text, double scale) {
    if (!(text.size > 0) || !text.at.allFinite()) return;
    const TextCache::Entry& entry = texts.find(text, scale);
    if (entry.width > 0) out.add_image(entry.texture, box_of(text, scale));
  }

  void play(const TriangleBatch& batch, const Vec2& units, const Vec2& origin) {
    glBindVertexArray(layout);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(batch.vertices().size() * sizeof(Vertex)),
                 batch.vertices().data(), GL_STREAM_DRAW);
    for (const gl::Program* program : {&paint, &image, &gradient}) {
      program->use();
      set_uniform(program->uniform("units"), units);
      set_uniform(program->uniform("origin"), origin);
    }
    int marks = 255;  // on the stencil, from 1 up; the maximum, as the stencil has not been cleared yet
    for (const Call& call : batch.calls()) {
      const bool once = call.pass == Pass::once, plain = call.pass == Pass::paint || call.pass == Pass::opaque ||
                                                         call.pass == Pass::image || call.pass == Pass::gradient;
      if (marks == 255 ? !plain : marks > 0 && !plain && !once) {
        // No depth is used, but it shares words with the stencil: clearing both is much quicker.
        glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        marks = 0;
      }
      set_pass(call.pass, once ? ++marks : 0);
      use_program(call);
      glDrawArrays(GL_TRIANGLES, call.first, call.count);
    }
    glBindVertexArray(0);
    glDeleteTextures(static_cast<GLsizei>(facet_textures.size()), facet_textures.data());
    facet_textures.clear();
  }

  void use_program(const Call& call) {
    if (call.pass == Pass::image) {
      image.use();
      glBindTexture(GL_TEXTURE_2D, call.image);
    } else if (call.pass == Pass::gradient) {
      gradient.use();
      set_uniform(gradient.uniform("focus"), call.radial.focus);
      set_uniform(gradient.uniform("inner"), call.radial.inner);
      set_uniform(gradient.uniform("outer"), call.radial.outer);
    } else {
      paint.use();
    }
  }

  GetProc get_proc;
  unsigned layout = 0, buffer = 0;
  gl::Program paint{vertex_shader, paint_shader};
  gl::Program image{vertex_shader, image_shader};
  gl::Program gradient{vertex_shader, gradient_shader};
  gl::Target& target() { return sketched ? coarse : fine; }
  LastPicture& last() { return sketched ? last_coarse : last_fine; }

  gl::Target fine{4}, coarse{0};
  LastPicture last_fine, last_coarse;  ///< what they show
  TextCache texts;
  bool sketched = false;  ///< whether the last drawing was drawn by the pixel, without four samples
  std::vector<unsigned> facet_textures;
};

PixelBox pixels(const Drawing& drawing, double scale) {
  const auto count = [&](double length) {
    constexpr double rounding = 1e-6;  // the last digits of a product add no pixel
    const double exact = std::ceil(length * scale - rounding);
    if (!(exact > 0 && exact < 1e6)) throw gl::failure("a picture can't have the size of this drawing");
    return static_cast<int>(exact);
  };
  return {0, 0, count(drawing.width), count(drawing.height)};
}

Renderer::Renderer(GetProc get_proc) : impl_(std::make_unique<Impl>(get_proc)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const Drawing& drawing, double scale) { draw(drawing, scale, pixels(drawing, scale)); }

void Renderer::draw(const Drawing& drawing, double scale, const PixelBox& part) {
  impl_->sketched = false;
  make(drawing, scale, part);
}

void Renderer::sketch(const Drawing& drawing, double scale) {
  impl_->sketched = true;
  make(drawing, scale, pixels(drawing, scale));
}

void Renderer::make(const Drawing& drawing, double scale, const PixelBox& part) {
  LastPicture now = {part, scale, drawing.background,
                     drawn_shapes(drawing, [&](const Text& text) { return impl_->box_of(text, scale); })};
  const PixelBox wanted = to_draw(impl_->last(), now);
  impl_->last() = {};  // unknown, until all is drawn
  impl_->target().bind(part.width, part.height);
  const Colour& ground = drawing.background;
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilMask(0xff);
  glEnable(GL_SCISSOR_TEST);
  glScissor(wanted.left - part.left, part.top + part.height - wanted.top - wanted.height, wanted.width, wanted.height);
  glClearColor(static_cast<float>(ground.r), static_cast<float>(ground.g), static_cast<float>(ground.b), 1);
  glClearStencil(0);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT);

  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glActiveTexture(GL_TEXTURE0);

  const Vec2 size(part.width, part.height);
  const Vec2 up(1, -1);
  const Vec2 units = 2 * scale * up.cwiseQuotient(size);
  const Vec2 origin = -up - 2 * up.cwiseProduct(Vec2(part.left, part.top)).cwiseQuotient(size);
  const Vec2 corner(wanted.left, wanted.top), beyond = Vec2::Constant(2);
  const Box box = {(corner - beyond) / scale, (corner + Vec2(wanted.width, wanted.height) + beyond) / scale};
  impl_->play(impl_->batch(drawing, scale, part, now.shapes, box), units, origin);
  impl_->texts.trim();

  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_STENCIL_TEST);
  impl_->target().resolve();
  glDisable(GL_SCISSOR_TEST);
  impl_->last() = std::move(now);
  assert(glGetError() == GL_NO_ERROR);
}

unsigned Renderer::texture() const { return impl_->target().texture(); }
Picture Renderer::read() const { return impl_->target().read(); }
std::string Renderer::name() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }
std::string Renderer::version() const { return reinterpret_cast<const char*>(glGetString(GL_VERSION)); }
void Renderer::reload() { gl::load(impl_->get_proc); }

}  // namespace isect::viz
