#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar {

/// A scene of one square of a material of `model` in true size, upright about the origin, its face to +Z: textures
/// repeat on it as often in a metre as on the garment, along u and along v, by the mean over its
/// triangles. Occlusion maps, light and cameras of the file are left out. The request, which js/api/swatch.mjs writes:
/// {variant: string, part: {kind, which}, size: metres, draped: boolean}; of a node, the material that covers most of
/// it. Draped, the square hangs from its upper edge in folds that grow downwards; its rows keep their length.
/// @param model  as loaded, or a pose of it; its images are shared
/// @throws Error{E_MEASURE (no such part, or it draws no triangles), L_TRIANGLES, X_CANCELLED, X_MEMORY}
std::shared_ptr<const Scene> swatchOf(const std::shared_ptr<const Scene>& model, std::string_view request,
                                      const CancelToken& cancel);

/// The base colour of a flat swatch as a whole: the mean over a tile of its texture, where the square shows a tile at least
/// along u and along v.
/// @return linear Rec.709, as JSON [r, g, b]; null where it is draped, and where the mean over what is seen of the square is another: of a print
///         that does not repeat on it, a material with holes, a texture that is not coded as sRGB in bytes
std::string describeSwatchColor(const Scene& swatch);

}  // namespace telar
