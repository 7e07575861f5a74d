#include "ktx2/decode.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include "ktx2/ktx2_files.h"

namespace telar::test {
namespace {

// Parts of etc1sFile().
constexpr std::size_t GLOBAL = 168, ENDPOINT_COUNT = GLOBAL, SELECTOR_COUNT = GLOBAL + 2, ENDPOINT_BYTES = GLOBAL + 4,
                      SELECTOR_BYTES = GLOBAL + 8, TABLE_BYTES = GLOBAL + 12, IMAGE_FLAGS = GLOBAL + 20,
                      SLICE_OFFSET = GLOBAL + 24, SLICE_BYTES = GLOBAL + 28, ALPHA_BYTES = GLOBAL + 36;

std::string codeWith(std::size_t offset, std::uint64_t value, unsigned bytes) {
  File file = etc1sFile();
  put(file, offset, value, bytes);
  return codeOf(file);
}

TEST(Decode, Uastc) {
  const auto image = ktx2::decode(oneBlock().write(), {}, {});
  EXPECT_EQ(image.pixels.size(), 64u);
  EXPECT_EQ(image.pixels[4], 10);
  EXPECT_EQ(image.pixels[7], 40);
  EXPECT_TRUE(image.ownLevels);
}

TEST(Decode, ABlockThatUastcDoesNotKnow) {
  Ktx2Fields fields = oneBlock();
  fields.levels[0].bytes.assign(16, std::byte{69});
  EXPECT_EQ(codeOf(fields.write()), "E_IMAGE_CORRUPT");
}

TEST(Decode, OneLevelIsAsLargeAsItsBlocksMoreAreNot) {
  Ktx2Fields fields = oneBlock();
  fields.width = 3;
  fields.height = 1;
  const auto one = ktx2::decode(fields.write(), {}, {});
  EXPECT_EQ(one.width, 4u);
  EXPECT_EQ(one.height, 4u);
  fields.levelCount = 2;
  fields.levels.push_back({solidBlock(1, 2, 3, 4), 16});
  const auto two = ktx2::decode(fields.write(), {}, {});
  EXPECT_EQ(two.width, 3u);
  EXPECT_EQ(two.height, 1u);
  ASSERT_EQ(two.smallerLevels.size(), 1u);
  EXPECT_EQ(two.smallerLevels[0], (ZeroedBytes{1, 2, 3, 4}));
}

TEST(Decode, Etc1sIsWhatTheClientsTranscoderGives) {
  EXPECT_EQ(ktx2::decode(etc1sFile(), {}, {}).pixels, etc1sTexels());
}

TEST(Decode, Etc1sThatLies) {
  EXPECT_EQ(codeWith(ENDPOINT_COUNT, 0, 2), "E_IMAGE_CORRUPT");
  EXPECT_EQ(codeWith(SELECTOR_COUNT, 0, 2), "E_IMAGE_CORRUPT");
  EXPECT_EQ(codeWith(ENDPOINT_COUNT, 1, 2), "E_IMAGE_CORRUPT") << "a delta leads out of the codebook";
  EXPECT_EQ(codeWith(ENDPOINT_COUNT, 0xffff, 2), "E_IMAGE_CORRUPT") << "the codebook's data ends before";
  EXPECT_EQ(codeWith(SELECTOR_COUNT, 0xffff, 2), "E_IMAGE_CORRUPT");
  for (const std::size_t field :
       {ENDPOINT_BYTES, SELECTOR_BYTES, TABLE_BYTES, SLICE_OFFSET, SLICE_BYTES, ALPHA_BYTES}) {
    EXPECT_EQ(codeWith(field, 0xffffffff, 4), "E_IMAGE_CORRUPT") << field;
  }
  for (const std::size_t field : {ENDPOINT_BYTES, SELECTOR_BYTES, TABLE_BYTES, SLICE_BYTES, ALPHA_BYTES}) {
    EXPECT_EQ(codeWith(field, 0, 4), "E_IMAGE_CORRUPT") << field;
  }
  EXPECT_EQ(codeWith(IMAGE_FLAGS, 2, 4), "E_IMAGE_FORMAT") << "a frame of a video";
}

TEST(Decode, EveryFlippedBitOfEtc1sEndsWell) {
  const File good = etc1sFile();
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    File file = good;
    file[bit / 8] ^= std::byte{1} << static_cast<int>(bit % 8);
    const std::string code = codeOf(file);
    ASSERT_TRUE(code.empty() || code == "E_IMAGE_CORRUPT" || code == "E_IMAGE_FORMAT" || code == "L_IMAGE_DIMENSION")
        << bit << ": " << code;
  }
}

File zstd(const File& bytes) {
  File out(ZSTD_compressBound(bytes.size()));
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
  return out;
}

TEST(Decode, Zstd) {
  Ktx2Fields fields = oneBlock();
  fields.supercompression = 2;
  fields.levels[0].bytes = zstd(fields.levels[0].bytes);
  EXPECT_EQ(ktx2::decode(fields.write(), {}, {}).pixels[4], 10);
  EXPECT_EQ(ktx2::decode(fields.write(), {}, {}).format, "KTX2 UASTC zstd");
  fields.levels[0].bytes = zstd(File(1 << 24));
  EXPECT_EQ(codeOf(fields.write()), "E_IMAGE_CORRUPT") << "a bomb: 16 MiB where 16 bytes are due";
  fields.levels[0].bytes = zstd(File(15));
  EXPECT_EQ(codeOf(fields.write()), "E_IMAGE_CORRUPT") << "a byte too few";
  fields.levels[0].bytes = File(40, std::byte{0x28});
  EXPECT_EQ(codeOf(fields.write()), "E_IMAGE_CORRUPT") << "no frame";
}

}  // namespace
}  // namespace telar::test
