#pragma once
#include <memory>
#include <string>
#include <vector>

#include "brdf/terms.h"
#include "gl/context.h"
#include "gl/gl_object.h"

namespace telar::test {

/// Evaluates GLSL expressions on a real context: arguments in RGBA32F textures, one texel a row, results in an RGBA32F
/// target.
class GpuProbe {
 public:
  static constexpr int EDGE = 64;  ///< texels
  static constexpr std::size_t ROWS = EDGE * EDGE;

  /// @throws Error{X_GL}
  explicit GpuProbe(Backend backend);

  const gl::Context& context() const { return *context_; }

  /// @param text        GLSL before main, without #version
  /// @param expression  gives a vec3 from `float p[MAX_COLUMNS]`
  /// @param rows        ROWS * MAX_COLUMNS arguments, as samples() makes them
  /// @param statement   runs before the expression, with p in scope
  /// @return RGBA by row
  /// @throws Error{X_SHADER, X_GL}
  std::vector<float> evaluate(const std::string& text, const std::string& expression, const std::vector<float>& rows,
                              const std::string& statement = "");

 private:
  const gl::Functions& gl() const { return context_->gl(); }
  void allocate(const gl::Texture& texture);

  std::unique_ptr<gl::Context> context_;
  std::vector<gl::Texture> arguments_;
  gl::Framebuffer framebuffer_;
  gl::VertexArray triangle_;
  gl::Texture result_;
};

}  // namespace telar::test
