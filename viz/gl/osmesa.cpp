#include "viz/gl/osmesa.h"

#include "viz/gl/offscreen.h"

#if ISECT_OSMESA
#ifndef APIENTRY  // newer headers of OSMesa expect it of whoever includes them
#define APIENTRY
#endif
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>

namespace isect::viz {
namespace {

/// OSMesa, loaded at its first use. It needs a compiler, LLVM, and loading that takes longer than all else that `isect
/// --help` does; most commands draw no pixels.
class Library {
 public:
  static const Library& get() {
    static const Library library;
    return library;
  }

  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) address = nullptr;

 private:
  Library() {
    void* library = nullptr;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
      if (!library) library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    if (!library) throw NoBackend("osmesa: libOSMesa is not installed");
    load(library, create, "OSMesaCreateContextAttribs");
    load(library, destroy, "OSMesaDestroyContext");
    load(library, make_current, "OSMesaMakeCurrent");
    load(library, address, "OSMesaGetProcAddress");
  }
  template <class Function>
  static void load(void* library, Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (!function) throw NoBackend(std::string("osmesa: this libOSMesa has no ") + name);
  }
};

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
    context_ = mesa_.create(wanted, nullptr);
    if (!context_) throw NoBackend("osmesa: this libOSMesa makes no OpenGL 3.3 core context");
  }
  ~OsMesa() override { mesa_.destroy(context_); }

  void bind() override {
    if (!mesa_.make_current(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side))
      throw NoBackend("osmesa: the context can't be made current");
  }
  void release() override { mesa_.make_current(nullptr, nullptr, 0, 0, 0); }
  GetProc get_proc() const override {
    return [](const char* name) { return reinterpret_cast<void*>(Library::get().address(name)); };
  }

 private:
  static constexpr int side = 16;  // OSMesa insists on a buffer; all drawing goes into a framebuffer of our own
  const Library& mesa_ = Library::get();
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
