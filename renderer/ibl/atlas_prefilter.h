#pragma once
#include <string>

#include "ibl/atlas.h"
#include "telar/image.h"
#include "telar/shading.h"

namespace telar::ibl {

/// Whether a release keeps a prefiltered environment as an atlas; else as a cube (ibl/prefilter.h).
inline bool hasAtlas(const ThreeTerms& three) { return three.prefilter != ThreeTerms::THREE_PREFILTER_CUBE; }

/// Names what prefilterAtlas() makes of one map by these terms.
std::string atlasName(const ThreeTerms& three);

/// Prefilters an equirectangular map as three.js 0.150 to 0.186 do: each level from the one before, by the term
/// `prefilter`. js/docs/families.md has the formulas.
/// @param map  linear Rec.709, finite, at least 64 px wide for levels that are no smaller than the atlas's least
/// @param three  hasAtlas()
/// @return atlas of faces of the largest power of two <= width / 4; its roughest level is also the irradiance / PI
/// @throws Error{X_GL, X_CANCELLED}. Needs a current context.
Atlas prefilterAtlas(const gl::Context& context, const ImageF& map, const ThreeTerms& three, const CancelToken& cancel);

}  // namespace telar::ibl
