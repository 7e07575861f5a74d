#pragma once
#include "gl/functions.h"
#include "gl/gl_object.h"

namespace telar::gl {

/// A texture that is read texel by texel, without a filter. It stays bound to the unit that is active.
inline Texture nearestTexture(const Functions& gl, GLenum format, int width, int height, int levels = 1) {
  Texture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, levels, format, width, height);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  return texture;
}

}  // namespace telar::gl
