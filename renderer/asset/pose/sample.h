#pragma once
#include <vector>

#include "telar/motion.h"

namespace telar::asset {

/// Value of a sampler at a time, as three.js interpolates it in double: keyframes before the first or after the last
/// hold. @param path  rotations turn along the shorter arc
/// @return sampler.width numbers
std::vector<double> sample(const AnimationSampler& sampler, AnimationPath path, double time);

}  // namespace telar::asset
