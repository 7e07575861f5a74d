#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "image/bytes.h"

namespace telar::image {

/// As the attribute "compression" has it.
enum class ExrCompression : std::uint8_t { kNone, kRle, kZips, kZip, kPiz, kPxr24, kB44, kB44a, kDwaa, kDwab };

enum class ExrType : std::uint8_t { kUint, kHalf, kFloat };

constexpr std::uint64_t bytesOf(ExrType type) { return type == ExrType::kHalf ? 2 : 4; }

struct ExrChannel {
  std::string name;
  ExrType type = ExrType::kHalf;
};

struct ExrTiles {
  std::uint32_t width = 0, height = 0;  ///< px of one tile, both above 0
  enum class Levels : std::uint8_t { kOne, kMipmap, kRipmap } levels = Levels::kOne;
  bool roundUp = false;
};

/// What of a part's header says where its pixels are.
struct ExrPart {
  std::int64_t width = 0, height = 0;  ///< px of the data window, above 0
  std::int32_t top = 0;                ///< y of its first row
  ExrCompression compression = ExrCompression::kNone;
  bool isDecreasing = false;  ///< the last rows stand first in the file
  bool isTiled = false, isDeep = false;
  ExrTiles tiles;                    ///< where isTiled
  std::vector<ExrChannel> channels;  ///< by name, as OpenEXR orders them; each has every texel
};

struct ExrFile {
  bool isMultiPart = false;
  std::vector<ExrPart> parts;  ///< one or more
  std::size_t tables = 0;      ///< where the tables of chunks begin
};

/// Headers of a .exr file. An attribute that OpenEXR would read with another length than the file says is refused: both
/// have to see the same header. @throws Error{E_ENVIRONMENT_FORMAT, E_ENVIRONMENT_CORRUPT}
ExrFile readExrHeader(Bytes file);

}  // namespace telar::image
