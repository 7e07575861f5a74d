#pragma once
#include <embree3/rtcore.h>

#include <glm/glm.hpp>
#include <memory>
#include <vector>

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
                                    const ThreeTerms& three = {});

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
};

/// The triangles in Embree's hierarchy. Many threads may query it at once.
class Geometry {
 public:
  /// @throws Error{X_REFERENCE, X_MEMORY, X_CANCELLED}
  explicit Geometry(const std::vector<PlacedMesh>& meshes, const CancelToken& cancel = {});
  bool intersect(const Ray& ray, Hit& hit) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace telar::reference
