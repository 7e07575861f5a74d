#include <array>

#include "image/sample_files.h"

using telar::OutputOptions;
using Format = OutputOptions::Format;
using namespace sample;

namespace {

telar::Image8 decoded(const File& file) { return telar::decodeImage(file, {}, {}); }

/// One row: a filter byte and the row's bytes, in one stored deflate block.
File pngOf(int width, int depth, int colorType, const File& row, const File& extra = {}) {
  File deflate = bytes(std::string("\x78\x01\x01", 3));
  const std::size_t n = row.size() + 1;
  for (const std::size_t v : {n & 255, n >> 8, ~n & 255, (~n >> 8) & 255}) deflate.push_back(std::byte(v));
  deflate.push_back(std::byte{0});
  deflate.insert(deflate.end(), row.begin(), row.end());
  std::uint32_t a = 1, b = 1;  // Adler-32 behind the filter byte
  for (const std::byte v : row) a = (a + std::uint32_t(v)) % 65521, b = (b + a) % 65521;
  return concat({pngHeader(std::uint32_t(width), 1, depth, colorType), extra,
                 pngChunk("IDAT", concat({deflate, be32(b << 16 | a)})), pngChunk("IEND", {})});
}

std::array<int, 4> texel(const telar::Image8& image, std::size_t i) {
  return {image.pixels[4 * i], image.pixels[4 * i + 1], image.pixels[4 * i + 2], image.pixels[4 * i + 3]};
}

using Texel = std::array<int, 4>;

}  // namespace

TEST(Decode, ExpandsGreyBits) {
  const auto image = decoded(pngOf(8, 1, 0, bytes("\xa5")));
  for (std::size_t i = 0; i < 8; ++i) {
    const int v = 0xa5 >> (7 - i) & 1 ? 255 : 0;
    EXPECT_EQ(texel(image, i), (Texel{v, v, v, 255})) << i;
  }
  const auto fourBit = decoded(pngOf(2, 4, 0, bytes("\x3c")));
  EXPECT_EQ(texel(fourBit, 0), (Texel{51, 51, 51, 255}));
  EXPECT_EQ(texel(fourBit, 1), (Texel{204, 204, 204, 255}));
}

TEST(Decode, TakesTheHighByteOf16Bit) {
  const auto image = decoded(pngOf(1, 16, 2, bytes("\x12\xff\x34\x80\x56\x7f")));
  EXPECT_EQ(texel(image, 0), (Texel{0x12, 0x34, 0x56, 255}));
}

TEST(Decode, ExpandsPaletteWithTransparency) {
  const File extra = concat({pngChunk("PLTE", bytes("abcdef")), pngChunk("tRNS", bytes("\x07"))});
  const auto image = decoded(pngOf(2, 8, 3, bytes(std::string("\x01\x00", 2)), extra));
  EXPECT_EQ(texel(image, 0), (Texel{'d', 'e', 'f', 255}));
  EXPECT_EQ(texel(image, 1), (Texel{'a', 'b', 'c', 7}));
}

TEST(Decode, GreyWithAlpha) {
  EXPECT_EQ(texel(decoded(pngOf(1, 8, 4, bytes("\x20\x40"))), 0), (Texel{0x20, 0x20, 0x20, 0x40}));
}

TEST(Decode, RefusesAPaletteIndexOutsideThePalette) {
  // libpng paints black and says nothing unless asked; the texel must at least be defined.
  const auto image = decoded(pngOf(1, 8, 3, bytes("\x09"), pngChunk("PLTE", bytes("abc"))));
  EXPECT_EQ(texel(image, 0), (Texel{0, 0, 0, 255}));
}

TEST(Decode, HeaderNamesTypeAndSize) {
  const auto frame = frame8(31, 17);
  for (const auto& [format, type] :
       {std::pair{Format::kPng, "image/png"}, {Format::kJpeg, "image/jpeg"}, {Format::kWebp, "image/webp"}}) {
    const auto header = telar::readImageHeader(encoded(frame, format), {});
    EXPECT_EQ(header.width, 31u);
    EXPECT_EQ(header.height, 17u);
    EXPECT_EQ(header.mimeType, type);
  }
}

TEST(Decode, LimitsHoldBeforeDecoding) {
  const File file = encoded(frame8(40, 30), Format::kPng);
  telar::Limits limits;
  limits.imageDimension = 39;
  EXPECT_EQ(codeOf([&] { telar::decodeImage(file, limits, {}); }), "L_IMAGE_DIMENSION");
  EXPECT_EQ(codeOf([&] { telar::readImageHeader(file, limits); }), "L_IMAGE_DIMENSION");
  limits = {};
  limits.imagePixels = 1199;
  EXPECT_EQ(codeOf([&] { telar::decodeImage(file, limits, {}); }), "L_IMAGE_PIXELS");
  limits = {};
  limits.imageBytes = 4799;
  EXPECT_EQ(codeOf([&] { telar::decodeImage(file, limits, {}); }), "L_IMAGE_BYTES");
  limits.imageBytes = 4800;
  EXPECT_EQ(codeOf([&] { telar::decodeImage(file, limits, {}); }), "");
}

TEST(Decode, StopsWhenCancelled) {
  telar::CancelToken cancel;
  cancel.cancel();
  for (const Format format : {Format::kPng, Format::kJpeg, Format::kWebp}) {
    const File file = encoded(frame8(64, 64), format);
    EXPECT_EQ(codeOf([&] { telar::decodeImage(file, {}, cancel); }), "X_CANCELLED");
  }
}
