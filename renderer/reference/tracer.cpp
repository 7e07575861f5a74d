#include "reference/tracer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "frame/layers.h"
#include "frame/linear_output.h"
#include "frame/picture_facts.h"
#include "reference/layers.h"
#include "reference/placed_scene.h"
#include "reference/ray_camera.h"
#include "reference/rows.h"

namespace telar::reference {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

constexpr int SAMPLES_PER_CANCEL_CHECK = 16;

/// All that rays meet, and the camera that they start from.
class World {
 public:
  World(const Scene& scene, const Shot& shot, const ImageF* environment, Transport transport, const Limits& limits,
        const CancelToken& cancel)
      : placed_(scene, shot, cancel),
        lights_(lightsOf(scene, shot, placed_.centre, limits)),
        camera_(shot, placed_.centre) {
    if (environment && shot.environment.intensity > 0) {
      environment_.emplace(*environment, shot.environment.rotation, shot.environment.intensity);
    }
    if (shot.ground) ground_.emplace(shot, placed_.centre);
    const EnvironmentLight* light = environment_ ? &*environment_ : nullptr;
    background_.emplace(shot, light);
    const TracedScene traced{
        placed_.textures, placed_.meshes, placed_.geometry, lights_, light, *background_, ground_ ? &*ground_ : nullptr,
        placed_.radius};
    integrator_.emplace(traced, transport, shot.shading, shot.terms, shot.three);
  }

  /// One estimate of the light of a pixel. @param pixel  its top-left corner
  glm::vec4 Li(const glm::dvec2& pixel, Sampler& sampler) const {
    const glm::dvec2 at = pixel + glm::dvec2(sampler.random.uniform2());
    const glm::dvec2 lens = camera_.hasLens() ? glm::dvec2(sampler.random.uniform2()) : glm::dvec2(0);
    return integrator_->Li({camera_, at, lens}, sampler);
  }
  std::uint64_t triangles() const {
    std::uint64_t sum = 0;
    for (const PlacedMesh& mesh : placed_.meshes) sum += mesh.triangles.size();
    return sum;
  }

 private:
  PlacedScene placed_;
  Lights lights_;
  RayCamera camera_;
  std::optional<EnvironmentLight> environment_;
  std::optional<Background> background_;
  std::optional<Ground> ground_;
  std::optional<Integrator> integrator_;
};

/// Mean of a pixel's samples. @param rays  grows by those that were followed
glm::vec4 pixelOf(const World& world, const glm::dvec2& corner, std::uint32_t index, const TraceOptions& options,
                  const CancelToken& cancel, std::uint64_t& rays) {
  glm::dvec4 sum(0);
  for (int i = 0; i < options.samples; ++i) {
    if (i % SAMPLES_PER_CANCEL_CHECK == 0) cancel.check();
    Sampler sampler{Random(options.seed, index, static_cast<std::uint32_t>(i))};
    sum += glm::dvec4(world.Li(corner, sampler));
    rays += sampler.rays;
  }
  return glm::vec4(sum / static_cast<double>(options.samples));
}

}  // namespace

TraceOptions optionsOf(const Shot& shot) {
  using Kind = Shot::Reference::Transport;
  const Shot::Reference& wanted = *shot.reference;
  TraceOptions options{wanted.samples, static_cast<std::uint64_t>(wanted.seed), wanted.threads};
  if (options.threads == 0) options.threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  options.transport.occlusion = wanted.transport != Kind::kDirect;
  options.transport.bounces = wanted.transport == Kind::kGlobal ? wanted.bounces : 0;
  return options;
}

std::vector<glm::vec4> traceRadiance(const Scene& scene, const Shot& shot, const ImageF* environment,
                                     const TraceOptions& options, const Limits& limits, const CancelToken& cancel,
                                     const Progress& progress, TraceFacts* facts) {
  const Clock::time_point start = Clock::now();
  const World world(scene, shot, environment, options.transport, limits, cancel);
  const Clock::time_point built = Clock::now();
  const auto width = static_cast<std::size_t>(shot.width);
  std::vector<glm::vec4> pixels(width * static_cast<std::size_t>(shot.height));
  const int threads = std::clamp(options.threads, 1, shot.height);
  std::atomic<int> done = 0;
  std::atomic<std::uint64_t> rays = 0;
  forEachRow(shot.height, threads, [&](int y) {
    std::uint64_t ofRow = 0;
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      pixels[pixel] =
          pixelOf(world, {static_cast<double>(x), y}, static_cast<std::uint32_t>(pixel), options, cancel, ofRow);
    }
    rays += ofRow;
    progress.reach(static_cast<float>(++done) / static_cast<float>(shot.height));
  });
  if (facts) {
    *facts = {threads, world.triangles(), rays, milliseconds(built - start), milliseconds(Clock::now() - built), {}};
  }
  return pixels;
}

Frame trace(const Scene& scene, const Shot& shot, const ImageF* environment, const TraceOptions& options,
            const Limits& limits, const CancelToken& cancel, const Progress& progress, TraceFacts* facts) {
  const auto pixels = traceRadiance(scene, shot, environment, options, limits, cancel, progress, facts);
  Frame frame = frame::toFrame(pixels, shot);
  if (facts && shot.background.type != Shot::Background::Type::kEnvironment) {
    facts->picture = frame::pictureFacts(frame, frame::coverageOf(pixels, shot.ground ? shot.ground->opacity : 0));
  }
  if (shot.layers.empty()) return frame;
  frame.layers = traceLayers(scene, shot, options, limits, cancel);
  if (shot.hasLayer(Layer::kCoverage)) {
    LayerImage& coverage = frame.layers.emplace_back(LayerImage{Layer::kCoverage, std::vector<float>(pixels.size())});
    const auto covering = frame::alphaIsCoverage(shot)
                              ? pixels
                              : traceRadiance(scene, frame::coverageShot(shot), nullptr, options, limits, cancel, {});
    for (std::size_t i = 0; i < covering.size(); ++i) coverage.pixels[i] = covering[i].a;
  }
  return frame;
}

}  // namespace telar::reference
