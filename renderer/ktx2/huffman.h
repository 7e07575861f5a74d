#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ktx2/bit_reader.h"

namespace telar::ktx2 {

/// A canonical Huffman code, as Deflate builds it from the lengths of the codes.
class HuffmanTable {
 public:
  static constexpr unsigned CODE_BITS_MAX = 16;

  /// No symbols: reading one is an error.
  HuffmanTable() = default;

  /// @param lengths by symbol, in bits, 0 = the symbol is not used. A code that is not complete is refused unless it
  /// has a single symbol. @throws Error{E_IMAGE_CORRUPT}
  explicit HuffmanTable(std::span<const std::uint8_t> lengths);

  /// A table as it stands in a BasisLZ stream. src: KTX 2.0, appendix "BasisLZ/ETC1S Bitstream", "Compressed Huffman
  /// Tables". @throws Error{E_IMAGE_CORRUPT}
  static HuffmanTable read(BitReader& from);

  bool empty() const { return symbols_.empty(); }

  /// The next symbol. @throws Error{E_IMAGE_CORRUPT}
  std::uint32_t decode(BitReader& from) const;

 private:
  std::array<std::uint16_t, CODE_BITS_MAX + 1> countOfLength_{};
  std::vector<std::uint16_t> symbols_;  ///< in the order of their codes
};

}  // namespace telar::ktx2
