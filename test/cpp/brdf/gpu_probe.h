#pragma once
#include <memory>
#include <string>
#include <vector>

#include "brdf/terms.h"
#include "gl/context.h"
#include "gl/gl_object.h"
#include "gl/program.h"

namespace telar::test {

/// Evaluates GLSL expressions on a real context: arguments in an RGBA32F texture, rows of neighbouring texels, results
/// in an RGBA32F target.
class GpuProbe {
 public:
  static constexpr int EDGE = 64;  ///< texels
  static constexpr std::size_t ROWS = EDGE * EDGE;

  /// @param columns  numbers of a row, a multiple of 4
  /// @throws Error{X_GL}
  explicit GpuProbe(Backend backend, std::size_t columns = MAX_COLUMNS);

  const gl::Context& context() const { return *context_; }

  /// @param text        GLSL before main, without #version
  /// @param expression  gives a vec3 from `float p[columns]`
  /// @param statement   runs before the expression, with p in scope
  /// @throws Error{X_SHADER}
  gl::Program compile(const std::string& text, const std::string& expression, const std::string& statement = "") const;

  /// @param rows  ROWS * columns arguments, as samples() makes them
  /// @return RGBA by row
  /// @throws Error{X_GL}
  std::vector<float> run(const gl::Program& program, const std::vector<float>& rows) const;

  /// Both.
  std::vector<float> evaluate(const std::string& text, const std::string& expression, const std::vector<float>& rows,
                              const std::string& statement = "") const {
    return run(compile(text, expression, statement), rows);
  }

 private:
  const gl::Functions& gl() const { return context_->gl(); }
  void allocate(const gl::Texture& texture, int width) const;

  std::size_t columns_;
  std::unique_ptr<gl::Context> context_;
  gl::Texture arguments_;
  gl::Framebuffer framebuffer_;
  gl::VertexArray triangle_;
  gl::Texture result_;
};

}  // namespace telar::test
