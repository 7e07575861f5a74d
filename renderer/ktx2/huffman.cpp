#include "ktx2/huffman.h"

namespace telar::ktx2 {
namespace {

constexpr unsigned SYMBOL_COUNT_BITS = 14;
constexpr unsigned LENGTH_SYMBOLS = 21;

// Symbols of the code lengths' own code: lengths themselves up to 16, then runs.
constexpr std::uint32_t SHORT_ZEROS = 17, LONG_ZEROS = 18, SHORT_REPEAT = 19;

constexpr std::uint8_t LENGTH_ORDER[LENGTH_SYMBOLS] = {17, 18, 19, 20, 0,  8, 7,  9, 6,  10, 5,
                                                       11, 4,  12, 3,  13, 2, 14, 1, 15, 16};

HuffmanTable readLengthTable(BitReader& from) {
  const std::uint32_t given = from.bits(5);
  if (given < 1 || given > LENGTH_SYMBOLS) throw corrupt("a Huffman table has a wrong number of code lengths");
  std::array<std::uint8_t, LENGTH_SYMBOLS> lengths{};
  for (std::uint32_t i = 0; i < given; ++i) lengths[LENGTH_ORDER[i]] = static_cast<std::uint8_t>(from.bits(3));
  return HuffmanTable(lengths);
}

std::uint32_t runLength(std::uint32_t symbol, BitReader& from) {
  if (symbol == SHORT_ZEROS) return from.bits(3) + 3;
  if (symbol == LONG_ZEROS) return from.bits(7) + 11;
  return symbol == SHORT_REPEAT ? from.bits(2) + 3 : from.bits(7) + 7;
}

}  // namespace

HuffmanTable::HuffmanTable(std::span<const std::uint8_t> lengths) {
  std::uint32_t used = 0;
  for (const std::uint8_t length : lengths) {
    if (length == 0) continue;
    ++countOfLength_[length];
    ++used;
  }
  // Codes that are left of those of one bit more; exact, since no count exceeds 2^14.
  std::int64_t left = 1;
  for (unsigned bits = 1; bits <= CODE_BITS_MAX; ++bits) {
    left = left * 2 - countOfLength_[bits];
    if (left < 0) throw corrupt("a Huffman table has more codes than fit");
  }
  if (left > 0 && used > 1) throw corrupt("a Huffman table leaves codes without a symbol");
  std::array<std::uint32_t, CODE_BITS_MAX + 2> next{};
  for (unsigned bits = 1; bits <= CODE_BITS_MAX; ++bits) next[bits + 1] = next[bits] + countOfLength_[bits];
  symbols_.resize(used);
  for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
    if (lengths[symbol] != 0) symbols_[next[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
  }
}

HuffmanTable HuffmanTable::read(BitReader& from) {
  const std::uint32_t count = from.bits(SYMBOL_COUNT_BITS);
  if (count == 0) return {};
  const HuffmanTable lengthTable = readLengthTable(from);
  std::vector<std::uint8_t> lengths;
  lengths.reserve(count);
  while (lengths.size() < count) {
    const std::uint32_t symbol = lengthTable.decode(from);
    if (symbol <= CODE_BITS_MAX) {
      lengths.push_back(static_cast<std::uint8_t>(symbol));
      continue;
    }
    const bool zeros = symbol == SHORT_ZEROS || symbol == LONG_ZEROS;
    if (!zeros && (lengths.empty() || lengths.back() == 0)) throw corrupt("a Huffman table repeats nothing");
    const std::uint32_t run = runLength(symbol, from);
    if (run > count - lengths.size()) throw corrupt("a Huffman table has too many symbols");
    lengths.insert(lengths.end(), run, zeros ? std::uint8_t{0} : lengths.back());
  }
  return HuffmanTable(lengths);
}

std::uint32_t HuffmanTable::decode(BitReader& from) const {
  std::uint32_t code = 0, first = 0, index = 0;
  for (unsigned bits = 1; bits <= CODE_BITS_MAX; ++bits) {
    code |= from.bit();
    const std::uint32_t count = countOfLength_[bits];
    if (code < first + count) return symbols_[index + code - first];
    index += count;
    first = (first + count) << 1;
    code <<= 1;
  }
  throw corrupt("a compressed stream holds a code that its Huffman table does not have");
}

}  // namespace telar::ktx2
