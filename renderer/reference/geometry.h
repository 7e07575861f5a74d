#pragma once
#include <embree3/rtcore.h>

#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "frame/ghosts.h"
#include "telar/cancel.h"
#include "telar/scene.h"
#include "telar/shading.h"

namespace telar::reference {

/// One drawn primitive in the world of the tracer: metres about the scene's centre, so that a model far from the origin
/// loses no digits.
struct PlacedMesh {
  const Primitive* primitive = nullptr;
  const Material* material = nullptr;
  std::shared_ptr<const Material> read;  ///< holds `material` where a release of three.js reads the file's otherwise
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  glm::mat3 normalMatrix{1.0f};  ///< inverse transpose of the node's matrix
  glm::mat3 linear{1.0f};        ///< the node's matrix without its translation, for tangents
  bool mirrored = false;         ///< the node's matrix reverses the winding
  ShadingModel shading = ShadingModel::kThree;
  glm::vec3 tint{1.0f};  ///< of an instance, linear Rec.709: a factor on the base colour
  const Node* node = nullptr;
  int materialIndex = -1;  ///< in the scene, in the variant; -1 = glTF's default one
};

/// Every triangle that a variant of the scene shows. Points and lines have no area and are left out.
/// @param centre  world position that becomes the origin
/// @param three  a release reads other extensions, transforms and coordinates of textures
/// @throws Error{X_CANCELLED}
std::vector<PlacedMesh> placeMeshes(const Scene& scene, int variant, const glm::dvec3& centre,
                                    const CancelToken& cancel = {}, ShadingModel shading = ShadingModel::kThree,
                                    const ThreeTerms& three = {}, frame::Ghosts ghosts = {});

struct Ray {
  glm::vec3 origin;
  glm::vec3 direction;  ///< unit
  float from = 0;
  int passes = 0;  ///< front sides that it passes: those of shells that its surface lies behind (Surface::shells)
};

struct Hit {
  std::uint32_t mesh = 0, triangle = 0;
  glm::vec2 barycentric{0};  ///< of the second and third corner
  float distance = 0;
  glm::vec3 normal{0};  ///< across the triangle, towards those who see its corners counter-clockwise; of any length
};

/// Within this part of the scene's radius two surfaces are shells of one cloth: 5 to 10 mm of a garment.
constexpr float SHELL = 0.02f;

/// Rays that start at one point.
struct Rays {
  glm::vec3 origin;
  std::span<const glm::vec3> directions;               ///< unit
  float far = std::numeric_limits<float>::infinity();  ///< metres that they go
  float shells = 0;  ///< metres on which they pass one-sided surfaces: the point is seen through them from behind
};

/// Whether a ray ends at a triangle that it meets. @param shells  of its Rays
using Blocks = std::function<bool(const Hit& hit, const glm::vec3& direction, float shells)>;

/// The triangles in Embree's hierarchy. Many threads may query it at once.
class Geometry {
 public:
  /// @param blocks  asked by countHidden() where a material is one-sided or not opaque; left out: all block
  /// @throws Error{X_REFERENCE, X_MEMORY, X_CANCELLED}
  explicit Geometry(const std::vector<PlacedMesh>& meshes, const CancelToken& cancel = {}, Blocks blocks = {});
  /// The nearest hit of a ray. @return false: there is none
  bool intersect(const Ray& ray, Hit& hit) const;
  static constexpr std::size_t MAX_COHERENT = 8;
  /// The same for rays that go side by side, MAX_COHERENT or fewer: together they take less time than one by one.
  /// @param[out] hits  of each ray; none where it meets nothing
  void intersect(std::span<const Ray> rays, std::span<std::optional<Hit>> hits) const;
  /// Whether something ends a ray, as Blocks says. It is cheaper than the first hit. @param far  metres that it goes
  bool occluded(const Ray& ray, float far) const;
  /// How many of the rays something ends.
  int countHidden(const Rays& rays) const;
  /// Whether something ends each of the rays.
  void findHidden(const Rays& rays, std::span<bool> hidden) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  /// Calls found(index of a ray, whether something ends it) for each.
  template <class Found>
  void castShadows(const Rays& rays, const Found& found) const;
  static void keepBlockers(const RTCFilterFunctionNArguments* met);

  std::unique_ptr<const Blocks> blocks_;  ///< Embree has its address
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace telar::reference
