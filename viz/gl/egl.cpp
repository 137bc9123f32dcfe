#include "viz/gl/egl.h"

#include "viz/gl/offscreen.h"

#if ISECT_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <optional>

namespace isect::viz {
namespace {

/// While an object of this class lives, Mesa chooses its software renderer even where there is a graphics card: the
/// pictures must be the same everywhere.
class SoftwareOnly {
 public:
  SoftwareOnly() {
    if (const char* old = std::getenv(name)) before_ = old;
    setenv(name, "true", 1);
  }
  ~SoftwareOnly() {
    if (before_)
      setenv(name, before_->c_str(), 1);
    else
      unsetenv(name);
  }
  SoftwareOnly(const SoftwareOnly&) = delete;
  SoftwareOnly& operator=(const SoftwareOnly&) = delete;

 private:
  static constexpr const char* name = "LIBGL_ALWAYS_SOFTWARE";
  std::optional<std::string> before_;
};

/// Opens the display. All callers get the same one, so it stays open: closing it would end the other contexts too.
EGLDisplay open_display() {
  const SoftwareOnly software_only;
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
    throw NoBackend("egl: this libEGL opens no display without a surface");
  return display;
}

class Egl : public Context {
 public:
  Egl() {
    const EGLint no_surface[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    const EGLint wanted[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglBindAPI(EGL_OPENGL_API) && eglChooseConfig(display_, no_surface, &config, 1, &count) && count > 0)
      context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, wanted);
    if (context_ == EGL_NO_CONTEXT) throw NoBackend("egl: this libEGL makes no OpenGL 3.3 core context");
  }
  ~Egl() override { eglDestroyContext(display_, context_); }

  void bind() override {
    if (!eglBindAPI(EGL_OPENGL_API) || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw NoBackend("egl: the context can't be made current");
  }
  void release() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  GetProc get_proc() const override {
    return [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); };
  }

 private:
  EGLDisplay display_ = open_display();
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> egl_context() { return std::make_unique<Egl>(); }

}  // namespace isect::viz

#else

namespace isect::viz {

std::unique_ptr<Context> egl_context() { throw NoBackend("egl: not built in; install libegl-dev and build again"); }

}  // namespace isect::viz
#endif
