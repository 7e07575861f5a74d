#pragma once
#include "reference/geometry.h"
#include "reference/texture_read.h"
#include "telar/shot.h"

namespace telar::reference {

constexpr float STEP = 1e-5f;  ///< of the scene's radius: a ray starts so far from its surface

/// What rays meet: the surfaces of a scene in the tracer's world, metres about its centre. What it hands to Embree
/// stays where it is.
struct PlacedScene {
  /// @param scene, shot  kept by reference
  /// @throws Error{X_CANCELLED, X_REFERENCE, X_MEMORY, E_VARIANT}
  PlacedScene(const Scene& scene, const Shot& shot, const CancelToken& cancel);
  PlacedScene(const Scene&&, const Shot&, const CancelToken&) = delete;
  PlacedScene(const Scene&, const Shot&&, const CancelToken&) = delete;
  PlacedScene(const PlacedScene&) = delete;
  PlacedScene& operator=(const PlacedScene&) = delete;

  /// Rays that leave a surface, so that they do not meet it again. They are not hidden by what it is seen through: one
  /// side of a shell that interpenetrates with it is culled for the viewer and would shut it off from all light.
  /// @param position  of the tracer's world  @param normal  geometric, unit, on the viewer's side  @param toViewer unit
  Rays raysFrom(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& toViewer) const;

  glm::dvec3 centre;  ///< world position, metres
  float radius;       ///< metres
  std::vector<PlacedMesh> meshes;
  Textures textures;
  Geometry geometry;  ///< what is at least as opaque as frame::LAYER_ALPHA hides
};

}  // namespace telar::reference
