#include "pass/visible/fragment_strips.h"

namespace telar::pass {

void FragmentStrips::begin(std::size_t layers) {
  layers_ = layers;
  for (Turn& turn : turns_) turn.strip = 0;
  if (layers <= held_) return;
  release();
  held_ = layers;
}

void FragmentStrips::make(Turn& turn) const {
  const gl::Functions& gl = context_.gl();
  turn.buffer = gl::Buffer(gl);
  turn.texture = gl::Texture(gl);
  gl.BindBuffer(GL_TEXTURE_BUFFER, turn.buffer.get());
  gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(WIDTH * ROWS * held_ * sizeof(glm::vec4)), nullptr,
                GL_STREAM_DRAW);
  gl.BindTexture(GL_TEXTURE_BUFFER, turn.texture.get());
  gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, turn.buffer.get());
}

void FragmentStrips::bind(std::size_t strip, std::size_t rows,
                          const std::function<void(const visibility::FragmentTexels&)>& fill) {
  const gl::Functions& gl = context_.gl();
  Turn& turn = turns_[strip % TURNS];
  if (!turn.texture) make(turn);
  gl.BindTexture(GL_TEXTURE_BUFFER, turn.texture.get());
  if (turn.strip == strip + 1) return;
  gl.BindBuffer(GL_TEXTURE_BUFFER, turn.buffer.get());
  const auto bytes = static_cast<GLsizeiptr>(WIDTH * rows * layers_ * sizeof(glm::vec4));
  void* texels = gl.MapBufferRange(GL_TEXTURE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT);
  if (texels) fill({static_cast<float*>(texels), WIDTH, layers_});
  gl.UnmapBuffer(GL_TEXTURE_BUFFER);
  context_.check("varyings of fragments");
  turn.strip = strip + 1;
}

void FragmentStrips::release() {
  for (Turn& turn : turns_) turn = {};
  held_ = 0;
}

}  // namespace telar::pass
