#pragma once
#include <cstdint>
#include <cstring>
#include <span>

#include "ktx2/errors.h"

namespace telar::ktx2 {

using Bytes = std::span<const std::byte>;

inline const std::uint8_t* data(Bytes bytes) { return reinterpret_cast<const std::uint8_t*>(bytes.data()); }

/// Reads little-endian integers one after the other; past the end is E_IMAGE_CORRUPT.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(read(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(read(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(read(4)); }
  std::uint64_t u64() { return read(8); }
  Bytes take(std::uint64_t count) {
    if (count > bytes_.size() - at_) throw corrupt("the file ends too early");
    const Bytes out = bytes_.subspan(at_, count);
    at_ += count;
    return out;
  }

 private:
  std::uint64_t read(unsigned count) {
    const std::uint8_t* from = data(take(count));
    std::uint64_t out = 0;
    for (unsigned i = 0; i < count; ++i) out |= std::uint64_t{from[i]} << (8 * i);
    return out;
  }

  Bytes bytes_;
  std::size_t at_ = 0;
};

/// The bytes of `count` at `offset` of the file; a range that leaves it is E_IMAGE_CORRUPT.
inline Bytes rangeOf(Bytes file, std::uint64_t offset, std::uint64_t count) {
  if (offset > file.size() || count > file.size() - offset) throw corrupt("a part of it reaches past the end");
  return file.subspan(offset, count);
}

}  // namespace telar::ktx2
