#pragma once
#include <string>
#include <vector>

#include "telar/shading.h"

namespace telar::numerics {

/// What a shading promises. One line a shading: every check goes through this table.
struct ShadingPromise {
  const char* name;
  ShadingModel model;
  /// Relative error of single precision below and above a perceptual roughness of 0.2.
  double smoothError, roughError;
  /// Lobes that are the same with viewer and light exchanged.
  struct {
    bool diffuse, specular, sheen, coat;
  } reciprocal;
  /// Its terms keep their digits at every roughness: errors are relative to the result, with nothing allowed for the
  /// rounding of the directions.
  bool robust;
  /// Energy is kept. Stock shadings keep what their originals get wrong: measured, not asserted.
  bool conserves;
};

const std::vector<ShadingPromise>& shadingPromises();

}  // namespace telar::numerics
