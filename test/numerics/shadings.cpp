#include "shadings.h"

namespace telar::numerics {

const std::vector<ShadingPromise>& shadingPromises() {
  static const std::vector<ShadingPromise> promises{
      // Compensation for multiple scattering looks at the viewer alone: no reciprocity of the GGX lobe.
      {"three", ShadingModel::kThree, 2e-2, 1e-3, {true, false, true, true}, false},
  };
  return promises;
}

}  // namespace telar::numerics
