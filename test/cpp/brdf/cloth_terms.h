#pragma once
#include "brdf/terms.h"

namespace telar::test {

/// Rows of r115.glsl, disney.glsl and environment_fit.glsl.
std::vector<Term> thesisTerms();
/// Rows of cloth.glsl.
std::vector<Term> clothTerms();

}  // namespace telar::test
