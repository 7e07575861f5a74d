#pragma once
#include "reference/plugin.h"

namespace telar::reference {

/// Finds job.sides: Primitive::visibility by rays from the vertices.
void findVisibility(VisibilityJob& job);

}  // namespace telar::reference
