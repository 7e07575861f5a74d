#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "telar/cancel.h"
#include "telar/image.h"
#include "telar/limits.h"
#include "telar/progress.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar {

enum class Backend { kAuto, kEglDevice, kEglSurfaceless, kOsmesa };

struct RendererOptions {
  Backend backend = Backend::kAuto;
  std::string assetDirectory;    ///< folder of the bundled studio environment (studio.hdr, studio.pmrem)
  std::string cacheDirectory;    ///< prefiltered environments by content hash; empty = none
  std::uint64_t cacheBytes = 0;  ///< of its files; those that were used longest ago go first
  Limits limits;
  bool allFeatures = false;  ///< benchmark only: compile every feature into every program
  /// Wall-clock time between two looks at the cancel token while drawing, about. Tests only: infinity cuts nothing.
  double sliceMs = 50;
  /// Whether triangles that nobody sees are found and left out. Tests only, but for kWhereItPays: no byte differs.
  enum class LeaveOut { kWhereItPays, kAlways, kNever } hiddenTriangles = LeaveOut::kWhereItPays;
  /// Whether what is seen is found first and shaded in dense rows. Tests only, but for kWhereItPays: no byte differs.
  LeaveOut visibilityBuffer = LeaveOut::kWhereItPays;
};

/// What a drawn frame was made of; toJson() is `info` of the API less what JavaScript adds.
struct FrameInfo {
  std::string json;
  std::string environmentSha256;  ///< of the environment's file; empty where none was read, or the bundled one
};

/// Draws scenes with one GL context, which stays current on the thread that called create(): call every method, and
/// the destructor, on that thread.
class Renderer {
 public:
  /// @throws Error{X_GL} that lists every backend tried, why each failed, and the cure.
  static std::unique_ptr<Renderer> create(const RendererOptions& options);
  virtual ~Renderer() = default;

  /// Draws one frame. GPU copies of the scene's data are kept until the scene is released or release() is called.
  /// @param environment file bytes when shot.environment.source is kBytes
  /// @throws Error{X_GL, X_GL_MEMORY, X_CANCELLED, E_VARIANT, ...}; never a partial frame.
  /// @param progress  previews are put there, where they are asked for and the picture takes several passes
  virtual Frame draw(const std::shared_ptr<const Scene>& scene, const Shot& shot,
                     std::span<const std::byte> environment, const CancelToken& cancel, FrameInfo& info,
                     const Progress& progress = {}) = 0;

  /// Frees the GPU copies of one scene.
  virtual void release(const Scene& scene) = 0;

  /// {backend, vendor, renderer, version, ...} as JSON.
  virtual std::string describe() const = 0;
  /// GL names that models, programs and targets of this context have (leak tests).
  virtual int liveObjects() const = 0;
};

/// What draw() would compile and run for this scene and shot, without a context: {features: [...], programs:
/// [{features}], passes: [...]} as JSON. For a shot that tracedInstead() takes, what a host with Embree runs.
std::string planFrame(const Scene& scene, const Shot& shot, const Limits& limits);

/// Tries every backend and says what each gave: JSON for `telar doctor`. Never throws.
std::string probeBackends();

}  // namespace telar
