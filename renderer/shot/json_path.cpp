#include "shot/json_path.h"

#include <algorithm>
#include <cmath>

#include "core/json_text.h"

namespace telar::shot {
namespace {

/// As js/shot/fields.mjs: inside the range of the 32-bit floats that the GPU computes in.
constexpr double COLOR_MAX = 1e30;

std::string text(double x) { return nlohmann::json(x).dump(); }

}  // namespace

void JsonPath::fail(const std::string& expected) const {
  throw Error("E_SHOT", path_ + ": expected " + expected + ", got " + shown(value_)).at(pointer_);
}

JsonPath JsonPath::at(std::string_view key) const {
  if (!value_.is_object()) fail("an object");
  const std::string name(key);
  const std::string path = path_ + "." + name;
  const std::string pointer = pointer_ + "/" + name;
  const auto found = value_.find(name);
  if (found == value_.end()) {
    throw Error("E_SHOT", path + ": expected a value, got nothing: pass what resolveShot returns").at(pointer);
  }
  return {*found, path, pointer};
}

JsonPath JsonPath::at(std::size_t index) const {
  const std::string position = std::to_string(index);
  return {value_.at(index), path_ + "[" + position + "]", pointer_ + "/" + position};
}

std::size_t JsonPath::size() const {
  if (!value_.is_array()) fail("an array");
  return value_.size();
}

double JsonPath::number(double min, double max) const {
  if (!value_.is_number()) fail("a number");
  const double x = value_.get<double>();
  if (!std::isfinite(x)) fail("a finite number");
  if (x < min) fail("a number of at least " + text(min));
  if (x > max) fail("a number of at most " + text(max));
  return x;
}

int JsonPath::integer(int min, int max) const {
  const double x = value_.is_number() ? value_.get<double>() : std::nan("");
  if (!(x >= min && x <= max) || x != std::floor(x)) {
    fail("an integer from " + std::to_string(min) + " to " + std::to_string(max));
  }
  return static_cast<int>(x);
}

bool JsonPath::boolean() const {
  if (!value_.is_boolean()) fail("true or false");
  return value_.get<bool>();
}

std::string JsonPath::string() const {
  if (!value_.is_string()) fail("a string");
  return value_.get<std::string>();
}

std::size_t JsonPath::choice(std::initializer_list<std::string_view> choices) const {
  std::string expected = "one of";
  std::size_t index = 0;
  for (const std::string_view candidate : choices) {
    if (value_.is_string() && value_.get_ref<const std::string&>() == candidate) return index;
    expected += (index++ ? ", " : " ") + std::string(candidate);
  }
  fail(expected);
}

glm::dvec3 JsonPath::vec3() const {
  if (!value_.is_array() || value_.size() != 3) fail("an array of 3 numbers");
  return {at(std::size_t{0}).number(), at(1).number(), at(2).number()};
}

glm::vec3 JsonPath::color() const {
  const glm::dvec3 rgb = vec3();
  const double low = std::min({rgb.r, rgb.g, rgb.b}), high = std::max({rgb.r, rgb.g, rgb.b});
  if (low < 0 || high > COLOR_MAX) fail("a linear colour with components from 0 to " + text(COLOR_MAX));
  return glm::vec3(rgb);
}

}  // namespace telar::shot
