#include "shot/json_path.h"

#include <cmath>

#include "core/json_text.h"

namespace telar::shot {
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

double JsonPath::number() const {
  if (!value_.is_number()) fail("a number");
  const double x = value_.get<double>();
  if (!std::isfinite(x)) fail("a finite number");
  return x;
}

int JsonPath::integer(int min, int max) const {
  const double x = value_.is_number() ? value_.get<double>() : std::nan("");
  if (!(x >= min && x <= max) || x != std::floor(x)) {
    fail("an integer from " + std::to_string(min) + " to " + std::to_string(max));
  }
  return static_cast<int>(x);
}

int JsonPath::oneOf(std::initializer_list<int> values) const {
  const double x = value_.is_number() ? value_.get<double>() : std::nan("");
  std::string expected = "one of";
  for (const int value : values) {
    if (x == value) return value;
    expected += (value == *values.begin() ? " " : ", ") + std::to_string(value);
  }
  fail(expected);
}

bool JsonPath::boolean() const {
  if (!value_.is_boolean()) fail("true or false");
  return value_.get<bool>();
}

std::string JsonPath::string() const {
  if (!value_.is_string()) fail("a string");
  return value_.get<std::string>();
}

std::size_t JsonPath::choice(std::span<const std::string_view> choices) const {
  std::string expected = "one of";
  std::size_t index = 0;
  for (const std::string_view candidate : choices) {
    if (value_.is_string() && value_.get_ref<const std::string&>() == candidate) return index;
    expected += (index++ ? ", " : " ") + std::string(candidate);
  }
  fail(expected);
}

glm::dvec2 JsonPath::vec2() const {
  if (!value_.is_array() || value_.size() != 2) fail("an array of 2 numbers");
  return {at(std::size_t{0}).number(), at(1).number()};
}

glm::dvec3 JsonPath::vec3() const {
  if (!value_.is_array() || value_.size() != 3) fail("an array of 3 numbers");
  return {at(std::size_t{0}).number(), at(1).number(), at(2).number()};
}

}  // namespace telar::shot
