#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>

#include "gl/context.h"
#include "gl/library.h"

namespace telar::gl {
namespace {

const char* eglErrorName(EGLint error) {
  switch (error) {
    case EGL_SUCCESS:
      return "EGL_SUCCESS";
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_CONTEXT:
      return "EGL_BAD_CONTEXT";
    case EGL_BAD_DISPLAY:
      return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    default:
      return "an unknown EGL error";
  }
}

/// The EGL entry points that telar calls, from libEGL.so.1.
struct Egl {
  Library library{"libEGL.so.1", "libEGL.so"};
#define TELAR_EGL(type, name) type name = library.function<type>("egl" #name);
  TELAR_EGL(PFNEGLGETPROCADDRESSPROC, GetProcAddress)
  TELAR_EGL(PFNEGLQUERYSTRINGPROC, QueryString)
  TELAR_EGL(PFNEGLINITIALIZEPROC, Initialize)
  TELAR_EGL(PFNEGLBINDAPIPROC, BindAPI)
  TELAR_EGL(PFNEGLCHOOSECONFIGPROC, ChooseConfig)
  TELAR_EGL(PFNEGLCREATECONTEXTPROC, CreateContext)
  TELAR_EGL(PFNEGLDESTROYCONTEXTPROC, DestroyContext)
  TELAR_EGL(PFNEGLCREATEPBUFFERSURFACEPROC, CreatePbufferSurface)
  TELAR_EGL(PFNEGLDESTROYSURFACEPROC, DestroySurface)
  TELAR_EGL(PFNEGLMAKECURRENTPROC, MakeCurrent)
  TELAR_EGL(PFNEGLRELEASETHREADPROC, ReleaseThread)
  TELAR_EGL(PFNEGLGETERRORPROC, GetError)
#undef TELAR_EGL

  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(GetProcAddress(name));
  }
  [[noreturn]] void fail(const std::string& call) const {
    throw Error("X_GL", call + " failed with " + eglErrorName(GetError()));
  }
  bool has(EGLDisplay display, const char* name) const {
    const char* list = QueryString(display, EGL_EXTENSIONS);
    if (!list) return false;
    const std::size_t length = std::strlen(name);
    for (const char* at = list; (at = std::strstr(at, name)); at += length) {
      if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) return true;
    }
    return false;
  }
};

class EglContext final : public Context {
 public:
  /// Takes a display of either platform, makes a context and makes it current. The display itself is shared by the
  /// whole process (EGL gives the same one for the same platform), so it is initialised but never terminated here.
  EglContext(Egl egl, EGLDisplay display, Backend backend) : egl_(std::move(egl)), display_(display) {
    try {
      EGLint major = 0, minor = 0;
      if (!egl_.Initialize(display_, &major, &minor)) egl_.fail("eglInitialize");
      if (!egl_.BindAPI(EGL_OPENGL_ES_API)) egl_.fail("eglBindAPI(EGL_OPENGL_ES_API)");
      createContext();
      makeCurrent();
      initialise(backend, reinterpret_cast<ProcLoader>(egl_.GetProcAddress), false, robust_);
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~EglContext() override { destroy(); }

 private:
  void createContext() {
    const bool noConfig = egl_.has(display_, "EGL_KHR_no_config_context");
    if (!noConfig || !egl_.has(display_, "EGL_KHR_surfaceless_context")) config_ = chooseConfig();
    // Robust first, then plain: a driver may refuse the attributes although it lists the extension.
    if (egl_.has(display_, "EGL_EXT_create_context_robustness")) {
      const EGLint robust[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               0,
                               EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT,
                               EGL_TRUE,
                               EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                               EGL_LOSE_CONTEXT_ON_RESET_EXT,
                               EGL_NONE};
      context_ = egl_.CreateContext(display_, config_, EGL_NO_CONTEXT, robust);
      robust_ = context_ != EGL_NO_CONTEXT;
    }
    if (context_ == EGL_NO_CONTEXT) {
      const EGLint plain[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
      context_ = egl_.CreateContext(display_, config_, EGL_NO_CONTEXT, plain);
    }
    if (context_ == EGL_NO_CONTEXT) egl_.fail("eglCreateContext(OpenGL ES 3.0)");
  }

  EGLConfig chooseConfig() {
    const EGLint attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl_.ChooseConfig(display_, attributes, &config, 1, &count) || count < 1) {
      egl_.fail("eglChooseConfig(OpenGL ES 3.0, pbuffer)");
    }
    return config;
  }

  void makeCurrent() {
    if (!egl_.has(display_, "EGL_KHR_surfaceless_context")) {
      const EGLint attributes[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
      surface_ = egl_.CreatePbufferSurface(display_, config_, attributes);
      if (surface_ == EGL_NO_SURFACE) egl_.fail("eglCreatePbufferSurface(1 x 1)");
    }
    if (!egl_.MakeCurrent(display_, surface_, surface_, context_)) egl_.fail("eglMakeCurrent");
  }

  void destroy() noexcept {
    egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != EGL_NO_SURFACE) egl_.DestroySurface(display_, surface_);
    if (context_ != EGL_NO_CONTEXT) egl_.DestroyContext(display_, context_);
    surface_ = EGL_NO_SURFACE;
    context_ = EGL_NO_CONTEXT;
    egl_.ReleaseThread();
  }

  Egl egl_;
  EGLDisplay display_;
  EGLConfig config_ = nullptr;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
  bool robust_ = false;
};

EGLDisplay platformDisplay(const Egl& egl, EGLenum platform, void* native, const char* name) {
  const auto get = egl.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!get) throw Error("X_GL", "libEGL has no eglGetPlatformDisplayEXT");
  const EGLDisplay display = get(platform, native, nullptr);
  if (display == EGL_NO_DISPLAY) egl.fail(std::string("eglGetPlatformDisplayEXT(") + name + ")");
  return display;
}

}  // namespace

std::unique_ptr<Context> createEglSurfaceless() {
  Egl egl;
  if (!egl.has(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    throw Error("X_GL", "no EGL vendor library offers EGL_MESA_platform_surfaceless");
  }
  const EGLDisplay display = platformDisplay(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "surfaceless");
  return std::make_unique<EglContext>(std::move(egl), display, Backend::kEglSurfaceless);
}

std::unique_ptr<Context> createEglDevice(bool allowSoftware, std::string& deviceName) {
  Egl egl;
  const auto queryDevices = egl.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto queryString = egl.extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (!queryDevices || !queryString) throw Error("X_GL", "libEGL has no EGL_EXT_device_enumeration");
  constexpr EGLint DEVICES_MAX = 32;
  EGLDeviceEXT devices[DEVICES_MAX];
  EGLint count = 0;
  if (!queryDevices(DEVICES_MAX, devices, &count)) egl.fail("eglQueryDevicesEXT");
  std::string failure = "no EGL device";
  // Hardware devices first, then software ones where they are allowed.
  for (const bool software : {false, true}) {
    if (software && !allowSoftware) {
      if (count > 0 && failure == "no EGL device") failure = "only a software EGL device; surfaceless EGL serves it";
      break;
    }
    for (EGLint i = 0; i < count; ++i) {
      const char* extensions = queryString(devices[i], EGL_EXTENSIONS);
      const bool isSoftware = extensions && std::strstr(extensions, "EGL_MESA_device_software");
      if (isSoftware != software) continue;
      try {
        const char* node = nullptr;
        if (extensions && std::strstr(extensions, "EGL_EXT_device_drm"))
          node = queryString(devices[i], EGL_DRM_DEVICE_FILE_EXT);
        deviceName = node ? node : (software ? "software" : "device " + std::to_string(i));
        Egl own;
        const EGLDisplay display = platformDisplay(own, EGL_PLATFORM_DEVICE_EXT, devices[i], "device");
        return std::make_unique<EglContext>(std::move(own), display, Backend::kEglDevice);
      } catch (const Error& error) {
        failure = deviceName + ": " + error.what();
      }
    }
  }
  throw Error("X_GL", failure);
}

}  // namespace telar::gl
