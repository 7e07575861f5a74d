#pragma once
#include "gl/functions.h"

namespace telar::gl {

/// How the texture that is bound is read: by these filters, and beyond its edges as its last texels.
inline void setClampedSampling(const Functions& gl, GLenum target, GLenum minFilter, GLenum magFilter) {
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) gl.TexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minFilter));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magFilter));
}

}  // namespace telar::gl
