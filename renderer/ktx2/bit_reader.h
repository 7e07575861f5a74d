#pragma once
#include "ktx2/byte_reader.h"

namespace telar::ktx2 {

/// Reads bits from the least significant one of each byte on, as BasisLZ streams are written. Past the end is
/// E_IMAGE_CORRUPT.
class BitReader {
 public:
  explicit BitReader(Bytes bytes) : bytes_(data(bytes)), bits_(std::uint64_t{bytes.size()} * 8) {}

  std::uint32_t bit() {
    if (at_ == bits_) throw corrupt("a compressed stream ends too early");
    const std::uint32_t out = bytes_[at_ >> 3] >> (at_ & 7) & 1u;
    ++at_;
    return out;
  }

  /// @param count 0..32
  std::uint32_t bits(unsigned count) {
    std::uint32_t out = 0;
    for (unsigned i = 0; i < count; ++i) out |= bit() << i;
    return out;
  }

  /// A number in groups of `groupBits` bits, lowest first, each followed by whether there is another group.
  std::uint32_t groups(unsigned groupBits) {
    std::uint32_t out = 0;
    for (unsigned shift = 0; shift < 32; shift += groupBits) {
      out |= bits(groupBits) << shift;
      if (!bit()) return out;
    }
    throw corrupt("a compressed stream holds a number that is too long");
  }

 private:
  const std::uint8_t* bytes_;
  std::uint64_t bits_;
  std::uint64_t at_ = 0;
};

}  // namespace telar::ktx2
