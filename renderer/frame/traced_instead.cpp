#include <algorithm>
#include <cmath>

#include "frame/covered_pixels.h"
#include "frame/sample_passes.h"
#include "frame/variant.h"
#include "telar/reference.h"

namespace telar {
namespace {

// What quality "high" takes of a core of an AMD EPYC, llvmpipe with 256 bits, measured on cloths, the T-shirt and balls
// of 32 to 256 px and 4,000 to 58,000 triangles: js/docs/reference.md. Only how the raster's numbers stand to the
// tracer's counts.

/// Milliseconds of a pass of the raster, whatever it shows, and of each triangle in it.
constexpr double PASS_MS = 0.3, PASS_TRIANGLE_MS = 40e-6;
/// Samples until the standard error of a covered pixel is SURE, and how many more with each triangle: small ones turn many
/// ways in a pixel. They go by its inverse square.
constexpr double SAMPLES = 200, TRIANGLE_SAMPLES = 0.008, SURE = 1.25;
/// Standard error of a picture that is not denoised and as near to the truth as one that is denoised until it has 1: what
/// denoising leaves is partly no noise.
constexpr double NOT_DENOISED = 0.5;
/// Milliseconds of a sample of a covered pixel: shaded in dense rows, or traced.
constexpr double DENSE_MS = 1.3e-3, PATH_MS = 2.6e-3;
/// The same shaded triangle by triangle, which those are that let some light through: of large triangles, and most of small
/// ones. Between them it grows with their outlines, where pixels are shaded that they do not cover.
constexpr double LARGE_MS = 0.4e-3, SMALL_MS = 2.6e-3;
/// How much longer a path through what is blended takes, and the noise of the chance by which it is let through.
constexpr double BLENDED = 2.5;
/// Milliseconds of a triangle in the hierarchy that rays go down.
constexpr double HIERARCHY_MS = 0.5e-3;

/// What of a scene decides.
struct Counts {
  double triangles = 0, covered = 0;  ///< covered: pixels
  bool single = false;                ///< pass::VisibilityBuffer leaves it to the GL, triangle by triangle
  bool blended = false;               ///< some of it lets light through in part

  /// Of a sample of a covered pixel.
  double singleMs() const {
    const double outlines = std::sqrt(triangles / std::max(covered, 1.0));
    return std::min(LARGE_MS + (SMALL_MS - LARGE_MS) * outlines, SMALL_MS);
  }
  double samplesUntil(double noise, int most) const {
    const double sure = (SAMPLES + TRIANGLE_SAMPLES * triangles) * (SURE / noise) * (SURE / noise);
    return std::min(sure, static_cast<double>(most));
  }
};

double tracedNoise(const Shot& shot) { return shot.noise * (shot.denoise ? NOT_DENOISED : 1); }

double rasterMs(const Counts& counts, const Shot& shot) {
  const double passMs = PASS_MS + PASS_TRIANGLE_MS * counts.triangles;
  const double sampleMs = counts.single ? counts.singleMs() : DENSE_MS;
  const double first = shot.denoise ? std::min<double>(frame::samplePassesOf(shot).fewest(), shot.samples) : 0;
  // Denoised pixels are sure when they are looked at first, but those of nets.
  if (shot.denoise && !counts.single) return first * (passMs + counts.covered * sampleMs);
  const double samples = std::max(counts.samplesUntil(tracedNoise(shot), shot.samples), first);
  return shot.samples * passMs + counts.covered * samples * sampleMs;
}

double tracerMs(const Counts& counts, const Shot& shot) {
  const double samples = counts.samplesUntil(tracedNoise(shot), shot.samples);
  return HIERARCHY_MS * counts.triangles + counts.covered * samples * PATH_MS * (counts.blended ? BLENDED : 1);
}

/// A shot of quality "high" that the tracer could draw.
bool isShaded(const Shot& shot) { return shot.isHigh && shot.layers.empty() && shot.debugOutput == DebugOutput::kNone; }

/// Whether the tracer's light is the raster's own. The shading "fabric" has the tracer for its truth. The others show
/// what a browser does: shadows with soft borders, areas that shine by tables; "three" a map in halves, and what
/// older releases did.
bool isLitTheSame(const Shot& shot) {
  using Type = Shot::Light::Type;
  using Source = Shot::Environment::Source;
  if (shot.shading == ShadingModel::kFabric) return true;
  const bool clipped = shot.environment.source != Source::kStudio && shot.environment.source != Source::kNone;
  if (shot.shading == ShadingModel::kThree && (clipped || shot.three != ThreeTerms())) return false;
  return std::none_of(shot.lights.begin(), shot.lights.end(), [](const Shot::Light& light) {
    return light.castShadow || light.type == Type::kRect || light.type == Type::kDisk;
  });
}

/// Whether a browser draws surfaces that let light through one after the other, in its own order.
bool isBlendedInOrder(const Scene& scene, const Shot& shot) {
  if (shot.shading == ShadingModel::kFabric) return false;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (frame::materialAt(scene, static_cast<int>(i), shot.shading).alphaMode == AlphaMode::kBlend) return true;
  }
  return false;
}

/// Whether parts are shown through, whose shadow the raster leaves out and the tracer draws in part.
bool hasGhosts(const Shot& shot) {
  return std::any_of(shot.ghost.begin(), shot.ghost.end(),
                     [](const Shot::Ghost& ghost) { return ghost.opacity > 0 && ghost.opacity < 1; });
}

Counts countsOf(const Scene& scene, const Shot& shot) {
  Counts counts{static_cast<double>(scene.triangleCount), frame::coveredPixels(scene, shot)};
  counts.single =
      std::any_of(scene.nodes.begin(), scene.nodes.end(), [](const Node& node) { return node.instances != nullptr; });
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const AlphaMode mode = frame::materialAt(scene, static_cast<int>(i), shot.shading).alphaMode;
    counts.single |= mode != AlphaMode::kOpaque;
    counts.blended |= mode == AlphaMode::kBlend;
  }
  return counts;
}

}  // namespace

bool isTraceable(const Scene& scene, const Shot& shot) {
  if (hasGhosts(shot)) return false;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (frame::materialAt(scene, static_cast<int>(i), shot.shading).layers.transmissionFactor > 0) return false;
  }
  if (std::any_of(scene.images.begin(), scene.images.end(),
                  [](const Image8& image) { return image.type == TexelType::kBlocks; }))
    return false;
  return std::all_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) {
    return std::all_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [](const Primitive& primitive) { return primitive.topology == Topology::kTriangles; });
  });
}

std::optional<Shot> tracedInstead(const Scene& scene, const Shot& shot) {
  if (!isShaded(shot) || !isLitTheSame(shot) || !isTraceable(scene, shot)) return std::nullopt;
  if (isBlendedInOrder(scene, shot)) return std::nullopt;
  const Counts counts = countsOf(scene, shot);
  if (tracerMs(counts, shot) > rasterMs(counts, shot)) return std::nullopt;
  Shot traced = shot;
  traced.reference =
      Shot::Reference{.samples = shot.samples, .transport = Shot::Reference::Transport::kDirect, .bounces = 0};
  traced.samples = 1;
  traced.noise = tracedNoise(shot);
  traced.lens.reset();  // the raster shows everything sharp
  return traced;
}

}  // namespace telar
