#include "viz/gl/offscreen.h"

#include <algorithm>
#include <optional>

#include "viz/gl/egl.h"
#include "viz/gl/mesa.h"
#include "viz/gl/osmesa.h"
#include "viz/gl/resources.h"
#include "viz/lesson.h"

namespace isect::viz {
namespace {

/// The context made current last, of any library. One library's context must be released before another's is bound:
/// they share Mesa's notion of the current context.
Context* current = nullptr;

std::unique_ptr<Context> make_context(Backend backend) {
  return backend == Backend::osmesa ? osmesa_context() : egl_context();
}

/// Size of the parts in which a picture is drawn, in pixels of the result. A snapshot fits in one.
constexpr int part_width = 1024, part_height = 640;

/// The memory that Mesa may still take for one picture.
constexpr std::size_t needed_room = std::size_t{64} << 20;

/// Writes the means of 2 x 2 pixels, rounded to nearest, into `to` with the top left corner at (left, top).
void reduce(const Picture& from, Picture& to, int left, int top) {
  const int width = std::min(from.width / 2, to.width - left);
  const int height = std::min(from.height / 2, to.height - top);
  const std::size_t row = static_cast<std::size_t>(from.width) * 4;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* in = from.rgba.data() + 2 * y * row;
    std::uint8_t* out = to.rgba.data() + 4 * (static_cast<std::size_t>(top + y) * to.width + left);
    for (int x = 0; x < width; ++x, in += 8, out += 4)
      for (int c = 0; c < 4; ++c)
        out[c] = static_cast<std::uint8_t>((in[c] + in[c + 4] + in[c + row] + in[c + 4 + row] + 2) / 4);
  }
}

}  // namespace

std::vector<std::string> backend_names() { return {"auto", "osmesa", "egl"}; }

Backend backend_named(const std::string& name) {
  const std::vector<std::string> names = backend_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Backend>(found - names.begin());
  throw unknown("backend", name, names);
}

struct Offscreen::Impl {
  explicit Impl(Backend b) : backend(b), context(make_context(b)) {
    make_current();
    renderer.emplace(context->get_proc());
    if (renderer->name().rfind("llvmpipe", 0) != 0)
      throw NoBackend(name() + ": the renderer is \"" + renderer->name() +
                      "\", not llvmpipe, and would draw other pixels");
  }
  ~Impl() { make_current(); }

  std::string name() const { return backend_names()[static_cast<std::size_t>(backend)]; }

  void make_current() {
    if (current && current != context.get()) current->release();
    context->bind();
    current = context.get();
    if (renderer) renderer->reload();
  }

  /// Releases the context after the renderer is gone and before the context is, also when the constructor throws.
  struct Release {
    Context& context;
    ~Release() {
      context.release();
      current = nullptr;
    }
  };

  Backend backend;
  std::unique_ptr<Context> context;
  Release release{*context};
  std::optional<Renderer> renderer;
};

Offscreen::Offscreen(Backend wanted) {
  prepare_mesa();
  const bool any = wanted == Backend::automatic;
  std::string tried;
  for (const Backend backend : {Backend::osmesa, Backend::egl}) {
    if (!any && backend != wanted) continue;
    try {
      impl_ = std::make_unique<Impl>(backend);
      return;
    } catch (const std::runtime_error& error) {
      tried += std::string("\n  ") + error.what();
    }
  }
  throw NoBackend("no way to draw without a display:" + tried +
                  "\nOn Debian: apt install libosmesa6 libegl1 libgl1-mesa-dri");
}

Offscreen::~Offscreen() = default;

Renderer& Offscreen::renderer() {
  impl_->make_current();
  return *impl_->renderer;
}

GetProc Offscreen::get_proc() const { return impl_->context->get_proc(); }
Backend Offscreen::backend() const { return impl_->backend; }
std::string Offscreen::name() const { return impl_->name(); }

std::string Offscreen::driver() const {
  impl_->make_current();
  return impl_->renderer->name();
}

Picture Offscreen::render(const Drawing& drawing, double scale) {
  Renderer& gl = renderer();
  const PixelBox whole = pixels(drawing, scale);
  const int width = whole.width, height = whole.height;
  Picture out{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4) * width * height)};
  if (!has_room(needed_room)) throw std::bad_alloc();
  const int wide = std::min(width, part_width), high = std::min(height, part_height);
  for (int top = 0; top < height; top += high)
    for (int left = 0; left < width; left += wide) {
      gl.draw(drawing, 2 * scale, {2 * left, 2 * top, 2 * wide, 2 * high});
      reduce(gl.read(), out, left, top);
    }
  return out;
}

}  // namespace isect::viz
