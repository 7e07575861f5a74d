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
  /// Its terms keep their digits at every roughness, that of the thinnest fuzz included.
  bool robust;
  /// Energy is kept. Stock shadings keep what their originals get wrong: measured, not asserted.
  bool conserves;
  /// It shades the yarns of woven cloth.
  bool weaves;
};

const std::vector<ShadingPromise>& shadingPromises();

}  // namespace telar::numerics
