#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ktx2/decode.h"

namespace telar::test {

using File = std::vector<std::byte>;

/// The fields of a KTX2 file; write() makes the file that they say, right or wrong.
struct Ktx2Fields {
  struct Level {
    File bytes;
    std::uint64_t uncompressed;
  };

  std::uint32_t vkFormat = 0, width = 4, height = 4, depth = 0, layers = 0, faces = 1, levelCount = 1,
                supercompression = 0;
  std::uint8_t model = 166, primaries = 1, transfer = 2;
  std::vector<Level> levels;

  File write() const;
};

/// One block of one colour, as UASTC.
File solidBlock(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a);

/// A right file of one such block.
Ktx2Fields oneBlock();

/// 8 x 4 texels in ETC1S with alpha, as test/fixtures/etc1s.mjs wrote it, and what three.js's transcoder makes of it.
File etc1sFile();
ZeroedBytes etc1sTexels();

/// Writes a little-endian number of `bytes` bytes at an offset.
void put(File& file, std::size_t offset, std::uint64_t value, unsigned bytes);

/// Code of the error that decoding ends with, "" when it does not.
std::string codeOf(const File& file);
/// Its message.
std::string messageOf(const File& file);

}  // namespace telar::test
