#pragma once
#include <string>

#include "asset/check/warnings.h"

namespace telar::asset {

/// `value` within low..high; W_RANGE at `where` when that changed it, which names the range and the value.
float clamped(double value, double low, double high, const std::string& where, Warnings& warnings);

}  // namespace telar::asset
