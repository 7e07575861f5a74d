#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar {

/// A cloth that parts of a model are shown in, in place of their own material.
struct Dressing {
  std::vector<int> materials;             ///< indices of the file's materials that it replaces, wherever they are drawn
  std::vector<int> nodes;                 ///< indices of the file's nodes whose meshes it replaces it on
  std::shared_ptr<const Scene> cloth;     ///< a square of it: its first drawn material; null = the part keeps its own
  std::optional<glm::vec3> color;         ///< linear Rec.709; none = the part's own colour
  std::optional<glm::dvec2> metresPerUv;  ///< of the part's TEXCOORD_0, along u and v; none = measured
  double scale = 1;                       ///< size of its pattern, 1 = as on the square
  double rotation = 0;                    ///< radians, counter-clockwise with v upwards
};

/// The scene with other materials: the later dressing holds, and one of a node before one of a material. A cloth brings
/// everything but occlusion, sides and name, which stay the part's, and the colour unless one is given. Its pattern is
/// placed by the texture coordinates TEXCOORD_0 in the size that it has on its own square: both are measured, unless
/// the dressing states the garment's. Meshes and images are shared with `model`.
/// @throws Error{E_CLOTH} where a cloth draws nothing; Error{X_CANCELLED, X_MEMORY}
std::shared_ptr<const Scene> dressScene(const std::shared_ptr<const Scene>& model,
                                        const std::vector<Dressing>& dressings, const CancelToken& cancel);

/// JSON {materials, images, warnings} as describeScene() has them: what of a scene's facts its cloths change.
std::string describeDressed(const Scene& scene);

/// JSON {materials: [name], nodes: [{node, name, parent}]}: what parts of the scene are called, in the file's words.
/// node: index in the file; parent: place in the list, which stands before it, -1 = none.
std::string describeNames(const Scene& scene);

/// Metres that one unit of u and one of v cover on the surfaces of each of the file's materials, in any variant: the
/// median by area over the triangles of a mesh, then over the meshes, so that a squeezed patch changes nothing. None
/// where no such surface has TEXCOORD_0.
/// @param wanted  whether to measure, by index into Scene::materials
std::vector<std::optional<glm::dvec2>> metresPerUv(const Scene& scene, const std::vector<bool>& wanted,
                                                   const CancelToken& cancel);

/// JSON: metresPerUv() of each of the file's materials, [u, v] or null.
std::string describeUvScales(const Scene& scene, const CancelToken& cancel);

}  // namespace telar
