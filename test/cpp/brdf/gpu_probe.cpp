#include "brdf/gpu_probe.h"

#include <cstring>

#include "gl/program.h"

namespace telar::test {
namespace {

constexpr int ARGUMENT_TEXTURES = MAX_COLUMNS / 4;

constexpr const char* VERTEX = R"(#version 300 es
void main() {
  gl_Position = vec4(float(gl_VertexID == 1) * 4.0 - 1.0, float(gl_VertexID == 2) * 4.0 - 1.0, 0.0, 1.0);
}
)";

std::string argumentName(int texture) { return "arguments" + std::to_string(texture); }

std::string fragment(const std::string& text, const std::string& expression, const std::string& statement) {
  std::string head = "#version 300 es\nprecision highp float;\nprecision highp sampler2D;\n" + text;
  std::string load = "  float p[" + std::to_string(MAX_COLUMNS) + "];\n  ivec2 at = ivec2(gl_FragCoord.xy);\n";
  for (int i = 0; i < ARGUMENT_TEXTURES; ++i) {
    const std::string texel = "texel" + std::to_string(i);
    head += "uniform sampler2D " + argumentName(i) + ";\n";
    load += "  vec4 " + texel + " = texelFetch(" + argumentName(i) + ", at, 0);\n";
    for (int j = 0; j < 4; ++j) {
      load += "  p[" + std::to_string(i * 4 + j) + "] = " + texel + "[" + std::to_string(j) + "];\n";
    }
  }
  return head + "out vec4 probeResult;\nvoid main() {\n" + load + "  " + statement + "\n  probeResult = vec4(" +
         expression + ", 1.0);\n}\n";
}

}  // namespace

GpuProbe::GpuProbe(Backend backend)
    : context_(gl::Context::create(backend)), framebuffer_(gl()), triangle_(gl()), result_(gl()) {
  for (int i = 0; i < ARGUMENT_TEXTURES; ++i) arguments_.push_back(gl::Texture(gl()));
  for (const auto& texture : arguments_) allocate(texture);
  allocate(result_);
  gl().BindVertexArray(triangle_.get());
  gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  gl().FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, result_.get(), 0);
  gl().Viewport(0, 0, EDGE, EDGE);
}

std::vector<float> GpuProbe::evaluate(const std::string& text, const std::string& expression,
                                      const std::vector<float>& rows, const std::string& statement) {
  std::vector<float> texels(ROWS * 4);
  const gl::Program program(*context_, "probe", VERTEX, fragment(text, expression, statement));
  program.use();
  for (int i = 0; i < ARGUMENT_TEXTURES; ++i) {
    for (std::size_t row = 0; row < ROWS; ++row) {
      std::memcpy(&texels[row * 4], &rows[row * MAX_COLUMNS + static_cast<std::size_t>(i) * 4], 4 * sizeof(float));
    }
    gl().ActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + i));
    gl().BindTexture(GL_TEXTURE_2D, arguments_[static_cast<std::size_t>(i)].get());
    gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, EDGE, EDGE, GL_RGBA, GL_FLOAT, texels.data());
    program.set(argumentName(i).c_str(), i);
  }
  gl().DrawArrays(GL_TRIANGLES, 0, 3);
  gl().ReadPixels(0, 0, EDGE, EDGE, GL_RGBA, GL_FLOAT, texels.data());
  context_->check("probe");
  return texels;
}

void GpuProbe::allocate(const gl::Texture& texture) {
  gl().BindTexture(GL_TEXTURE_2D, texture.get());
  gl().TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, EDGE, EDGE);
  gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace telar::test
