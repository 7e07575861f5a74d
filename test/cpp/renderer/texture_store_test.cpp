#include "pass/texture/texture_store.h"

#include <gtest/gtest.h>

#include <bit>

#include "gl/context.h"

namespace telar::texture_store_test {
namespace {

using pass::levelsBeyond;
using pass::StoredTexture;
using pass::TextureStore;

class TextureStoreTest : public testing::Test {
 protected:
  TextureStoreTest() : context(gl::Context::create(Backend::kAuto)), store(*context) {}

  /// Of one byte throughout, but for the first texel, which no level loses before the last.
  static Image8 image(std::uint32_t side, std::uint8_t value) {
    Image8 out{side, side, ZeroedBytes(std::size_t{4} * side * side, value)};
    out.pixels[0] = static_cast<std::uint8_t>(255 - value);
    return out;
  }

  std::vector<std::uint8_t> levels(const StoredTexture& stored) const {
    const gl::Functions& gl = context->gl();
    const gl::Framebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    std::vector<std::uint8_t> all;
    for (int level = 0; level < stored.storage.levels; ++level) {
      const int side = std::max(1, stored.storage.width >> level);
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, stored.texture.get(), level);
      const std::size_t before = all.size();
      all.resize(before + std::size_t{4} * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
      gl.ReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, &all[before]);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    context->check("levels");
    return all;
  }

  std::unique_ptr<gl::Context> context;
  TextureStore store;
};

TEST_F(TextureStoreTest, AKeptTextureIsFilledWholeWithTheNextImage) {
  for (const bool srgb : {false, true}) {
    for (const std::uint32_t side : {64u, 100u}) {
      StoredTexture first = store.upload(image(side, 200), srgb);
      const GLuint name = first.texture.get();
      const auto old = levels(first);
      store.keep(std::move(first));
      EXPECT_EQ(store.keptCount(), 1);
      const StoredTexture again = store.upload(image(side, 30), srgb);
      EXPECT_EQ(again.texture.get(), name) << "it is the same one";
      const StoredTexture fresh = store.upload(image(side, 30), srgb);
      EXPECT_NE(fresh.texture.get(), name);
      EXPECT_EQ(levels(again), levels(fresh));
      EXPECT_NE(levels(again), old) << "planted fault: texels of before";
    }
  }
}

TEST_F(TextureStoreTest, TheLargestLevelAloneIsThatOfTheWhole) {
  for (const bool srgb : {false, true}) {
    const StoredTexture largest = store.uploadLargest(image(100, 30), srgb);
    auto whole = levels(store.upload(image(100, 30), srgb));
    whole.resize(std::size_t{4} * 100 * 100);
    EXPECT_EQ(levels(largest), whole);
  }
  Image8 own = image(64, 30);
  own.ownLevels = true;
  own.smallerLevels.push_back(image(32, 70).pixels);
  EXPECT_EQ(levels(store.uploadLargest(own, false)), levels(store.upload(own, false))) << "the file's levels";
}

TEST_F(TextureStoreTest, AnotherSizeOrCodingIsANewTexture) {
  StoredTexture first = store.upload(image(64, 200), false);
  const GLuint name = first.texture.get();
  store.keep(std::move(first));
  const StoredTexture smaller = store.upload(image(32, 200), false);
  EXPECT_NE(smaller.texture.get(), name);
  const StoredTexture coded = store.upload(image(64, 200), true);
  EXPECT_EQ(coded.storage.format, static_cast<GLenum>(GL_SRGB8_ALPHA8));
  EXPECT_EQ(store.keptCount(), 1) << "models in turn find theirs";
}

TEST_F(TextureStoreTest, BeyondWhatStaysAMissLetsGoOfAsMuchAsItTakes) {
  constexpr std::size_t BYTES = std::size_t{1024} * 1024 * 16 / 3;
  constexpr int STAYING = static_cast<int>(TextureStore::STAYING_BYTES / BYTES);
  std::vector<StoredTexture> used;
  for (int i = 0; i < STAYING + 3; ++i) used.push_back(store.upload(image(1024, 1), false));
  for (StoredTexture& texture : used) store.keep(std::move(texture));
  EXPECT_EQ(store.keptCount(), STAYING + 3);
  const StoredTexture first = store.upload(image(1024, 1), true);
  EXPECT_EQ(store.keptCount(), STAYING + 2);
  const StoredTexture larger = store.upload(image(2048, 1), true);
  EXPECT_EQ(store.keptCount(), STAYING);
}

TEST_F(TextureStoreTest, LevelsThatNothingReadsAreLeftOut) {
  Image8 picture = image(256, 200);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = static_cast<std::uint8_t>(i * 7 + i / 999);
  for (const bool srgb : {false, true}) {
    const std::vector<std::uint8_t> whole = levels(store.upload(picture, srgb));
    std::size_t before = 0;
    for (int unread = 0; unread <= 8; ++unread) {
      const StoredTexture part = store.upload(picture, srgb, unread);
      if (part.firstLevel == 0 && unread > 0) GTEST_SKIP() << "the GL makes the levels";
      EXPECT_EQ(part.firstLevel, unread);
      EXPECT_EQ(part.storage.width, 256 >> unread);
      const std::vector<std::uint8_t> rest(whole.begin() + static_cast<std::ptrdiff_t>(before), whole.end());
      EXPECT_EQ(levels(part), rest) << unread << " srgb " << srgb;
      before += std::size_t{4} << (2 * (8 - unread));
    }
    EXPECT_EQ(store.upload(picture, srgb, 100).firstLevel, 8);
  }
  EXPECT_EQ(store.upload({100, 64, ZeroedBytes(25600)}, false, 1).firstLevel, 0) << "what it halves to is rounded";
  Image8 long_ = image(64, 200);
  long_.width = 512;
  long_.height = 8;
  EXPECT_EQ(store.upload(long_, false, 5).firstLevel, 3) << "the short side has no half texel";
  picture.ownLevels = true;
  EXPECT_EQ(store.upload(picture, false, 1).firstLevel, 0);
}

TEST_F(TextureStoreTest, LevelsBeyondASize) {
  const Image8 wide{1024, 300, {}};
  EXPECT_EQ(levelsBeyond(wide, 0), 0);
  EXPECT_EQ(levelsBeyond(wide, 1024), 0);
  EXPECT_EQ(levelsBeyond(wide, 1023), 1);
  EXPECT_EQ(levelsBeyond(wide, 256), 2);
  EXPECT_EQ(levelsBeyond(wide, 1), 10);
  EXPECT_EQ(levelsBeyond({500, 500, {}}, 125), 2) << "sides are halved downwards";
}

TEST_F(TextureStoreTest, AKeptTextureIsReadFromItsFirstLevelAgain) {
  StoredTexture first = store.upload(image(64, 200), false);
  store.readFrom(first, 2);
  EXPECT_EQ(first.baseLevel, 2);
  store.readFrom(first, 100);
  EXPECT_EQ(first.baseLevel, 6) << "the smallest that there is";
  store.keep(std::move(first));
  EXPECT_EQ(store.upload(image(64, 30), false).baseLevel, 0);
}

TEST_F(TextureStoreTest, NoMoreIsKeptThanTheBound) {
  const int before = context->gl().liveObjects;
  std::vector<StoredTexture> used;
  for (int i = 0; i < 30; ++i) used.push_back(store.upload(image(1024, 1), false));
  for (StoredTexture& texture : used) store.keep(std::move(texture));
  used.clear();
  // 1024 x 1024 texels and a third, of 4 bytes.
  EXPECT_EQ(store.keptCount(), static_cast<int>(TextureStore::MOST_KEPT_BYTES * 3 / (16 * 1024 * 1024)));
  EXPECT_EQ(context->gl().liveObjects, before + store.keptCount()) << "the others are deleted";
}

TEST_F(TextureStoreTest, OnlyBytesAreKept) {
  Image8 floats{2, 2, ZeroedBytes(64)};
  floats.type = TexelType::kFloat;
  floats.ownLevels = true;
  store.keep(store.upload(floats, false));
  EXPECT_EQ(store.keptCount(), 0);
}

}  // namespace
}  // namespace telar::texture_store_test
