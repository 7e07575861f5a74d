#include "ktx2/container.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "ktx2/ktx2_files.h"

namespace telar::test {
namespace {

// Offsets in the header.
constexpr std::size_t WIDTH = 20, LEVEL_COUNT = 40, DESCRIPTOR_OFFSET = 48, DESCRIPTOR_BYTES = 52, GLOBAL_OFFSET = 64,
                      GLOBAL_BYTES = 72, LEVEL_OFFSET = 80, LEVEL_BYTES = 88, LEVEL_UNCOMPRESSED = 96;

File changed(std::size_t offset, std::uint64_t value, unsigned bytes) {
  File file = oneBlock().write();
  put(file, offset, value, bytes);
  return file;
}

TEST(Container, ARightFileIsRead) {
  const File file = oneBlock().write();
  const auto container = ktx2::readContainer(file, {});
  EXPECT_EQ(container.width, 4u);
  EXPECT_EQ(container.levels.size(), 1u);
  EXPECT_EQ(container.coding, TexelCoding::kSrgb);
  EXPECT_EQ(ktx2::formatName(container), "KTX2 UASTC");
}

TEST(Container, ShapesThatAreNotDrawnAreNamed) {
  const auto message = [](auto change) {
    Ktx2Fields fields = oneBlock();
    change(fields);
    EXPECT_EQ(codeOf(fields.write()), "E_IMAGE_FORMAT");
    return messageOf(fields.write());
  };
  EXPECT_NE(message([](auto& f) { f.height = 0; }).find("one-dimensional"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.depth = 2; }).find("3D texture"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.layers = 3; }).find("array of 3 layers"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.faces = 6; }).find("cube map"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.vkFormat = 135; }).find("BC2, which three.js 0.187 refuses"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.vkFormat = 159; }).find("ASTC in blocks other"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.vkFormat = 1000054001; }).find("PVRTC, which telar does not"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.vkFormat = 9999; }).find("VkFormat 9999"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.model = 167; }).find("colour model 167"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.supercompression = 3; }).find("zlib"), std::string::npos);
  EXPECT_NE(message([](auto& f) { f.supercompression = 0x10000; }).find("supercompression 65536"), std::string::npos);
}

TEST(Container, AnArrayOfOneLayerIsATexture) {
  Ktx2Fields fields = oneBlock();
  fields.layers = 1;
  fields.levelCount = 0;  // one level, as three.js reads it
  EXPECT_EQ(codeOf(fields.write()), "");
}

TEST(Container, ContradictionsAreCorrupt) {
  const auto code = [](auto change) {
    Ktx2Fields fields = oneBlock();
    change(fields);
    return codeOf(fields.write());
  };
  EXPECT_EQ(code([](auto& f) { f.faces = 7; }), "E_IMAGE_CORRUPT");
  EXPECT_EQ(code([](auto& f) { f.width = 0; }), "E_IMAGE_CORRUPT");
  EXPECT_EQ(code([](auto& f) { f.levelCount = 4; }), "E_IMAGE_CORRUPT");
  EXPECT_EQ(code([](auto& f) { f.levelCount = 2; }), "E_IMAGE_CORRUPT") << "its index does not hold so many";
  EXPECT_EQ(code([](auto& f) { f.supercompression = 1; }), "E_IMAGE_CORRUPT") << "UASTC is not BasisLZ";
  EXPECT_EQ(code([](auto& f) { f.model = 163; }), "E_IMAGE_CORRUPT") << "ETC1S is BasisLZ";
  EXPECT_EQ(code([](auto& f) { f.vkFormat = 37, f.supercompression = 1; }), "E_IMAGE_CORRUPT");
  EXPECT_EQ(code([](auto& f) { f.levels[0].uncompressed = 17; }), "E_IMAGE_CORRUPT");
  EXPECT_EQ(code([](auto& f) { f.width = 5; }), "E_IMAGE_CORRUPT") << "two blocks are needed";
}

TEST(Container, LyingOffsetsAndSizes) {
  for (const std::uint64_t value : {std::uint64_t{0x7fffffff}, ~std::uint64_t{0}, std::uint64_t{0x80000000'80000000}}) {
    EXPECT_EQ(codeOf(changed(LEVEL_OFFSET, value, 8)), "E_IMAGE_CORRUPT");
    EXPECT_EQ(codeOf(changed(LEVEL_BYTES, value, 8)), "E_IMAGE_CORRUPT");
    EXPECT_EQ(codeOf(changed(LEVEL_UNCOMPRESSED, value, 8)), "E_IMAGE_CORRUPT");
    EXPECT_EQ(codeOf(changed(DESCRIPTOR_OFFSET, value, 4)), "E_IMAGE_CORRUPT");
    EXPECT_EQ(codeOf(changed(DESCRIPTOR_BYTES, value, 4)), "E_IMAGE_CORRUPT");
    EXPECT_EQ(codeOf(changed(LEVEL_COUNT, value, 4)), "E_IMAGE_CORRUPT");
    File etc1s = etc1sFile();
    put(etc1s, GLOBAL_OFFSET, value, 8);
    EXPECT_EQ(codeOf(etc1s), "E_IMAGE_CORRUPT");
    etc1s = etc1sFile();
    put(etc1s, GLOBAL_BYTES, value, 8);
    EXPECT_EQ(codeOf(etc1s), "E_IMAGE_CORRUPT");
  }
}

TEST(Container, SidesAreLimitedBeforeAnythingElse) {
  EXPECT_EQ(codeOf(changed(WIDTH, 8193, 4)), "L_IMAGE_DIMENSION");
  EXPECT_EQ(codeOf(changed(WIDTH, 0xffffffff, 4)), "L_IMAGE_DIMENSION");
  Limits limits;
  limits.imageDimension = ~std::uint64_t{0};
  const File huge = changed(WIDTH, 0xffffffff, 4);
  EXPECT_ERROR(ktx2::readContainer(huge, limits), "E_IMAGE_CORRUPT") << "even where the limit is off";
}

TEST(Container, CutAtEveryByte) {
  for (const File& file : {oneBlock().write(), etc1sFile()}) {
    for (std::size_t size = 0; size < file.size(); ++size) {
      const File cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
      ASSERT_EQ(codeOf(cut), "E_IMAGE_CORRUPT") << size << " of " << file.size();
    }
  }
}

}  // namespace
}  // namespace telar::test
