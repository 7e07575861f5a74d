#include "gl/program.h"

#include <algorithm>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <sstream>

namespace telar::gl {
namespace {

constexpr int SOURCE_LINES_AROUND = 6;

/// The lines of `source` around the first line number in a driver's log ("0:123(4): error").
std::string sourceAround(const std::string& source, const std::string& log) {
  const auto isDigit = [&](std::size_t i) { return i < log.size() && log[i] >= '0' && log[i] <= '9'; };
  std::size_t colon = log.find(':');
  while (colon != std::string::npos && !(colon > 0 && isDigit(colon - 1) && isDigit(colon + 1)))
    colon = log.find(':', colon + 1);
  if (colon == std::string::npos) return "";
  const int line = std::atoi(log.c_str() + colon + 1);
  std::istringstream in(source);
  std::string text, out;
  for (int i = 1; std::getline(in, text); ++i) {
    if (i >= line - SOURCE_LINES_AROUND && i <= line + SOURCE_LINES_AROUND)
      out += "\n" + std::to_string(i) + ": " + text;
  }
  return out;
}

template <GLenum Stage>
Shader<Stage> compile(const Functions& gl, std::string_view label, const std::string& source) {
  Shader<Stage> shader(gl);
  const char* text = source.c_str();
  const auto length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader.get(), 1, &text, &length);
  gl.CompileShader(shader.get());
  GLint ok = GL_FALSE, logLength = 0;
  gl.GetShaderiv(shader.get(), GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  gl.GetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &logLength);
  std::string log(static_cast<std::size_t>(std::max(logLength, 1)), '\0');
  gl.GetShaderInfoLog(shader.get(), logLength, nullptr, log.data());
  throw Error("X_SHADER", std::string(label) + (Stage == GL_VERTEX_SHADER ? ".vert: " : ".frag: ") + log.c_str() +
                              sourceAround(source, log));
}

}  // namespace

Program::Program(const Context& context, std::string_view label, const std::string& vertex, const std::string& fragment,
                 const std::vector<std::string>& captured)
    : gl_(&context.gl()), name_(context.gl()) {
  const Functions& gl = *gl_;
  const auto vertexShader = compile<GL_VERTEX_SHADER>(gl, label, vertex);
  const auto fragmentShader = compile<GL_FRAGMENT_SHADER>(gl, label, fragment);
  gl.AttachShader(name_.get(), vertexShader.get());
  gl.AttachShader(name_.get(), fragmentShader.get());
  if (!captured.empty()) {
    std::vector<const char*> names;
    names.reserve(captured.size());
    for (const std::string& name : captured) names.push_back(name.c_str());
    gl.TransformFeedbackVaryings(name_.get(), static_cast<GLsizei>(names.size()), names.data(), GL_INTERLEAVED_ATTRIBS);
  }
  gl.LinkProgram(name_.get());
  // 255 is what every driver takes.
  if (gl.ObjectLabel)
    gl.ObjectLabel(GL_PROGRAM, name_.get(), static_cast<GLsizei>(std::min<std::size_t>(label.size(), 255)),
                   label.data());
  GLint ok = GL_FALSE, logLength = 0;
  gl.GetProgramiv(name_.get(), GL_LINK_STATUS, &ok);
  if (ok) return;
  gl.GetProgramiv(name_.get(), GL_INFO_LOG_LENGTH, &logLength);
  std::string log(static_cast<std::size_t>(std::max(logLength, 1)), '\0');
  gl.GetProgramInfoLog(name_.get(), logLength, nullptr, log.data());
  throw Error("X_SHADER", std::string(label) + ": link: " + log.c_str());
}

int Program::location(const char* uniform) const {
  const auto found = locations_.find(uniform);
  if (found != locations_.end()) return found->second;
  int location = gl_->GetUniformLocation(name_.get(), uniform);
  if (location < 0) location = gl_->GetUniformLocation(name_.get(), (std::string(HANDED_ON) + uniform).c_str());
  return locations_[uniform] = location;
}

void Program::set(const char* uniform, int value) const { gl_->Uniform1i(location(uniform), value); }
void Program::set(const char* uniform, float value) const { gl_->Uniform1f(location(uniform), value); }
void Program::set(const char* uniform, const glm::vec2& value) const {
  gl_->Uniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec3& value) const {
  gl_->Uniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec4& value) const {
  gl_->Uniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat3& value) const {
  gl_->UniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) const {
  gl_->UniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, std::span<const float> values) const {
  if (!values.empty()) gl_->Uniform1fv(location(uniform), static_cast<GLsizei>(values.size()), values.data());
}
void Program::set(const char* uniform, std::span<const glm::vec3> values) const {
  if (!values.empty())
    gl_->Uniform3fv(location(uniform), static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

void Program::set(const char* uniform, std::span<const glm::vec2> values) const {
  if (!values.empty())
    gl_->Uniform2fv(location(uniform), static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}
void Program::set(const char* uniform, std::span<const glm::vec4> values) const {
  if (!values.empty())
    gl_->Uniform4fv(location(uniform), static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}
void Program::set(const char* uniform, std::span<const glm::mat4> values) const {
  if (!values.empty())
    gl_->UniformMatrix4fv(location(uniform), static_cast<GLsizei>(values.size()), GL_FALSE,
                          glm::value_ptr(values.front()));
}

}  // namespace telar::gl
