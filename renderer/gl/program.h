#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "gl/context.h"
#include "gl/gl_object.h"

namespace telar::gl {

/// Before the name of a uniform whose value the vertex stage hands on to the fragments under that name.
constexpr std::string_view HANDED_ON = "handedOn_";

/// A linked vertex + fragment program with its uniforms by name.
class Program {
 public:
  Program() = default;
  /// @param label name in debug tools and error messages
  /// @throws Error{X_SHADER} with the driver's log and the source lines around it.
  /// @param captured  outputs of the vertex stage that transform feedback writes, one after the other
  Program(const Context& context, std::string_view label, const std::string& vertex, const std::string& fragment,
          const std::vector<std::string>& captured = {});

  void use() const { gl_->UseProgram(name_.get()); }
  bool has(const char* uniform) const { return location(uniform) >= 0; }

  // Setters need use() first; a uniform that the program does not have is skipped.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat3& value) const;
  void set(const char* uniform, const glm::mat4& value) const;
  void set(const char* uniform, std::span<const float> values) const;      ///< float[]
  void set(const char* uniform, std::span<const glm::vec3> values) const;  ///< vec3[]
  void set(const char* uniform, std::span<const glm::vec2> values) const;  ///< vec2[]
  void set(const char* uniform, std::span<const glm::vec4> values) const;  ///< vec4[]
  void set(const char* uniform, std::span<const glm::mat4> values) const;  ///< mat4[]

 private:
  int location(const char* uniform) const;

  const Functions* gl_ = nullptr;
  ProgramName name_;
  mutable std::unordered_map<std::string, int> locations_;
};

}  // namespace telar::gl
