#pragma once
#include "brdf/terms.h"

namespace telar::test {

/// Rows of shaders/brdf/transmission.glsl.
std::vector<Term> transmissionTerms();

}  // namespace telar::test
