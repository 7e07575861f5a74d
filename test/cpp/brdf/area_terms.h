#pragma once
#include "brdf/terms.h"

namespace telar::test {

/// Rows of light from rectangles.
std::vector<Term> areaTerms();

}  // namespace telar::test
