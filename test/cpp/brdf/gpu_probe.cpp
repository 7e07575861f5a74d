#include "brdf/gpu_probe.h"

namespace telar::test {
namespace {

constexpr const char* VERTEX = R"(#version 300 es
void main() {
  gl_Position = vec4(float(gl_VertexID == 1) * 4.0 - 1.0, float(gl_VertexID == 2) * 4.0 - 1.0, 0.0, 1.0);
}
)";

std::string fragment(const std::string& text, const std::string& expression, const std::string& statement,
                     std::size_t columns) {
  std::string load = "  float p[" + std::to_string(columns) + "];\n  ivec2 at = ivec2(gl_FragCoord.xy);\n";
  for (std::size_t i = 0; i < columns / 4; ++i) {
    const std::string number = std::to_string(i), texel = "texel" + number;
    load += "  vec4 " + texel + " = texelFetch(probeArguments, ivec2(at.x * " + std::to_string(columns / 4) + " + " +
            number + ", at.y), 0);\n";
    for (std::size_t j = 0; j < 4; ++j) {
      load += "  p[" + std::to_string(i * 4 + j) + "] = " + texel + "[" + std::to_string(j) + "];\n";
    }
  }
  return "#version 300 es\nprecision highp float;\nprecision highp sampler2D;\nuniform sampler2D probeArguments;\n" +
         text + "out vec4 probeResult;\nvoid main() {\n" + load + "  " + statement + "\n  probeResult = vec4(" +
         expression + ", 1.0);\n}\n";
}

}  // namespace

GpuProbe::GpuProbe(Backend backend, std::size_t columns)
    : columns_(columns),
      context_(gl::Context::create(backend)),
      arguments_(gl()),
      framebuffer_(gl()),
      triangle_(gl()),
      result_(gl()) {
  allocate(arguments_, EDGE * static_cast<int>(columns / 4));
  allocate(result_, EDGE);
  gl().BindVertexArray(triangle_.get());
  gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  gl().FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, result_.get(), 0);
  gl().Viewport(0, 0, EDGE, EDGE);
}

gl::Program GpuProbe::compile(const std::string& text, const std::string& expression,
                              const std::string& statement) const {
  return gl::Program(*context_, "probe", VERTEX, fragment(text, expression, statement, columns_));
}

std::vector<float> GpuProbe::run(const gl::Program& program, const std::vector<float>& rows) const {
  program.use();
  program.set("probeArguments", 0);
  gl().ActiveTexture(GL_TEXTURE0);
  gl().BindTexture(GL_TEXTURE_2D, arguments_.get());
  gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, EDGE * static_cast<int>(columns_ / 4), EDGE, GL_RGBA, GL_FLOAT,
                     rows.data());
  gl().DrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<float> texels(ROWS * 4);
  gl().ReadPixels(0, 0, EDGE, EDGE, GL_RGBA, GL_FLOAT, texels.data());
  context_->check("probe");
  return texels;
}

void GpuProbe::allocate(const gl::Texture& texture, int width) const {
  gl().BindTexture(GL_TEXTURE_2D, texture.get());
  gl().TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, EDGE);
  gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace telar::test
