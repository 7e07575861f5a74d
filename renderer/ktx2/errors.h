#pragma once
#include <string>
#include <string_view>

#include "telar/error.h"

namespace telar::ktx2 {

/// E_IMAGE_CORRUPT: the file contradicts itself or the specification.
[[nodiscard]] inline Error corrupt(std::string_view what) {
  return Error("E_IMAGE_CORRUPT", "KTX2 image: " + std::string(what) + "; export the image again");
}

/// E_IMAGE_FORMAT: a file that may be right, and that three.js refuses too: its model is shown without the texture
/// there.
/// @param what continues "the KTX2 image ..."
[[nodiscard]] inline Error refusedByClients(const std::string& what) {
  return Error(
      "E_IMAGE_FORMAT",
      "the KTX2 image " + what + ", which three.js 0.187 refuses as well; use a 2D texture in ETC1S, UASTC or RGBA8");
}

/// E_IMAGE_FORMAT: a file that may be right, of a kind that is not drawn. @param what continues "the KTX2 image ..."
[[nodiscard]] inline Error unsupported(const std::string& what) {
  return Error("E_IMAGE_FORMAT",
               "the KTX2 image " + what + ", which telar does not draw; use a 2D texture in ETC1S, UASTC or RGBA8");
}

}  // namespace telar::ktx2
