#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "swatch/worn.h"

namespace telar::swatch {

/// Mean base colour over the triangles that wear the material, by their area and by what covers of them (alpha modes BLEND and
/// MASK): of a print or an atlas, which no tile tells. Texels are read at 262,144 places and more, by an R2 sequence (Roberts 2018).
/// @return linear Rec.709; none where the texture is not coded as sRGB in bytes, where texture coordinates are missing, or where nothing covers
std::optional<glm::dvec3> meanWornColor(const Scene& scene, const surface::Surface& surface, const Worn& worn,
                                        const CancelToken& cancel);

/// A place in the texture that is worn: its middle, else one as far from the borders of its panel as any, the middle of the
/// triangle that most rings of triangles lie around; of several, the largest.
/// @param set  of the texture's coordinates
/// @return of both sets; (0.5, 0.5) of one that is missing
std::array<glm::dvec2, 2> wornPlace(const Scene& scene, const surface::Surface& surface, const Worn& worn,
                                    std::size_t set, const CancelToken& cancel);

}  // namespace telar::swatch
