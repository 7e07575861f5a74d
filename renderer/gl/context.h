#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gl/functions.h"
#include "gl/pacer.h"
#include "telar/renderer.h"

namespace telar::gl {

/// "auto", "egl-device", "egl-surfaceless", "osmesa".
const char* backendName(Backend backend);

/// What one backend gave when it was tried.
struct Attempt {
  Backend backend;
  std::string device;  ///< EGL device or library, may be empty
  bool works = false;
  bool software = false;
  std::string vendor, renderer, version;  ///< GL strings when it works
  std::string failure;                    ///< call, error and attributes when it does not
  std::string cure;                       ///< what to install or set
};

/// Capabilities that the renderer asks about.
struct Capabilities {
  bool robust = false;            ///< robust buffer access and reset notification granted
  bool debug = false;             ///< KHR_debug messages are being collected
  bool colorBufferFloat = false;  ///< RGBA32F is renderable
  bool floatLinear = false;       ///< fp32 textures can be filtered
  bool sampleMask = false;        ///< a fragment can choose the samples that it covers
  bool samplePlaces = false;      ///< the GL tells where a pixel's samples are
  bool bufferTextures = false;    ///< shaders of ES 3.20 read buffers as textures
  bool shadesHidden = false;      ///< fragments of a multisampled target are shaded though the depth test hides them
  bool desktop = false;           ///< an OpenGL core profile with ARB_ES3_compatibility (OSMesa)
  int maxTextureSize = 0;         ///< px
  int maxSamples = 0;
  int maxFragmentTextureUnits = 0;
};

/// An OpenGL ES 3.0 context without a window, current on the thread that made it until it is destroyed there.
class Context {
 public:
  /// Tries the backends in the order EGL on a hardware device, EGL surfaceless, OSMesa (or only the one asked for).
  /// @throws Error{X_GL} listing what was tried, why it failed and the cure.
  static std::unique_ptr<Context> create(Backend backend);
  virtual ~Context() = default;

  const Functions& gl() const { return functions_; }
  /// Counts what this context has to do.
  Pacer& pacer() const { return pacer_; }
  const Capabilities& capabilities() const { return capabilities_; }
  Backend backend() const { return backend_; }
  const std::string& vendor() const { return vendor_; }
  const std::string& renderer() const { return renderer_; }
  const std::string& version() const { return version_; }
  /// Attempts that failed before this one, and why this one was chosen.
  const std::vector<Attempt>& attempts() const { return attempts_; }

  /// Begins a job: its work is counted from here, and samplers and masks are as in a new context. A job that was ended
  /// half way has left its own, and environments are prefiltered without any.
  void beginJob(const CancelToken& cancel, double sliceMs) const;

  /// @throws Error{X_GL} when the driver reports an error, a HIGH severity debug message or a lost context.
  /// `where` names the step for the message.
  void check(const char* where) const;

 protected:
  /// Called by a backend once its context is current.
  void initialise(Backend backend, ProcLoader loader, bool debug, bool robust);

 private:
  void installDebugCallback();
  std::string takeDebugMessages() const;

  Functions functions_;
  mutable Pacer pacer_{functions_};
  Capabilities capabilities_;
  Backend backend_ = Backend::kAuto;
  std::string vendor_, renderer_, version_;
  std::vector<Attempt> attempts_;
  mutable std::vector<std::string> debugMessages_;
  friend std::vector<Attempt> probe();
};

/// Tries every backend and destroys what it made.
std::vector<Attempt> probe();

// One per backend: context_egl.cpp, context_osmesa.cpp. @throws Error{X_GL}
std::unique_ptr<Context> createEglDevice(bool allowSoftware, std::string& deviceName);
std::unique_ptr<Context> createEglSurfaceless();
std::unique_ptr<Context> createOsmesa();

}  // namespace telar::gl
