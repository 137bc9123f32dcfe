#include "viz/osmesa.h"

#include "viz/offscreen.h"

#if ISECT_OSMESA
#include <GL/osmesa.h>

#include <array>

namespace isect::viz {
namespace {

class OsMesa : public Context {
 public:
  OsMesa() {
    const int wanted[] = {OSMESA_PROFILE,
                          OSMESA_CORE_PROFILE,
                          OSMESA_FORMAT,
                          OSMESA_RGBA,
                          OSMESA_CONTEXT_MAJOR_VERSION,
                          3,
                          OSMESA_CONTEXT_MINOR_VERSION,
                          3,
                          0};
    context_ = OSMesaCreateContextAttribs(wanted, nullptr);
    if (!context_) throw NoBackend("osmesa: this libOSMesa makes no OpenGL 3.3 core context");
  }
  ~OsMesa() override { OSMesaDestroyContext(context_); }

  void bind() override {
    if (!OSMesaMakeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side))
      throw NoBackend("osmesa: the context can't be made current");
  }
  void release() override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }
  GetProc get_proc() const override {
    return [](const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); };
  }

 private:
  static constexpr int side =
      16;  // OSMesa insists on a buffer; all drawing goes into a framebuffer of our own
  std::array<unsigned char, side * side * 4> unused_{};
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> osmesa_context() { return std::make_unique<OsMesa>(); }

}  // namespace isect::viz

#else

namespace isect::viz {

std::unique_ptr<Context> osmesa_context() {
  throw NoBackend("osmesa: not built in; install libosmesa6-dev and build again");
}

}  // namespace isect::viz
#endif
