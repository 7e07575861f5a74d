#pragma once
#include <string>

#include "gl/functions.h"
#include "telar/error.h"

namespace telar::gl {

/// Every format that telar draws into is promised by ES 3.0 and EXT_color_buffer_float, which a context must have:
/// where a framebuffer is not complete all the same, the driver had no memory for it, and Mesa tells it by no error of
/// its own.
/// @param what noun phrase: "a picture of 8192 x 8192 pixels"
[[noreturn]] inline void failIncomplete(const Functions& gl, const std::string& what) {
  for (int i = 0; i < 32 && gl.GetError() != GL_NO_ERROR; ++i) {
  }
  throw Error("X_GL_MEMORY", "the GL driver has not enough memory for " + what +
                                 "; ask for a smaller picture or use smaller textures");
}

}  // namespace telar::gl
