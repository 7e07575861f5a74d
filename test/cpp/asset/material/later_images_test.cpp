#include <chrono>
#include <memory>
#include <thread>

#include "asset/material/image_decoder.h"
#include "asset/model_builder.h"
#include "expect_error.h"

namespace telar::test {
namespace {

/// A quad whose material reads three images: in the file, and at a data: URI.
class LaterImagesTest : public testing::Test {
 protected:
  LaterImagesTest() {
    model.quad()["material"] = 0;
    model.doc["images"] = json::array();
    const json places[] = {{{"bufferView", model.view(pngPixel())}, {"mimeType", "image/png"}},
                           {{"uri", "data:image/png;base64," + base64(other())}},
                           {{"bufferView", model.view(third())}, {"mimeType", "image/png"}}};
    for (const json& place : places) model.doc["images"].push_back(place);
    model.doc["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}};
    model.doc["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                               {"normalTexture", {{"index", 1}}},
                               {"occlusionTexture", {{"index", 2}}}}};
  }
  /// The same texel in other bytes.
  static Bytes other() { return padded(1); }
  static Bytes third() { return padded(2); }
  static Bytes padded(std::size_t more) {
    Bytes out = pngPixel();
    out.resize(out.size() + more);
    return out;
  }
  /// Cut so long before its end.
  static Bytes cut(std::size_t bytes) {
    Bytes out = pngPixel();
    out.resize(out.size() - bytes);
    return out;
  }

  /// The file is gone when this returns, but for what the scene keeps.
  std::shared_ptr<const Scene> loadLater(bool tolerant = false) const {
    const auto file = std::make_shared<const Bytes>(model.glb());
    LoadOptions options;
    options.tolerant = tolerant;
    options.decodesLater = true;
    options.owner = file;
    return loadBytes(*file, {}, {}, options);
  }
  /// Code and pointer of what waiting ends with.
  static std::string errorOfWaiting(const Scene& scene, const CancelToken& cancel = {}) {
    try {
      waitForImages(scene, cancel);
    } catch (const Error& error) {
      return error.code + (error.pointer ? " at " + *error.pointer : "");
    }
    return "";
  }
  ModelBuilder model;
};

TEST_F(LaterImagesTest, SizesAreThereAtOnceAndTexelsAfterTheWait) {
  const auto now = load(model), later = loadLater();
  EXPECT_FALSE(now->pendingImages);
  ASSERT_TRUE(later->pendingImages);
  EXPECT_EQ(later->images[1].width, 1u);
  EXPECT_EQ(later->images[1].format, "PNG");
  EXPECT_EQ(describeScene(*later, {}), describeScene(*now, {}));
  waitForImages(*later, {});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(later->images[i].pixels, now->images[i].pixels) << i;
  waitForImages(*later, {});
}

TEST_F(LaterImagesTest, WhatIsDamagedIsToldByTheWaitAndOfTwoTheFirst) {
  model.doc["images"][1]["uri"] = "data:image/png;base64," + base64(cut(20));
  model.doc["images"][2]["bufferView"] = model.view(cut(21));
  for (int run = 0; run < 200; ++run) {
    const auto scene = loadLater();
    EXPECT_EQ(errorOfWaiting(*scene), "E_IMAGE_CORRUPT at /images/1");
    EXPECT_EQ(errorOfWaiting(*scene), "E_IMAGE_CORRUPT at /images/1") << "each time";
  }
}

TEST_F(LaterImagesTest, WhatItsHeaderTellsIsToldAtOnce) {
  model.doc["images"][2]["bufferView"] = model.view(bytesOf(std::vector<char>{'B', 'M', 0, 0, 0, 0, 0, 0}));
  EXPECT_ERROR(loadLater(), "E_IMAGE_FORMAT");
}

TEST_F(LaterImagesTest, WhereDamageIsAWarningNothingWaits) {
  model.doc["images"][2]["bufferView"] = model.view(cut(20));
  const auto scene = loadLater(true);
  EXPECT_FALSE(scene->pendingImages);
  EXPECT_TRUE(hasWarning(*scene, "W_TEXTURE"));
}

TEST_F(LaterImagesTest, ASceneThatIsMadeOfAnotherOneWaitsAsWell) {
  const Scene copy = *loadLater();
  waitForImages(copy, {});
  EXPECT_EQ(copy.images[0].pixels.size(), 4u);
}

/// A decoder without threads: who waits does the work.
TEST_F(LaterImagesTest, WhoWaitsHelps) {
  const auto images = std::make_shared<std::vector<Image8>>(2);
  for (Image8& image : *images) image.width = image.height = 1;
  const auto file = std::make_shared<const Bytes>(pngPixel());
  asset::ImageDecoder decoder(images, {{0, "/images/0", file, *file}, {1, "/images/1", file, *file}}, {}, {}, 0);
  EXPECT_TRUE((*images)[1].pixels.empty());
  decoder.wait({});
  EXPECT_EQ((*images)[1].pixels.size(), 4u);
}

TEST_F(LaterImagesTest, ASizeThatIsNotTheHeadersIsAnError) {
  const auto images = std::make_shared<std::vector<Image8>>(1);
  (*images)[0].width = (*images)[0].height = 2;
  const auto file = std::make_shared<const Bytes>(pngPixel());
  asset::ImageDecoder decoder(images, {{0, "/images/0", file, *file}}, {}, {}, 1);
  EXPECT_ERROR(decoder.wait({}), "E_IMAGE_CORRUPT");
}

TEST_F(LaterImagesTest, ACallerThatCancelsDoesNotWait) {
  const CancelToken cancel;
  cancel.cancel();
  // One thread takes the first, which takes it a tenth of a second.
  constexpr std::uint32_t SIDE = 4096;
  Frame frame{SIDE, SIDE, PixelType::kRgba8, std::vector<std::byte>(std::size_t{SIDE} * SIDE * 4)};
  const auto file = std::make_shared<const Bytes>(encode(frame, OutputOptions(), {}));
  const auto images = std::make_shared<std::vector<Image8>>(2);
  for (Image8& image : *images) image.width = image.height = SIDE;
  std::weak_ptr<const Bytes> held;
  {
    auto own = std::make_shared<const Bytes>(*file);
    held = own;
    asset::ImageDecoder decoder(images, {{0, "/images/0", own, *own}, {1, "/images/1", file, *file}}, {}, {}, 1);
    own.reset();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_ERROR(decoder.wait(cancel), "X_CANCELLED");
    EXPECT_FALSE(held.expired()) << "the first was waited for";
  }
  EXPECT_TRUE(held.expired());
}

TEST_F(LaterImagesTest, NoneIsBegunOnceTheLoadIsCancelled) {
  const CancelToken loading;
  loading.cancel();
  const auto images = std::make_shared<std::vector<Image8>>(1);
  (*images)[0].width = (*images)[0].height = 1;
  const auto file = std::make_shared<const Bytes>(pngPixel());
  asset::ImageDecoder decoder(images, {{0, "/images/0", file, *file}}, {}, loading, 1);
  EXPECT_ERROR(decoder.wait({}), "X_CANCELLED");
}

// Sanitizers see what a thread does with a scene that is gone.
TEST_F(LaterImagesTest, ASceneMayGoWhileItsImagesAreDecoded) {
  for (int run = 0; run < 200; ++run) loadLater();
}

}  // namespace
}  // namespace telar::test
