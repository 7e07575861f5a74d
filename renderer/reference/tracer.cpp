#include "reference/tracer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include "core/on_threads.h"
#include "frame/layers.h"
#include "frame/linear_output.h"
#include "frame/picture_facts.h"
#include "frame/pixel_mean.h"
#include "reference/layers.h"
#include "reference/placed_scene.h"
#include "reference/ray_camera.h"

namespace telar::reference {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }

constexpr int MAX_PATHS = static_cast<int>(Integrator::MAX_PATHS);

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

  /// One estimate of the light of a pixel by each sampler, Integrator::MAX_PATHS or fewer. @param pixel  its top-left
  /// corner
  void Li(const glm::dvec2& pixel, std::span<Sampler> samplers, glm::vec4* light) const {
    std::vector<PixelPoint> points;
    points.reserve(samplers.size());
    for (Sampler& sampler : samplers) {
      const glm::dvec2 at = pixel + glm::dvec2(sampler.random.uniform2());
      const glm::dvec2 lens = camera_.hasLens() ? glm::dvec2(sampler.random.uniform2()) : glm::dvec2(0);
      points.push_back({camera_, at, lens});
    }
    integrator_->Li(points, samplers, light);
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

/// Some of the samples of each pixel.
struct Samples {
  int first, end;
};

/// Follows paths through a picture, on several threads.
class Follower {
 public:
  Follower(const World& world, const Shot& shot, const TraceOptions& options, const CancelToken& cancel,
           const Progress& progress)
      : world_(world),
        width_(shot.width),
        height_(shot.height),
        options_(options),
        cancel_(cancel),
        progress_(progress) {}

  /// Adds the light of these samples to each pixel but those that are settled.
  /// A picture that is enough as it is leaves later samples out: isCut() tells, and the sums are of no use.
  /// @param settled  255 or 0; empty = none    @param rowDone  called on any thread    @param sums  empty = 0
  std::vector<glm::dvec4> follow(const Samples& samples, std::span<const std::uint8_t> settled,
                                 const std::function<void()>& rowDone, std::vector<glm::dvec4> sums = {}) {
    const auto width = static_cast<std::size_t>(width_);
    sums.resize(width * static_cast<std::size_t>(height_));
    onThreads(height_, static_cast<std::size_t>(threads()), [&](int y) {
      if (samples.first > 0 && progress_.isEnough()) {
        cut_ = true;
        return;
      }
      std::uint64_t rays = 0;
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
        if (settled.empty() || !settled[pixel])
          addTo(sums[pixel], {static_cast<double>(x), y}, static_cast<std::uint32_t>(pixel), samples, rays);
      }
      rays_ += rays;
      rowDone();
    });
    return sums;
  }
  int threads() const { return std::clamp(options_.threads, 1, height_); }
  std::uint64_t rays() const { return rays_; }
  bool isCut() const { return cut_; }

 private:
  void addTo(glm::dvec4& sum, const glm::dvec2& corner, std::uint32_t index, const Samples& samples,
             std::uint64_t& rays) const {
    std::vector<Sampler> samplers;
    samplers.reserve(MAX_PATHS);
    for (int first = samples.first; first < samples.end; first += MAX_PATHS) {
      cancel_.check();
      samplers.clear();
      for (int i = first; i < std::min(first + MAX_PATHS, samples.end); ++i)
        samplers.push_back({Random(options_.seed, index, static_cast<std::uint32_t>(i))});
      std::array<glm::vec4, Integrator::MAX_PATHS> light;
      world_.Li(corner, samplers, light.data());
      for (std::size_t i = 0; i < samplers.size(); ++i) {
        sum += glm::dvec4(light[i]);
        rays += samplers[i].rays;
      }
    }
  }

  const World& world_;
  int width_, height_;
  const TraceOptions& options_;
  const CancelToken& cancel_;
  const Progress& progress_;
  std::atomic<std::uint64_t> rays_ = 0;
  std::atomic<bool> cut_ = false;
};

/// Rounds that double the samples of a pixel are followed in so many steps where time may end them: a step that is cut
/// short is lost.
constexpr int STEPS = 4;

/// Samples from `taken` on that are followed at once, of a round that ends at `end`.
Samples stepOf(int taken, int end, const Progress& progress) {
  return {taken, progress.isCpuAllowed() ? std::min(taken + std::max(taken / STEPS, 1), end) : end};
}

/// Every pixel takes all samples: at once, or in rounds that double them where there are previews or the picture may
/// end before. The sums are the same.
/// @param[out] facts  samples of each pixel: fewer where the picture was enough before
std::vector<glm::vec4> followAll(Follower& follower, const Shot& shot, int samples, const Progress& progress,
                                 TraceFacts& facts) {
  int& taken = facts.samples;
  std::vector<glm::dvec4> sums;
  std::vector<glm::vec4> before;
  const auto mean = [&sums, &taken] {
    std::vector<glm::vec4> pixels(sums.size());
    std::transform(sums.begin(), sums.end(), pixels.begin(),
                   [&taken](const glm::dvec4& sum) { return glm::vec4(sum / static_cast<double>(taken)); });
    return pixels;
  };
  const auto inRounds = [&progress] { return progress.previews.asked() || progress.mayEnd(); };
  for (taken = 0; taken < samples;) {
    const Samples round = stepOf(taken, inRounds() ? std::min(std::max(2 * taken, 1), samples) : samples, progress);
    std::atomic<int> rows = 0;
    const auto rowDone = [&] {
      const float part = static_cast<float>(++rows) / static_cast<float>(shot.height);
      const float done = static_cast<float>(round.first) + part * static_cast<float>(round.end - round.first);
      progress.reach(done / static_cast<float>(samples));
    };
    sums = follower.follow(round, {}, rowDone, std::move(sums));
    facts.end.early = follower.isCut();
    if (facts.end.early) return before;
    taken = round.end;
    if (!inRounds() || taken == samples) continue;
    before = mean();
    if (progress.previews.asked() && std::has_single_bit(static_cast<unsigned>(taken)))
      progress.previews.put({frame::toFrame(before, shot), taken});
  }
  return mean();
}

/// Light of samples of the pixels that are not settled: of as many as were taken before the picture was enough.
/// @param[in,out] taken  samples of each pixel
std::vector<glm::dvec4> followRound(Follower& follower, const Samples& round, std::span<const std::uint8_t> settled,
                                    const Progress& progress, int& taken) {
  std::vector<glm::dvec4> sums, before;
  while (taken < round.end) {
    if (progress.isCpuAllowed()) before = sums;
    const Samples step = stepOf(taken, round.end, progress);
    sums = follower.follow(
        step, settled, [] {}, std::move(sums));
    if (follower.isCut()) return before;
    taken = step.end;
  }
  return sums;
}

/// PixelMean compares two halves: the first look is after the second round.
constexpr int FIRST_SAMPLES = frame::PixelMean::FEWEST / 2;

/// A pixel takes samples until its standard error is Shot::noise, as in the raster's passes, and `most` at most.
/// @param[out] facts  samples of the pixel that took most, and how it ended
std::vector<glm::vec4> followUntilSettled(Follower& follower, const Shot& shot, int most, const Progress& progress,
                                          TraceFacts& facts) {
  int& taken = facts.samples;
  frame::PixelMean mean(shot, false);
  const auto width = static_cast<std::uint32_t>(shot.width), height = static_cast<std::uint32_t>(shot.height);
  Frame sums{width, height, PixelType::kRgbaF32,
             std::vector<std::byte>(std::size_t{width} * height * sizeof(glm::vec4))};
  const auto isEnough = [&] { return taken > 0 && progress.isEnough(mean.standardError()); };
  for (taken = 0; taken < most && !mean.allSettled() && !isEnough();) {
    const int before = taken;
    const auto followed = followRound(follower, {taken, std::min(std::max(2 * taken, FIRST_SAMPLES), most)},
                                      mean.settled(), progress, taken);
    if (taken == before) break;
    std::copy(followed.begin(), followed.end(), reinterpret_cast<glm::vec4*>(sums.pixels.data()));
    mean.add(sums, follower.isCut() || taken == most, static_cast<unsigned>(taken - before));
    if (follower.isCut()) break;
    if (progress.previews.asked() && taken < most && !mean.allSettled())
      progress.previews.put({frame::toFrame(mean.mean(), shot), taken});
    progress.reach(static_cast<float>(taken) / static_cast<float>(most));
  }
  progress.reach(1);  // all may be settled before
  facts.end = {taken < most && !mean.allSettled(), mean.standardError()};
  return mean.mean();
}

/// Paths of a pixel that tell what of it the model covers: as many as samples of the raster's first pass.
constexpr int COVERAGE_SAMPLES = 4;

/// What of each pixel the model covers. Behind it an environment makes alpha 1 everywhere: then few paths tell.
std::vector<std::uint8_t> coverageOf(const std::vector<glm::vec4>& pixels, const Scene& scene, const Shot& shot,
                                     TraceOptions options, const Limits& limits, const CancelToken& cancel) {
  if (shot.background.type != Shot::Background::Type::kEnvironment)
    return frame::coverageOf(pixels, shot.ground ? shot.ground->opacity : 0);
  options.samples = std::min(options.samples, COVERAGE_SAMPLES);
  return frame::coverageOf(traceRadiance(scene, frame::coverageShot(shot), nullptr, options, limits, cancel, {}), 0);
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
  progress.begin();
  const World world(scene, shot, environment, options.transport, limits, cancel);
  const Clock::time_point built = Clock::now();
  Follower follower(world, shot, options, cancel, progress);
  TraceFacts told{.threads = follower.threads()};
  auto pixels = shot.noise > 0 ? followUntilSettled(follower, shot, options.samples, progress, told)
                               : followAll(follower, shot, options.samples, progress, told);
  told.triangles = world.triangles();
  told.rays = follower.rays();
  told.hierarchyMs = milliseconds(built - start);
  told.traceMs = milliseconds(Clock::now() - built);
  if (facts) *facts = told;
  return pixels;
}

Frame trace(const Scene& scene, const Shot& shot, const ImageF* environment, const TraceOptions& options,
            const Limits& limits, const CancelToken& cancel, const Progress& progress, TraceFacts* facts) {
  const auto pixels = traceRadiance(scene, shot, environment, options, limits, cancel, progress, facts);
  Frame frame = frame::toFrame(pixels, shot);
  if (facts) facts->picture = frame::pictureFacts(frame, coverageOf(pixels, scene, shot, options, limits, cancel));
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
