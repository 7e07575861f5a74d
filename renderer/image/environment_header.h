#pragma once
#include "image/oiio_bridge.h"

namespace telar::image {

struct EnvironmentHeader {
  EnvironmentFormat format;
  std::uint32_t width = 0, height = 0;
};

/// Size of a .hdr or .exr file, told apart by magic bytes; read without a library, so that limits hold before one sees
/// the file. @throws Error{E_ENVIRONMENT_FORMAT, E_ENVIRONMENT_CORRUPT}
EnvironmentHeader readEnvironmentHeader(Bytes file);

}  // namespace telar::image
