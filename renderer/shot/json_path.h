#pragma once
#include <glm/glm.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace telar::shot {

/// A JSON value that knows its path from the root of the shot ("shot.camera.position", "shot.lights[2].color"), so that
/// each complaint names it. Every reader throws Error{E_SHOT} with the path, what was expected and the value found, and
/// with the JSON pointer. The root must outlive it.
class JsonPath {
 public:
  explicit JsonPath(const nlohmann::json& root) : value_(root), path_("shot") {}

  /// Member that must be there.
  JsonPath at(std::string_view key) const;
  /// Element of an array.
  JsonPath at(std::size_t index) const;
  bool has(std::string_view key) const { return value_.is_object() && value_.contains(key); }
  bool isNull() const { return value_.is_null(); }
  bool isArray() const { return value_.is_array(); }
  bool isObject() const { return value_.is_object(); }
  bool isString() const { return value_.is_string(); }
  std::size_t size() const;

  /// Finite.
  double number() const;
  int integer(int min, int max) const;
  /// A whole number of `values`; all of them stand in the message.
  int oneOf(std::initializer_list<int> values) const;
  bool boolean() const;
  std::string string() const;
  /// Index of the string in `choices`; all of them stand in the message.
  std::size_t choice(std::span<const std::string_view> choices) const;
  glm::dvec2 vec2() const;
  glm::dvec3 vec3() const;
  /// Linear Rec.709.
  glm::vec3 color() const { return glm::vec3(vec3()); }

  [[noreturn]] void fail(const std::string& expected) const;

 private:
  JsonPath(const nlohmann::json& value, std::string path, std::string pointer)
      : value_(value), path_(std::move(path)), pointer_(std::move(pointer)) {}

  const nlohmann::json& value_;
  std::string path_;     ///< "shot.lights[2].color", for people
  std::string pointer_;  ///< "/lights/2/color", for programs
};

}  // namespace telar::shot
