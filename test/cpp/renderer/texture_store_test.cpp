#include "pass/texture_store.h"

#include <gtest/gtest.h>

#include <bit>

#include "gl/context.h"

namespace telar::texture_store_test {
namespace {

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

TEST_F(TextureStoreTest, AnotherSizeOrCodingIsANewTexture) {
  StoredTexture first = store.upload(image(64, 200), false);
  const GLuint name = first.texture.get();
  store.keep(std::move(first));
  // A miss lets go of as much as it takes.
  const StoredTexture smaller = store.upload(image(32, 200), false);
  EXPECT_NE(smaller.texture.get(), name);
  EXPECT_EQ(store.keptCount(), 0);
  store.keep(store.upload(image(64, 200), false));
  const StoredTexture coded = store.upload(image(64, 200), true);
  EXPECT_EQ(coded.storage.format, static_cast<GLenum>(GL_SRGB8_ALPHA8));
  EXPECT_EQ(store.keptCount(), 0);
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
