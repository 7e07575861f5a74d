#include "pass/fragment_strips.h"

#include "gl/nearest_texture.h"
#include "visibility/memory.h"

namespace telar::pass {

void FragmentStrips::begin(std::size_t layers) {
  layers_ = layers;
  strips_.fill(0);
  if (layers <= held_) return;
  for (gl::Texture& texture : textures_) texture.reset();
  held_ = layers;
}

void FragmentStrips::bind(std::size_t strip, std::size_t rows,
                          const std::function<void(const visibility::FragmentTexels&)>& fill) {
  const gl::Functions& gl = context_.gl();
  gl::Texture& texture = textures_[strip % TURNS];
  if (!texture) texture = gl::nearestTexture(gl, GL_RGBA32F, WIDTH, static_cast<int>(ROWS * held_));
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  if (strips_[strip % TURNS] == strip + 1) return;
  texels_.resize(ROWS * layers_ * WIDTH * 4);
  fill({texels_.data(), WIDTH, layers_});
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(WIDTH), static_cast<GLsizei>(rows * layers_), GL_RGBA,
                   GL_FLOAT, texels_.data());
  context_.check("varyings of fragments");
  strips_[strip % TURNS] = strip + 1;
}

std::size_t FragmentStrips::memory() const { return visibility::bytesOf(texels_); }

void FragmentStrips::release() {
  for (gl::Texture& texture : textures_) texture.reset();
  held_ = 0;
  texels_ = {};
}

}  // namespace telar::pass
