#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar {

struct Swatch {
  std::shared_ptr<const Scene> scene;
  /// The base colour as a whole, linear Rec.709, by what covers (BLEND, MASK): the mean over the tile of a texture where the garment wears all
  /// of it, else over the triangles that wear the material. None where it is draped, and where the texture is not coded as sRGB in bytes.
  std::optional<glm::dvec3> meanBaseColor;
};

/// A scene of one square of a material of `model` in true size, upright about the origin, its face to +Z: textures
/// repeat on it as often in a metre as on the garment, along u and along v, by the mean over its
/// triangles. Occlusion maps, light and cameras of the file are left out. The request, which js/api/swatch.mjs writes:
/// {variant: string, part: {kind, which}, size: metres, draped: boolean}; of a node, the material that covers most of
/// it. Draped, the square hangs from its upper edge in folds that grow downwards; its rows keep their length.
/// Its middle is that of the texture. Where it shows less than a tile, and nothing wears the middle, as of an atlas, it is a place far
/// from the borders of a panel.
/// @param model  as loaded, or a pose of it; its images are shared
/// @throws Error{E_MEASURE (no such part, or it draws no triangles), L_TRIANGLES, X_CANCELLED, X_MEMORY}
Swatch swatchOf(const std::shared_ptr<const Scene>& model, std::string_view request, const CancelToken& cancel);

}  // namespace telar
