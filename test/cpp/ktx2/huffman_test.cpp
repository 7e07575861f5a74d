#include "ktx2/huffman.h"

#include <gtest/gtest.h>

#include "expect_error.h"

namespace telar::test {
namespace {

using ktx2::BitReader;
using ktx2::HuffmanTable;

/// Bits, lowest first, as bytes.
std::vector<std::byte> packed(const std::string& bits) {
  std::vector<std::byte> out(bits.size() / 8 + 1);
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (bits[i] == '1') out[i / 8] |= std::byte{1} << static_cast<int>(i % 8);
  }
  return out;
}

/// `count` bits of a number, lowest first.
std::string number(unsigned value, unsigned count) {
  std::string out;
  for (unsigned i = 0; i < count; ++i) out += value >> i & 1 ? '1' : '0';
  return out;
}

HuffmanTable tableOf(const std::vector<std::uint8_t>& lengths) { return HuffmanTable(lengths); }

TEST(Huffman, DecodesCanonicalCodes) {
  // Codes 0, 10, 110, 111 of RFC 1951, first bit first.
  const HuffmanTable table = tableOf({2, 1, 3, 3});
  const auto bytes = packed(
      "0"
      "10"
      "110"
      "111");
  BitReader from(bytes);
  EXPECT_EQ(table.decode(from), 1u);
  EXPECT_EQ(table.decode(from), 0u);
  EXPECT_EQ(table.decode(from), 2u);
  EXPECT_EQ(table.decode(from), 3u);
}

TEST(Huffman, WrongLengthsAreRefused) {
  EXPECT_ERROR(tableOf({1, 1, 1}), "E_IMAGE_CORRUPT") << "more codes than fit";
  EXPECT_ERROR(tableOf({2, 2, 2}), "E_IMAGE_CORRUPT") << "a code is left";
  EXPECT_ERROR(tableOf(std::vector<std::uint8_t>(16383, 1)), "E_IMAGE_CORRUPT");
  EXPECT_NO_THROW(tableOf({0, 7, 0})) << "a single symbol may waste codes";
  EXPECT_TRUE(tableOf({0, 0}).empty());
}

TEST(Huffman, ACodeWithoutASymbolIsRefused) {
  const auto ones = packed(std::string(64, '1'));
  BitReader from(ones);
  EXPECT_ERROR(tableOf({1}).decode(from), "E_IMAGE_CORRUPT");
  BitReader again(ones);
  EXPECT_ERROR(HuffmanTable().decode(again), "E_IMAGE_CORRUPT");
}

TEST(Huffman, TheEndIsAnError) {
  BitReader from({});
  EXPECT_ERROR(tableOf({1, 1}).decode(from), "E_IMAGE_CORRUPT");
}

/// A table in a stream whose lengths' own code knows the symbols 1 (code 0) and 20 (code 1).
std::string header(unsigned symbols) {
  std::string out = number(symbols, 14) + number(21, 5);
  for (const int symbol : {17, 18, 19, 20, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15, 16}) {
    out += number(symbol == 1 || symbol == 20 ? 1 : 0, 3);
  }
  return out;
}

void read(const std::string& bits) {
  const auto bytes = packed(bits);
  BitReader from(bytes);
  HuffmanTable::read(from);
}

TEST(Huffman, TablesInStreams) {
  EXPECT_NO_THROW(read(header(2) + "00"));
  EXPECT_NO_THROW(read(number(0, 14))) << "no symbols";
  EXPECT_ERROR(read(header(2) + "1" + number(0, 7)), "E_IMAGE_CORRUPT") << "nothing to repeat";
  EXPECT_ERROR(read(header(4) +
                    "0"
                    "1" +
                    number(0, 7)),
               "E_IMAGE_CORRUPT")
      << "a run of 7 where 3 are left";
  EXPECT_ERROR(read(header(40)), "E_IMAGE_CORRUPT") << "cut";
  EXPECT_ERROR(read(number(3, 14) + number(0, 5)), "E_IMAGE_CORRUPT") << "no lengths for the lengths";
  EXPECT_ERROR(read(number(3, 14) + number(22, 5)), "E_IMAGE_CORRUPT") << "too many";
}

}  // namespace
}  // namespace telar::test
