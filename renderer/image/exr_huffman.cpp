#include "image/exr_huffman.h"

#include <algorithm>
#include <array>

namespace telar::image {
namespace {

constexpr std::uint32_t SYMBOLS = (1 << 16) + 1;  // the last one repeats
constexpr unsigned LENGTH_MAX = 58, SHORT_ZEROS = 59, LONG_ZEROS = 63;
constexpr unsigned TABLE_BITS = 12;
constexpr std::size_t HUFFMAN_HEADER_BYTES = 20;

/// Bits from the highest of each byte down; 0 behind the end.
class Bits {
 public:
  explicit Bits(Bytes bytes) : bytes_(bytes) {}

  std::uint64_t position() const { return position_; }
  void skip(unsigned count) { position_ += count; }

  /// The next `count` bits, at most 16.
  std::uint32_t peek(unsigned count) const {
    const auto first = static_cast<std::size_t>(position_ / 8);
    const std::uint32_t three = at(first) << 16 | at(first + 1) << 8 | at(first + 2);
    return three >> (24 - position_ % 8 - count) & ((1u << count) - 1);
  }
  std::uint32_t take(unsigned count) {
    const std::uint32_t bits = peek(count);
    skip(count);
    return bits;
  }

 private:
  std::uint32_t at(std::size_t i) const { return i < bytes_.size() ? data(bytes_)[i] : 0; }

  Bytes bytes_;
  std::uint64_t position_ = 0;
};

/// Canonical codes: those of one length follow each other, and longer ones are numerically below.
class Codes {
 public:
  /// False where the table is damaged.
  bool read(Bits& bits, std::uint64_t bitsMost, std::uint32_t least, std::uint32_t most) {
    std::vector<std::uint8_t> lengths(SYMBOLS);
    for (std::uint32_t symbol = least; symbol <= most;) {
      if (bits.position() >= bitsMost) return false;
      const std::uint32_t length = bits.take(6);
      if (length < SHORT_ZEROS) {
        lengths[symbol++] = static_cast<std::uint8_t>(length);
        continue;
      }
      const std::uint32_t zeros = length == LONG_ZEROS ? bits.take(8) + 6 : length - SHORT_ZEROS + 2;
      if (zeros > most + 1 - symbol) return false;
      symbol += zeros;
    }
    return order(lengths);
  }

  /// The next symbol; SYMBOLS where there is none.
  std::uint32_t next(Bits& bits) const {
    const Short found = table_[bits.peek(TABLE_BITS)];
    if (found.length) {
      bits.skip(found.length);
      return found.symbol;
    }
    std::uint64_t code = bits.take(TABLE_BITS);
    for (unsigned length = TABLE_BITS + 1; length <= LENGTH_MAX; ++length) {
      code = code << 1 | bits.take(1);
      if (code >= first_[length] && code - first_[length] < count_[length])
        return symbols_[start_[length] + static_cast<std::size_t>(code - first_[length])];
    }
    return SYMBOLS;
  }

 private:
  struct Short {
    std::uint32_t symbol = 0;
    unsigned length = 0;
  };

  bool order(const std::vector<std::uint8_t>& lengths) {
    for (const std::uint8_t length : lengths) ++count_[length];
    count_[0] = 0;
    std::uint64_t code = 0;
    for (unsigned length = LENGTH_MAX; length > 0; --length) {
      first_[length] = code;
      if (count_[length] && code + count_[length] > std::uint64_t{1} << length) return false;
      code = (code + count_[length]) >> 1;
    }
    for (unsigned length = 1; length < LENGTH_MAX; ++length) start_[length + 1] = start_[length] + count_[length];
    symbols_.resize(start_[LENGTH_MAX] + count_[LENGTH_MAX]);
    std::array<std::size_t, LENGTH_MAX + 1> at = start_;
    for (std::uint32_t symbol = 0; symbol < SYMBOLS; ++symbol)
      if (lengths[symbol]) symbols_[at[lengths[symbol]]++] = symbol;
    for (unsigned length = 1; length <= TABLE_BITS; ++length) {
      const unsigned copies = 1u << (TABLE_BITS - length);
      for (std::size_t i = 0; i < count_[length]; ++i) {
        const auto begin = table_.begin() + static_cast<std::ptrdiff_t>((first_[length] + i) * copies);
        std::fill_n(begin, copies, Short{symbols_[start_[length] + i], length});
      }
    }
    return true;
  }

  std::array<std::uint64_t, LENGTH_MAX + 1> first_{};
  std::array<std::size_t, LENGTH_MAX + 1> count_{}, start_{};
  std::vector<std::uint32_t> symbols_;
  std::vector<Short> table_ = std::vector<Short>(1u << TABLE_BITS);
};

}  // namespace

bool decodeExrHuffman(Bytes packed, std::vector<std::uint16_t>& out) {
  if (packed.size() < HUFFMAN_HEADER_BYTES) return out.empty();
  const std::uint32_t least = le32(data(packed)), most = le32(data(packed) + 4), bitCount = le32(data(packed) + 12);
  if (least > most || most >= SYMBOLS) return false;
  const Bytes rest = packed.subspan(HUFFMAN_HEADER_BYTES);
  Bits tableBits(rest);
  Codes codes;
  if (!codes.read(tableBits, std::uint64_t{rest.size()} * 8, least, most)) return false;
  const std::uint64_t tableBytes = (tableBits.position() + 7) / 8;
  if (tableBytes > rest.size() || (std::uint64_t{bitCount} + 7) / 8 > rest.size() - tableBytes) return false;

  Bits bits(rest.subspan(static_cast<std::size_t>(tableBytes)));
  for (std::size_t count = 0; count < out.size();) {
    const std::uint32_t symbol = codes.next(bits);
    if (symbol == SYMBOLS) return false;
    if (symbol != most) {
      out[count++] = static_cast<std::uint16_t>(symbol);
    } else {
      const std::uint32_t times = bits.take(8);
      if (count == 0 || times == 0 || times > out.size() - count) return false;
      std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(count), times, out[count - 1]);
      count += times;
    }
    if (bits.position() > bitCount) return false;
  }
  return true;
}

}  // namespace telar::image
