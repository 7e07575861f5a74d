#include "reference/layers.h"

#include <cmath>
#include <optional>

#include "frame/camera.h"
#include "frame/layers.h"
#include "frame/variant.h"
#include "reference/ground.h"
#include "reference/lights.h"
#include "reference/ray_camera.h"
#include "reference/rows.h"
#include "telar/luminance.h"

namespace telar::reference {
namespace {

constexpr int MAX_SURFACES = 256;   ///< that one ray passes
constexpr float STEP = 1e-5f;       ///< of the scene's radius: a ray starts so far from its surface
constexpr int GROUND_SAMPLES = 64;  ///< of the blur of a shadow on the ground
constexpr float FAR = std::numeric_limits<float>::infinity();

Shot sharp(Shot shot) {
  shot.lens.reset();
  return shot;
}

/// What a pixel shows.
struct Seen {
  Surface surface;
  const PlacedMesh* mesh = nullptr;
};

/// Random numbers of a pixel's rays: those of many fill the domain evenly.
struct Pixel {
  std::uint64_t seed;
  std::uint32_t index;
  int rays;  ///< of ambient occlusion
  Random random(int ray) const { return {seed, index, static_cast<std::uint32_t>(ray)}; }
};

/// The surfaces of a scene with plain materials, and what looks at them.
class LayerWorld {
 public:
  LayerWorld(const Scene& scene, const Shot& shot, const Limits& limits, const CancelToken& cancel)
      : shot_(shot),
        centre_(scene.bounds.empty() ? glm::dvec3(0) : (scene.bounds.min + scene.bounds.max) * 0.5),
        radius_(scene.bounds.empty() ? 1.0f : static_cast<float>(glm::distance(scene.bounds.max, centre_))),
        meshes_(
            placeMeshes(scene, frame::variantIndex(scene, shot.variant), centre_, cancel, shot.shading, shot.three)),
        geometry_(meshes_, cancel),
        textures_(scene),
        lights_(lightsOf(scene, shot, centre_, limits)),
        camera_(sharp(shot), centre_),
        view_(frame::cameraOf(shot).view),
        ids_(scene) {
    for (PlacedMesh& mesh : meshes_) {
      mesh.read = frame::plainMaterial(*mesh.material);
      mesh.material = mesh.read.get();
    }
    std::erase_if(lights_.punctual, [](const PunctualLight& light) { return light.shadow == 0; });
    if (shot.ground && shot.hasLayer(Layer::kShadow)) ground_.emplace(shot, centre_);
  }

  /// @param[out] to  the channels of a layer
  void write(Layer layer, const Seen& seen, const Pixel& pixel, float* to) const {
    const Surface& surface = seen.surface;
    switch (layer) {
      case Layer::kDepth:
        *to = static_cast<float>(-(view_ * glm::dvec4(glm::dvec3(surface.position) + centre_, 1.0)).z);
        break;
      case Layer::kNormal:
        for (int c = 0; c < 3; ++c) to[c] = surface.info.n[c];
        break;
      case Layer::kPartId:
        *to = ids_.part(*seen.mesh->node);
        break;
      case Layer::kMaterialId:
        *to = ids_.material(seen.mesh->materialIndex);
        break;
      case Layer::kAo:
        *to = openPart(surface, pixel);
        break;
      case Layer::kAlbedo:
        for (int c = 0; c < 3; ++c) to[c] = surface.info.baseColor[c];
        break;
      case Layer::kShadow:
        *to = hiddenPart(surface);
        break;
      case Layer::kCoverage:
      case Layer::kLine:
        break;
    }
  }

  /// The ray through the centre of a pixel.
  Ray ray(const glm::dvec2& pixel) const { return camera_.generateRay(pixel + 0.5, {}); }

  std::optional<Seen> seen(const glm::dvec2& pixel) const {
    const Ray through = ray(pixel);
    const Footprint footprint{ray(pixel + glm::dvec2(1, 0)), ray(pixel - glm::dvec2(0, 1)), camera_.toView()};
    Seen seen;
    if (!nearest(through, &footprint, seen)) return std::nullopt;
    return seen;
  }

  /// Of the ground, where no surface lies before it.
  float groundShadow(const Ray& through, const Pixel& pixel) const {
    const auto distance = ground_ ? ground_->distance(through) : std::nullopt;
    const auto opacity = static_cast<float>(ground_ ? shot_.ground->opacity : 0);
    if (!distance || opacity == 0) return 0;
    float sum = 0;
    for (int i = 0; i < GROUND_SAMPLES; ++i) {
      Random random = pixel.random(i);
      sum += ground_->opacity(through, *distance, random,
                              [&](const Ray& towards, float far) { return hits(towards, far); });
    }
    return sum / (opacity * GROUND_SAMPLES);
  }

 private:
  bool nearest(Ray through, const Footprint* footprint, Seen& seen) const {
    Hit hit;
    for (int i = 0; i < MAX_SURFACES; ++i) {
      if (!geometry_.intersect(through, hit)) return false;
      seen.mesh = &meshes_[hit.mesh];
      seen.surface = surfaceAt(textures_, *seen.mesh, hit, through, footprint, shot_.three);
      if (seen.surface.shown && seen.surface.alpha >= frame::LAYER_ALPHA) return true;
      through.from = hit.distance + radius_ * STEP;
    }
    return false;
  }

  bool hits(const Ray& towards, float far) const {
    Seen blocker;
    return nearest(towards, nullptr, blocker) && blocker.surface.distance < far;
  }

  Ray leaving(const Surface& surface, const glm::vec3& direction) const {
    return {surface.position + surface.geometricNormal * (radius_ * STEP), direction};
  }

  float openPart(const Surface& surface, const Pixel& pixel) const {
    const glm::mat3 frame = brdf_f::basisAbout(surface.geometricNormal);
    int open = 0;
    for (int i = 0; i < pixel.rays; ++i) {
      // By the cosine: even over the disk beneath the hemisphere (Malley's method).
      const glm::vec2 u = pixel.random(i).uniform2();
      const float r = std::sqrt(u.x), phi = 6.2831853f * u.y;
      const glm::vec3 local(r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1 - u.x, 0.0f)));
      open += !hits(leaving(surface, frame * local), FAR);
    }
    return static_cast<float>(open) / static_cast<float>(pixel.rays);
  }

  float hiddenPart(const Surface& surface) const {
    float sent = 0, arrives = 0;
    for (const PunctualLight& light : lights_.punctual) {
      const auto sample = light.sampleLi(surface.position);
      if (!sample) continue;
      const float light1 = luminance(sample->irradiance);
      sent += light1;
      if (glm::dot(surface.geometricNormal, sample->direction) <= 0) continue;
      arrives += light1 * (hits(leaving(surface, sample->direction), sample->distance) ? 1 - light.shadow : 1.0f);
    }
    return sent > 0 ? 1 - arrives / sent : 0;
  }

  const Shot& shot_;
  glm::dvec3 centre_;
  float radius_;
  std::vector<PlacedMesh> meshes_;
  Geometry geometry_;
  Textures textures_;
  Lights lights_;
  RayCamera camera_;
  glm::dmat4 view_;
  frame::LayerIds ids_;
  std::optional<Ground> ground_;
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
  forEachRow(shot.height, std::clamp(options.threads, 1, shot.height), [&](int y) {
    for (std::size_t x = 0; x < width; ++x) {
      if (x % 16 == 0) cancel.check();
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      const glm::dvec2 corner(static_cast<double>(x), y);
      const auto seen = world.seen(corner);
      for (LayerImage& image : images) {
        const Pixel numbers{options.seed, static_cast<std::uint32_t>(pixel), options.samples};
        float* to = &image.pixels[pixel * channelCount(image.layer)];
        if (seen)
          world.write(image.layer, *seen, numbers, to);
        else if (image.layer == Layer::kShadow)
          *to = world.groundShadow(world.ray(corner), numbers);
      }
    }
  });
  return images;
}

}  // namespace telar::reference
