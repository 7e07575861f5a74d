#include "ktx2/block_formats.h"

#include <gtest/gtest.h>

#include "ktx2/ktx2_files.h"

namespace telar::test {
namespace {

constexpr std::uint32_t BC1 = 132, BC4 = 139, BC7 = 146, EAC_R = 153, ASTC_4X4 = 158, ASTC_6X6 = 166;

/// A file of one level of `bytes` bytes.
Ktx2Fields blocks(std::uint32_t vkFormat, std::uint32_t width, std::uint32_t height, std::size_t bytes) {
  Ktx2Fields fields = oneBlock();
  fields.vkFormat = vkFormat;
  fields.model = 1;
  fields.width = width;
  fields.height = height;
  fields.levels = {{File(bytes, std::byte{7}), bytes}};
  return fields;
}

TEST(BlockFormats, BlocksAreKeptAsTheyAre) {
  const auto image = ktx2::decode(blocks(BC7, 8, 4, 32).write(), {}, {});
  EXPECT_EQ(image.type, TexelType::kBlocks);
  EXPECT_EQ(image.blocks, BlockFormat::kBc7);
  EXPECT_EQ(image.pixels, ZeroedBytes(32, 7));
  EXPECT_EQ(image.format, "KTX2 BC7");
  EXPECT_EQ(image.coding, TexelCoding::kSrgb);
  EXPECT_EQ(ktx2::decode(blocks(BC4, 4, 4, 8).write(), {}, {}).coding, TexelCoding::kLinear);
}

TEST(BlockFormats, ALevelHasAsManyBytesAsItsBlocks) {
  EXPECT_EQ(codeOf(blocks(BC1, 8, 8, 32).write()), "");
  EXPECT_EQ(codeOf(blocks(BC1, 8, 8, 64).write()), "E_IMAGE_CORRUPT");
  EXPECT_EQ(codeOf(blocks(EAC_R, 5, 5, 32).write()), "");
  EXPECT_EQ(codeOf(blocks(ASTC_4X4, 5, 5, 64).write()), "");
  EXPECT_EQ(codeOf(blocks(ASTC_6X6, 6, 7, 32).write()), "");
  EXPECT_EQ(codeOf(blocks(ASTC_6X6, 6, 7, 16).write()), "E_IMAGE_CORRUPT");
  EXPECT_EQ(codeOf(blocks(ASTC_6X6, 8192, 8192, 16).write()), "E_IMAGE_CORRUPT");
}

TEST(BlockFormats, BlocksOfDesktopsHaveSidesOfMultiplesOfFour) {
  EXPECT_EQ(codeOf(blocks(BC1, 6, 8, 32).write()), "E_IMAGE_FORMAT");
  EXPECT_NE(messageOf(blocks(BC1, 6, 8, 32).write()).find("no multiples of 4"), std::string::npos);
}

}  // namespace
}  // namespace telar::test
