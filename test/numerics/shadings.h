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
  /// Stock shadings keep what their originals get wrong about energy: measured, not asserted.
  bool conserves;
};

const std::vector<ShadingPromise>& shadingPromises();

}  // namespace telar::numerics
