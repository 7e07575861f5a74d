#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "brdf/terms.h"
#include "gl/context.h"
#include "gl/program.h"

namespace telar::test {
namespace {

constexpr int EDGE = 64;  // texels: one row of arguments each
constexpr std::size_t ROWS = EDGE * EDGE;
constexpr int ARGUMENT_TEXTURES = MAX_COLUMNS / 4;
// Relative, beyond what one-ulp changes of the arguments explain. Measured on llvmpipe: see the printed table.
constexpr double TOLERANCE = 2e-5;

/// Evaluates terms on a real context: arguments in RGBA32F textures, one texel a row, results in an RGBA32F target.
class Probe {
 public:
  explicit Probe(Backend backend)
      : context_(gl::Context::create(backend)), framebuffer_(gl()), triangle_(gl()), result_(gl()) {
    for (int i = 0; i < ARGUMENT_TEXTURES; ++i) arguments_.push_back(gl::Texture(gl()));
    for (const auto& texture : arguments_) allocate(texture);
    allocate(result_);
    gl().BindVertexArray(triangle_.get());
    gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    gl().FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, result_.get(), 0);
    gl().Viewport(0, 0, EDGE, EDGE);
  }

  const gl::Context& context() const { return *context_; }

  /// @param expression gives a vec3 from `float p[MAX_COLUMNS]`
  /// @return RGBA by row
  std::vector<float> evaluate(const std::string& expression, const std::vector<float>& rows) {
    std::vector<float> texels(ROWS * 4);
    const gl::Program program(*context_, "probe", VERTEX, fragment(expression));
    program.use();
    for (int i = 0; i < ARGUMENT_TEXTURES; ++i) {
      for (std::size_t row = 0; row < ROWS; ++row) std::memcpy(&texels[row * 4], &rows[row * MAX_COLUMNS + i * 4], 16);
      gl().ActiveTexture(GL_TEXTURE0 + i);
      gl().BindTexture(GL_TEXTURE_2D, arguments_[i].get());
      gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, EDGE, EDGE, GL_RGBA, GL_FLOAT, texels.data());
      program.set(("arguments" + std::to_string(i)).c_str(), i);
    }
    gl().DrawArrays(GL_TRIANGLES, 0, 3);
    gl().ReadPixels(0, 0, EDGE, EDGE, GL_RGBA, GL_FLOAT, texels.data());
    context_->check("probe");
    return texels;
  }

 private:
  static constexpr const char* VERTEX = R"(#version 300 es
void main() {
  gl_Position = vec4(float(gl_VertexID == 1) * 4.0 - 1.0, float(gl_VertexID == 2) * 4.0 - 1.0, 0.0, 1.0);
}
)";

  static std::string fragment(const std::string& expression) {
    std::string text = "#version 300 es\nprecision highp float;\nprecision highp sampler2D;\n" + sharedText();
    std::string load = "  float p[" + std::to_string(MAX_COLUMNS) + "];\n  ivec2 at = ivec2(gl_FragCoord.xy);\n";
    for (int i = 0; i < ARGUMENT_TEXTURES; ++i) {
      const std::string name = "arguments" + std::to_string(i), texel = "t" + std::to_string(i);
      text += "uniform sampler2D " + name + ";\n";
      load += "  vec4 " + texel + " = texelFetch(" + name + ", at, 0);\n";
      for (int j = 0; j < 4; ++j)
        load += "  p[" + std::to_string(i * 4 + j) + "] = " + texel + "[" + std::to_string(j) + "];\n";
    }
    return text + "out vec4 result;\nvoid main() {\n" + load + "  result = vec4(" + expression + ", 1.0);\n}\n";
  }

  const gl::Functions& gl() const { return context_->gl(); }

  void allocate(const gl::Texture& texture) {
    gl().BindTexture(GL_TEXTURE_2D, texture.get());
    gl().TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, EDGE, EDGE);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }

  std::unique_ptr<gl::Context> context_;
  std::vector<gl::Texture> arguments_;
  gl::Framebuffer framebuffer_;
  gl::VertexArray triangle_;
  gl::Texture result_;
};

class OnGpu : public testing::TestWithParam<Backend> {};

TEST_P(OnGpu, EveryTermAgreesWithDouble) {
  Probe probe(GetParam());
  ASSERT_TRUE(probe.context().capabilities().colorBufferFloat) << "RGBA32F is not renderable here";
  std::printf("%-28s %10s %10s %10s %10s   (%s)\n", "term", "max", "99 %", "excess", "to float",
              probe.context().renderer().c_str());
  for (const Term& term : terms()) {
    const std::vector<float> rows = samples(term, ROWS);
    const std::vector<float> result = probe.evaluate(term.expression, rows);
    std::vector<double> errors;
    double excess = 0, toFloat = 0;
    const float* worst = nullptr;
    for (std::size_t i = 0; i < ROWS; ++i) {
      const float* p = &rows[i * MAX_COLUMNS];
      double exact[MAX_COLUMNS];
      std::copy(p, p + MAX_COLUMNS, exact);
      const glm::vec3 actual(result[i * 4], result[i * 4 + 1], result[i * 4 + 2]);
      const glm::dvec3 expected = term.inDouble(exact);
      errors.push_back(relativeError(term, actual, expected));
      toFloat = std::max(toFloat, relativeError(term, actual, glm::dvec3(term.inFloat(p))));
      const double beyond = excessError(term, p, actual, expected);
      if (!(beyond <= excess)) excess = beyond, worst = p;
      if (term.nonNegative) {
        ASSERT_GE(std::min({actual.x, actual.y, actual.z}), 0.0f) << term.name << " row " << i;
      }
    }
    std::sort(errors.begin(), errors.end());
    std::printf("%-28s %10.1e %10.1e %10.1e %10.1e\n", term.name.c_str(), errors.back(), errors[ROWS * 99 / 100],
                excess, toFloat);
    EXPECT_LE(excess, TOLERANCE) << term.name << " at "
                                 << (worst ? testing::PrintToString(std::vector<float>(worst, worst + MAX_COLUMNS))
                                           : "");
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, OnGpu, testing::Values(Backend::kEglSurfaceless, Backend::kOsmesa),
                         [](const auto& tested) { return tested.param == Backend::kOsmesa ? "osmesa" : "egl"; });

}  // namespace
}  // namespace telar::test
