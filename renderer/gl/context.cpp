#include "gl/context.h"

#include <cstring>
#include <nlohmann/json.hpp>

namespace telar::gl {
namespace {

constexpr GLenum TEXTURE_CUBE_MAP_SEAMLESS = 0x884F;  // desktop GL only; always on in ES 3.0
constexpr GLenum PROGRAM_POINT_SIZE = 0x8642;         // desktop GL only; always on in ES 3.0
constexpr std::size_t DEBUG_MESSAGES_MAX = 16;

#ifdef TELAR_GL_DEBUG
constexpr bool WANT_DEBUG = true;
#else
constexpr bool WANT_DEBUG = false;
#endif

std::string text(const Functions& gl, GLenum name) {
  const auto* s = reinterpret_cast<const char*>(gl.GetString(name));
  return s ? s : "";
}

bool hasExtension(const Functions& gl, const char* name) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* s = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (s && std::strcmp(s, name) == 0) return true;
  }
  return false;
}

bool isAtLeast(const Functions& gl, GLint major, GLint minor) {
  GLint has[2] = {};
  gl.GetIntegerv(GL_MAJOR_VERSION, &has[0]);
  gl.GetIntegerv(GL_MINOR_VERSION, &has[1]);
  return has[0] > major || (has[0] == major && has[1] >= minor);
}

const char* errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return "an unknown GL error";
  }
}

bool isSoftware(const std::string& renderer) {
  return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos ||
         renderer.find("SwiftShader") != std::string::npos;
}

constexpr const char* EGL_CURE = "install the packages libegl1 and libgl1-mesa-dri";
constexpr const char* DEVICE_CURE =
    "for a GPU, install its driver and give this process access to /dev/dri or /dev/nvidia* "
    "(in an NVIDIA container set NVIDIA_DRIVER_CAPABILITIES=graphics)";
constexpr const char* OSMESA_CURE = "install the package libosmesa6";

Attempt attemptOf(const Context& context, std::string device) {
  Attempt attempt{context.backend(), std::move(device)};
  attempt.works = true;
  attempt.vendor = context.vendor();
  attempt.renderer = context.renderer();
  attempt.version = context.version();
  attempt.software = isSoftware(context.renderer());
  return attempt;
}

/// Makes a context on one backend, or records why not.
std::unique_ptr<Context> attemptBackend(Backend backend, bool allowSoftwareDevice, std::vector<Attempt>& attempts) {
  Attempt attempt{backend};
  try {
    std::unique_ptr<Context> context;
    switch (backend) {
      case Backend::kEglDevice:
        attempt.cure = DEVICE_CURE;
        context = createEglDevice(allowSoftwareDevice, attempt.device);
        break;
      case Backend::kEglSurfaceless:
        attempt.cure = EGL_CURE;
        context = createEglSurfaceless();
        break;
      default:
        attempt.cure = OSMESA_CURE;
        context = createOsmesa();
    }
    attempts.push_back(attemptOf(*context, attempt.device));
    return context;
  } catch (const Error& error) {
    attempt.failure = error.what();
    attempts.push_back(attempt);
    return nullptr;
  }
}

}  // namespace

const char* backendName(Backend backend) {
  switch (backend) {
    case Backend::kEglDevice:
      return "egl-device";
    case Backend::kEglSurfaceless:
      return "egl-surfaceless";
    case Backend::kOsmesa:
      return "osmesa";
    default:
      return "auto";
  }
}

std::unique_ptr<Context> Context::create(Backend backend) {
  std::vector<Backend> order{Backend::kEglDevice, Backend::kEglSurfaceless, Backend::kOsmesa};
  if (backend != Backend::kAuto) order = {backend};
  std::vector<Attempt> attempts;
  for (const Backend candidate : order) {
    // A software EGL device is the same rasteriser as surfaceless EGL: it is taken only when asked for by name.
    if (auto context = attemptBackend(candidate, backend == Backend::kEglDevice, attempts)) {
      context->attempts_ = std::move(attempts);
      return context;
    }
  }
  std::string message = "no OpenGL ES 3.0 context on this machine;";
  for (const Attempt& attempt : attempts) {
    message += std::string(" ") + backendName(attempt.backend) + ": " + attempt.failure.substr(0, 60) + ";";
  }
  throw Error("X_GL", message + " run `telar doctor` for the cure");
}

std::vector<Attempt> probe() {
  std::vector<Attempt> attempts;
  for (const Backend backend : {Backend::kEglDevice, Backend::kEglSurfaceless, Backend::kOsmesa}) {
    attemptBackend(backend, true, attempts);
  }
  return attempts;
}

void Context::initialise(Backend backend, ProcLoader loader, bool debug, bool robust) {
  backend_ = backend;
  functions_ = loadFunctions(loader);
  vendor_ = text(functions_, GL_VENDOR);
  renderer_ = text(functions_, GL_RENDERER);
  version_ = text(functions_, GL_VERSION);
  capabilities_.desktop = version_.find("OpenGL ES") == std::string::npos;
  capabilities_.robust = robust && functions_.GetGraphicsResetStatus;
  capabilities_.colorBufferFloat = capabilities_.desktop || hasExtension(functions_, "GL_EXT_color_buffer_float");
  capabilities_.floatLinear = capabilities_.desktop || hasExtension(functions_, "GL_OES_texture_float_linear");
  capabilities_.sampleMask =
      hasExtension(functions_, capabilities_.desktop ? "GL_ARB_sample_shading" : "GL_OES_sample_variables");
  capabilities_.samplePlaces = functions_.GetMultisamplefv && (capabilities_.desktop || isAtLeast(functions_, 3, 1));
  capabilities_.bufferTextures =
      functions_.TexBuffer &&
      (capabilities_.desktop ? hasExtension(functions_, "GL_ARB_ES3_2_compatibility") : isAtLeast(functions_, 3, 2));
  capabilities_.shadesHidden = renderer_.find("llvmpipe") != std::string::npos;
  functions_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &capabilities_.maxTextureSize);
  functions_.GetIntegerv(GL_MAX_SAMPLES, &capabilities_.maxSamples);
  functions_.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &capabilities_.maxFragmentTextureUnits);
  if (capabilities_.desktop) {
    if (!hasExtension(functions_, "GL_ARB_ES3_compatibility")) {
      throw Error("X_GL", "the GL driver lacks ARB_ES3_compatibility, so it does not run ES 3.00 shaders");
    }
    functions_.Enable(TEXTURE_CUBE_MAP_SEAMLESS);
    functions_.Enable(PROGRAM_POINT_SIZE);
  }
  if (!capabilities_.colorBufferFloat) {
    throw Error("X_GL", "the GL driver lacks EXT_color_buffer_float, which the environment prefilter needs");
  }
  if (debug || WANT_DEBUG) installDebugCallback();
  check("context creation");
}

void Context::installDebugCallback() {
  if (!functions_.DebugMessageCallback) return;
  capabilities_.debug = true;
  functions_.Enable(GL_DEBUG_OUTPUT);
  functions_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  functions_.DebugMessageCallback(
      [](GLenum, GLenum, GLuint, GLenum severity, GLsizei length, const GLchar* message, const void* user) {
        if (severity != GL_DEBUG_SEVERITY_HIGH) return;
        auto& messages = static_cast<const Context*>(user)->debugMessages_;
        if (messages.size() < DEBUG_MESSAGES_MAX) messages.emplace_back(message, static_cast<std::size_t>(length));
      },
      this);
}

std::string Context::takeDebugMessages() const {
  std::string joined;
  for (const std::string& message : debugMessages_) joined += (joined.empty() ? "" : "; ") + message;
  debugMessages_.clear();
  return joined;
}

void Context::beginJob(const CancelToken& cancel, double sliceMs) const {
  pacer_.begin(cancel, sliceMs);
  for (int unit = 0; unit < capabilities_.maxFragmentTextureUnits; ++unit) {
    functions_.BindSampler(static_cast<GLuint>(unit), 0);
  }
  functions_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  functions_.DepthMask(GL_TRUE);
}

void Context::check(const char* where) const {
  if (capabilities_.robust && functions_.GetGraphicsResetStatus() != GL_NO_ERROR) {
    throw Error("X_GL_LOST", std::string("the GL context was lost during ") + where + "; create a new renderer");
  }
  const GLenum error = functions_.GetError();
  const std::string messages = takeDebugMessages();
  if (error == GL_NO_ERROR && messages.empty()) return;
  for (int i = 0; i < 32 && functions_.GetError() != GL_NO_ERROR; ++i) {
  }
  if (error == GL_OUT_OF_MEMORY) {
    throw Error("X_GL_MEMORY", std::string("the GL driver ran out of memory during ") + where +
                                   "; ask for a smaller picture or use smaller textures");
  }
  throw Error("X_GL", std::string(error == GL_NO_ERROR ? "a driver message" : errorName(error)) + " during " + where +
                          " on " + renderer_ + (messages.empty() ? "" : ": " + messages));
}

}  // namespace telar::gl

namespace telar {

std::string probeBackends() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  bool hardware = false;
  std::string chosen, reason;
  const auto attempts = gl::probe();
  for (const gl::Attempt& attempt : attempts) {
    nlohmann::ordered_json row{{"backend", gl::backendName(attempt.backend)}, {"works", attempt.works}};
    if (!attempt.device.empty()) row["device"] = attempt.device;
    if (attempt.works) {
      row["vendor"] = attempt.vendor;
      row["renderer"] = attempt.renderer;
      row["version"] = attempt.version;
      row["software"] = attempt.software;
    } else {
      row["failure"] = attempt.failure;
      row["cure"] = attempt.cure;
    }
    list.push_back(row);
    const bool usable = attempt.works && (attempt.backend != Backend::kEglDevice || !attempt.software);
    if (usable && chosen.empty()) {
      chosen = gl::backendName(attempt.backend);
      hardware = !attempt.software;
    }
  }
  if (chosen.empty()) {
    reason = "no backend gives OpenGL ES 3.0; see each row's cure";
  } else if (hardware) {
    reason = "a hardware device gives OpenGL ES 3.0";
  } else {
    reason = "no hardware EGL device; the first software backend that works is used";
  }
  return nlohmann::ordered_json{
      {"backends", list},
      {"chosen", chosen.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(chosen)},
      {"reason", reason}}
      .dump();
}

}  // namespace telar
