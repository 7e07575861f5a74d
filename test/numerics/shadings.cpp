#include "shadings.h"

namespace telar::numerics {

const std::vector<ShadingPromise>& shadingPromises() {
  static const std::vector<ShadingPromise> promises{
      // Compensation for multiple scattering looks at the viewer alone: no reciprocity of the GGX lobe.
      {"three", ShadingModel::kThree, 2e-2, 1e-3, {true, false, true, true}, false, false, false},
      // Its coat dims what lies beneath by the angle of the light alone.
      {"three-r115", ShadingModel::kThreeR115, 2e-2, 1e-3, {false, false, false, true}, false, false, false},
      {"disney-2012", ShadingModel::kDisney2012, 2e-2, 1e-3, {true, true, true, true}, false, false, false},
      {"fabric", ShadingModel::kFabric, 2e-4, 2e-4, {true, true, false, true}, true, true, true},
  };
  return promises;
}

}  // namespace telar::numerics
