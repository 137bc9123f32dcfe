#pragma once
// An OpenGL context with no display: OSMesa first, EGL surfaceless second, chosen at run time.

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "viz/gl/renderer.h"

namespace isect::viz {

enum class Backend { automatic, osmesa, egl };

std::vector<std::string> backend_names();  ///< "auto", "osmesa", "egl"
/// Returns the back end. Throws BadInput naming the nearest.
Backend backend_named(const std::string&);

/// The message says why no back end is available: what was tried and what is missing.
struct NoBackend : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Several may exist at once, in one thread: each makes itself current when it is used. A window's context
/// must be released before (`glfwMakeContextCurrent(nullptr)`), and made current and its Renderer reloaded
/// afterwards.
class Offscreen {
 public:
  /// Makes its context current. Throws NoBackend.
  explicit Offscreen(Backend = Backend::automatic);
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  Renderer& renderer();  ///< makes its context current
  GetProc get_proc() const;
  Backend backend() const;     ///< the one in use
  std::string name() const;    ///< "osmesa" or "egl"
  std::string driver() const;  ///< what OpenGL calls its renderer
  /// Draws at twice the size under four samples and reduces: smooth edges, the same bytes every time. Large
  /// pictures are drawn in parts, so memory stays bounded by the result's own size.
  Picture render(const Drawing&, double scale = 1);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace isect::viz
