#include "asset/check/clamped.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "asset/check/number.h"

namespace telar::asset {
namespace {

/// The shortest text that reads back as the number.
std::string shortestText(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

float clamped(double value, double low, double high, const std::string& where, Warnings& warnings) {
  const double out = std::clamp(value, low, high);
  if (out != value) {
    warnings.add("W_RANGE",
                 "expected " + shortestText(low) + " to " + shortestText(high) + ", got " + shortestText(value) + ": " +
                     shortestText(out) + " is taken",
                 where);
  }
  return toFloat(out);
}

}  // namespace telar::asset
