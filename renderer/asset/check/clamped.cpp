#include "asset/check/clamped.h"

#include <algorithm>
#include <sstream>

#include "asset/check/number.h"

namespace telar::asset {

float clamped(double value, double low, double high, const std::string& where, Warnings& warnings) {
  const double out = std::clamp(value, low, high);
  if (out != value) {
    std::ostringstream message;
    message << "expected " << low << " to " << high << ", got " << value << ": " << out << " is taken";
    warnings.add("W_RANGE", message.str(), where);
  }
  return toFloat(out);
}

}  // namespace telar::asset
