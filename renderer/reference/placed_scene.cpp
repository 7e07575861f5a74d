#include "reference/placed_scene.h"

#include "frame/layers.h"
#include "frame/variant.h"
#include "reference/surface.h"

namespace telar::reference {

PlacedScene::PlacedScene(const Scene& scene, const Shot& shot, const CancelToken& cancel)
    : centre(scene.bounds.empty() ? glm::dvec3(0) : scene.bounds.middle()),
      radius(scene.bounds.empty() ? 1.0f : static_cast<float>(glm::distance(scene.bounds.max, centre))),
      meshes(placeMeshes(scene, frame::variantIndex(scene, shot.variant), centre, cancel, shot.shading, shot.three,
                         frame::Ghosts(scene, shot))),
      textures(scene),
      geometry(meshes, cancel, [this](const Hit& hit, const glm::vec3& direction, float shells) {
        const PlacedMesh& mesh = meshes[hit.mesh];
        if (hit.distance <= shells && !mesh.material->doubleSided) return false;
        return endsAt(textures, mesh, hit, direction, frame::LAYER_ALPHA);
      }) {}

Rays PlacedScene::raysFrom(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& toViewer) const {
  Rays rays{position + normal * (radius * STEP), {&toViewer, 1}, radius * SHELL};
  const bool seenThrough = geometry.countHidden(rays) > 0;
  return {rays.origin, {}, std::numeric_limits<float>::infinity(), seenThrough ? radius * SHELL : 0.0f};
}

}  // namespace telar::reference
