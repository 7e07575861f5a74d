#include "gl/context.h"
#include "gl/library.h"

namespace telar::gl {
namespace {

// From GL/osmesa.h (the package is not needed to build).
constexpr int OSMESA_RGBA = GL_RGBA;
constexpr int OSMESA_FORMAT = 0x22;
constexpr int OSMESA_PROFILE = 0x33;
constexpr int OSMESA_CORE_PROFILE = 0x34;
constexpr int OSMESA_CONTEXT_MAJOR_VERSION = 0x36;
constexpr int OSMESA_CONTEXT_MINOR_VERSION = 0x37;

using OsmesaHandle = struct osmesa_context*;

class OsmesaContext final : public Context {
 public:
  OsmesaContext() {
    const auto create = library_.function<OsmesaHandle (*)(const int*, OsmesaHandle)>("OSMesaCreateContextAttribs");
    makeCurrent_ = library_.function<MakeCurrent>("OSMesaMakeCurrent");
    destroy_ = library_.function<Destroy>("OSMesaDestroyContext");
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = create(attributes, nullptr);
    if (!context_) throw Error("X_GL", "OSMesaCreateContextAttribs(core 3.3) failed");
    try {
      if (!makeCurrent_(context_, pixel_, GL_UNSIGNED_BYTE, 1, 1))
        throw Error("X_GL", "OSMesaMakeCurrent(1 x 1) failed");
      initialise(Backend::kOsmesa, library_.function<ProcLoader>("OSMesaGetProcAddress"), false, false);
    } catch (...) {
      release();
      throw;
    }
  }
  ~OsmesaContext() override { release(); }

 private:
  using MakeCurrent = GLboolean (*)(OsmesaHandle, void*, GLenum, GLsizei, GLsizei);
  using Destroy = void (*)(OsmesaHandle);

  void release() noexcept {
    makeCurrent_(nullptr, nullptr, 0, 0, 0);
    destroy_(context_);
  }

  Library library_{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
  MakeCurrent makeCurrent_ = nullptr;
  Destroy destroy_ = nullptr;
  OsmesaHandle context_ = nullptr;
  unsigned char pixel_[4] = {};  // the default framebuffer; telar draws into framebuffer objects only
};

}  // namespace

std::unique_ptr<Context> createOsmesa() { return std::make_unique<OsmesaContext>(); }

}  // namespace telar::gl
