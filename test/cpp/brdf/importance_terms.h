#pragma once
#include "brdf/terms.h"

namespace telar::test {

/// Rows of the directions that are drawn for lobes.
std::vector<Term> importanceTerms();

}  // namespace telar::test
