#include "reference/layers.h"

#include <optional>

#include "core/on_threads.h"
#include "frame/camera.h"
#include "frame/layers.h"
#include "reference/ambient.h"
#include "reference/ground.h"
#include "reference/lights.h"
#include "reference/placed_scene.h"
#include "reference/ray_camera.h"
#include "telar/luminance.h"

namespace telar::reference {
namespace {

constexpr int MAX_SURFACES = 256;   ///< that one ray passes
constexpr int GROUND_SAMPLES = 64;  ///< of the blur of a shadow on the ground

Shot sharp(Shot shot) {
  shot.lens.reset();
  return shot;
}

/// A surface that a ray shows.
struct Seen {
  Surface surface;
  Rays from;  ///< of rays that leave it
  const PlacedMesh* mesh = nullptr;
};

/// Random numbers of a pixel's rays: those of many fill the domain evenly.
struct Pixel {
  std::uint64_t seed;
  std::uint32_t index;
  int rays;  ///< of ambient occlusion
};

/// The surfaces of a scene with plain materials, and what looks at them.
class LayerWorld {
 public:
  LayerWorld(const Scene& scene, const Shot& shot, const Limits& limits, const CancelToken& cancel)
      : shot_(shot),
        placed_(scene, shot, cancel),
        lights_(lightsOf(scene, shot, placed_.centre, limits)),
        camera_(sharp(shot), placed_.centre),
        view_(frame::cameraOf(shot).view),
        ids_(scene) {
    for (PlacedMesh& mesh : placed_.meshes) {
      mesh.read = frame::plainMaterial(*mesh.material);
      mesh.material = mesh.read.get();
    }
    std::erase_if(lights_.punctual, [](const PunctualLight& light) { return light.shadow == 0; });
    if (shot.ground && shot.hasLayer(Layer::kShadow)) ground_.emplace(shot, placed_.centre);
  }

  /// The ray through the centre of a pixel.
  Ray ray(const glm::dvec2& pixel) const { return camera_.generateRay(pixel + 0.5, {}); }

  std::optional<Seen> seen(const glm::dvec2& pixel) const {
    Ray through = ray(pixel);
    const Footprint footprint = camera_.footprint(pixel + 0.5, {});
    Hit hit;
    for (int i = 0; i < MAX_SURFACES; ++i) {
      if (!placed_.geometry.intersect(through, hit)) return std::nullopt;
      const PlacedMesh& mesh = placed_.meshes[hit.mesh];
      if (endsAt(placed_.textures, mesh, hit, through.direction, frame::LAYER_ALPHA))
        return seenAt(surfaceAt(placed_.textures, mesh, hit, through, &footprint, shot_.three), mesh, through);
      through.from = hit.distance + placed_.radius * STEP;
    }
    return std::nullopt;
  }

  float depth(const Seen& seen) const {
    const glm::dvec3 world = glm::dvec3(seen.surface.position) + placed_.centre;
    return static_cast<float>(-(view_ * glm::dvec4(world, 1.0)).z);
  }
  float partId(const Seen& seen) const { return ids_.part(*seen.mesh->node); }
  float materialId(const Seen& seen) const { return ids_.material(seen.mesh->materialIndex); }
  float open(const Seen& seen, const Pixel& pixel) const {
    return openPart(placed_.geometry, seen.from, seen.surface.geometricNormal, Random(pixel.seed, pixel.index, 0),
                    pixel.rays);
  }

  /// Part of the light of lights that cast shadows that something hides from a surface.
  float shadow(const Seen& seen) const {
    const Surface& surface = seen.surface;
    float sent = 0, arrives = 0;
    for (const PunctualLight& light : lights_.punctual) {
      const auto sample = light.sampleLi(surface.position);
      if (!sample) continue;
      const float light1 = luminance(sample->irradiance);
      sent += light1;
      if (glm::dot(surface.geometricNormal, sample->direction) <= 0) continue;
      arrives += light1 * (hides(seen.from, sample->direction, sample->distance) ? 1 - light.shadow : 1.0f);
    }
    return sent > 0 ? 1 - arrives / sent : 0;
  }

  /// Of the ground, where no surface lies before it.
  float groundShadow(const Ray& through, const Pixel& pixel) const {
    const auto distance = ground_ ? ground_->distance(through) : std::nullopt;
    const auto opacity = static_cast<float>(ground_ ? shot_.ground->opacity : 0);
    if (!distance || opacity == 0) return 0;
    float sum = 0;
    for (int i = 0; i < GROUND_SAMPLES; ++i) {
      Random random(pixel.seed, pixel.index, static_cast<std::uint32_t>(i));
      sum += ground_->opacity(through, *distance, random, [&](const Ray& towards, float far) {
        return hides({towards.origin}, towards.direction, far);
      });
    }
    return sum / (opacity * GROUND_SAMPLES);
  }

 private:
  Seen seenAt(const Surface& surface, const PlacedMesh& mesh, const Ray& through) const {
    return {surface, placed_.raysFrom(surface.position, surface.geometricNormal, -through.direction), &mesh};
  }
  bool hides(Rays from, const glm::vec3& direction, float far) const {
    from.directions = {&direction, 1}, from.far = far;
    return placed_.geometry.countHidden(from) > 0;
  }

  const Shot& shot_;
  PlacedScene placed_;
  Lights lights_;
  RayCamera camera_;
  glm::dmat4 view_;
  frame::LayerIds ids_;
  std::optional<Ground> ground_;
};

/// What one pixel shows.
struct SeenPixel {
  const LayerWorld& world;
  const Seen& seen;
  const Pixel& pixel;

  float depth() const { return world.depth(seen); }
  glm::vec3 normal() const { return seen.surface.info.n; }
  float partId() const { return world.partId(seen); }
  float materialId() const { return world.materialId(seen); }
  float open() const { return world.open(seen, pixel); }
  glm::vec3 albedo() const { return seen.surface.info.baseColor; }
  float shadow() const { return world.shadow(seen); }
};

}  // namespace

std::vector<LayerImage> traceLayers(const Scene& scene, const Shot& shot, const TraceOptions& options,
                                    const Limits& limits, const CancelToken& cancel) {
  const LayerWorld world(scene, shot, limits, cancel);
  const auto width = static_cast<std::size_t>(shot.width), count = width * static_cast<std::size_t>(shot.height);
  std::vector<LayerImage> images;
  for (const Layer layer : shot.layers) {
    if (layer == Layer::kCoverage || layer == Layer::kLine) continue;
    images.push_back({layer, std::vector<float>(count * channelCount(layer))});
  }
  if (images.empty()) return images;
  onThreads(shot.height, static_cast<std::size_t>(std::max(options.threads, 1)), [&](int y) {
    for (std::size_t x = 0; x < width; ++x) {
      if (x % 16 == 0) cancel.check();
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      const glm::dvec2 corner(static_cast<double>(x), y);
      const auto seen = world.seen(corner);
      for (LayerImage& image : images) {
        const Pixel numbers{options.seed, static_cast<std::uint32_t>(pixel), options.samples};
        float* to = &image.pixels[pixel * channelCount(image.layer)];
        if (seen)
          frame::writeLayer(image.layer, SeenPixel{world, *seen, numbers}, to);
        else if (image.layer == Layer::kShadow)
          *to = world.groundShadow(world.ray(corner), numbers);
      }
    }
  });
  return images;
}

}  // namespace telar::reference
