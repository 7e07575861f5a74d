#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "swatch/worn.h"

namespace telar::swatch {

/// Whether a garment wears a period of a texture that repeats, two tiles of one that is mirrored: each place of it, wherever in the plane
/// of its coordinates. Not so of an atlas, between whose panels nothing is worn, nor of a trim that wears a part of it.
/// @pre the material has a texture of its base colour
bool wearsATile(const Scene& scene, const surface::Surface& surface, const Worn& worn, const CancelToken& cancel);

/// Mean base colour of a tile: of all texels by what covers of them (alpha modes BLEND and MASK), of all alike where nothing does.
/// @pre the material has a texture of its base colour
/// @return linear Rec.709; none where the texture is not coded as sRGB in bytes
std::optional<glm::dvec3> meanTileColor(const Scene& scene, const Worn& worn);

/// Mean base colour over the triangles that wear the material, by their area and by what covers of them (alpha modes BLEND and
/// MASK), by area alone where nothing does: of a print or an atlas, which no tile tells. Texels are read at 262,144 places and more.
/// @return linear Rec.709; none where the texture is not coded as sRGB in bytes, or where its coordinates are missing
std::optional<glm::dvec3> meanWornColor(const Scene& scene, const surface::Surface& surface, const Worn& worn,
                                        const CancelToken& cancel);

/// A place in the texture that is worn: its middle, else one as far from the borders of its panel as any, the middle of the
/// triangle that most rings of triangles lie around; of several, the largest.
/// @param set  of the texture's coordinates
/// @return of both sets; (0.5, 0.5) of one that is missing
std::array<glm::dvec2, 2> wornPlace(const Scene& scene, const surface::Surface& surface, const Worn& worn,
                                    std::size_t set, const CancelToken& cancel);

}  // namespace telar::swatch
