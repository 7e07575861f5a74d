#pragma once
#include <cstdint>
#include <vector>

#include "image/bytes.h"

namespace telar::image {

/// Whether `packed` is OpenEXR's Huffman code (ImfHuf.cpp) of exactly `out.size()` 16-bit symbols, which are then there.
bool decodeExrHuffman(Bytes packed, std::vector<std::uint16_t>& out);

}  // namespace telar::image
