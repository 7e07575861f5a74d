#pragma once
#include <string>

#include "image/bytes.h"
#include "telar/error.h"

namespace telar::image {

enum class EnvironmentFormat { kHdr, kExr };

struct EnvironmentHeader {
  EnvironmentFormat format;
  std::uint32_t width = 0, height = 0;
  std::size_t pixels = 0;  ///< where they begin, of .hdr
};

/// Size of a .hdr or .exr file, told apart by magic bytes; read without a library, so that limits hold before one sees
/// the file. @throws Error{E_ENVIRONMENT_FORMAT, E_ENVIRONMENT_CORRUPT}
EnvironmentHeader readEnvironmentHeader(Bytes file);

/// E_ENVIRONMENT_FORMAT: "the environment <what>; save it as an equirectangular .hdr or .exr map".
[[nodiscard]] Error unsupportedEnvironment(const std::string& what);

/// E_ENVIRONMENT_CORRUPT: "the environment <what>; save it again".
[[nodiscard]] Error damagedEnvironment(const std::string& what, std::size_t offset);

}  // namespace telar::image
