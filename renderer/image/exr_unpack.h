#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "image/bytes.h"

namespace telar::image {

/// Whether `packed` is a zlib stream that gives exactly `out.size()` bytes, which are then there.
bool inflatesTo(Bytes packed, std::span<std::byte> out);

/// A stream of deflate grows by less than this: what claims more is refused before memory is taken for it.
constexpr std::uint64_t INFLATE_MOST = 1032;

/// Whether `packed`, runs as OpenEXR writes them, gives exactly `expected` bytes.
bool runsGive(Bytes packed, std::uint64_t expected);

}  // namespace telar::image
