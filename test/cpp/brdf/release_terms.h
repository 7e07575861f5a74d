#pragma once
#include "brdf/terms.h"

namespace telar::test {

/// Rows of shaders/brdf/three_releases.glsl and neutral_white.glsl.
std::vector<Term> releaseTerms();

}  // namespace telar::test
