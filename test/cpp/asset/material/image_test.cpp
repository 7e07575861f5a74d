#include "asset/model_builder.h"

namespace telar::test {
namespace {

/// A quad whose material uses the last image of the document.
class ImageTest : public testing::Test {
 protected:
  ImageTest() {
    model.quad()["material"] = 0;
    model.doc["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    model.doc["images"] = json::array();
  }
  std::string errorWith(const json& image) {
    model.doc["images"].push_back(image);
    model.doc["textures"] = {{{"source", model.doc["images"].size() - 1}}};
    return errorOf(model);
  }
  ModelBuilder model;
};

TEST_F(ImageTest, DataUris) {
  const std::string png = base64(pngPixel());
  EXPECT_EQ(errorWith({{"uri", "data:image/png;base64," + png}}), "");
  EXPECT_EQ(errorWith({{"uri", "DATA:;base64," + png}}), "");
  EXPECT_EQ(errorWith({{"uri", "data:text/html;base64," + png}}), "E_URI_DATA at /images/2/uri");
  EXPECT_EQ(errorWith({{"uri", "data:image/png;base64" + png}}), "E_URI_DATA at /images/3/uri");
  EXPECT_EQ(errorWith({{"uri", "wool.png"}}), "E_URI_DENIED at /images/4/uri");
  EXPECT_EQ(errorWith({{"uri", "http://127.0.0.1/a.png"}}), "E_URI_DENIED at /images/5/uri");
}

TEST_F(ImageTest, AUsedImageMustBeWholeAnUnusedOneOnlyWarns) {
  Bytes cut = pngPixel();
  cut.resize(cut.size() / 2);
  const int view = model.view(cut);
  EXPECT_EQ(errorWith({{"bufferView", view}, {"mimeType", "image/png"}}), "E_IMAGE_CORRUPT at /images/0");
  const int bmp = model.view(bytesOf(std::vector<char>{'B', 'M', 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(errorWith({{"bufferView", bmp}, {"mimeType", "image/png"}}), "E_IMAGE_FORMAT at /images/1");
  const int good = model.view(pngPixel());
  EXPECT_EQ(errorWith({{"bufferView", good}, {"mimeType", "image/png"}}), "");
  const auto scene = load(model);
  EXPECT_TRUE(hasWarning(*scene, "W_IMAGE"));
  EXPECT_EQ(scene->images[0].width, 0u);
  EXPECT_EQ(scene->images[2].width, 1u);
}

TEST_F(ImageTest, TheTypeIsReadFromTheBytes) {
  const int view = model.view(pngPixel());
  EXPECT_EQ(errorWith({{"bufferView", view}, {"mimeType", "image/jpeg"}}), "");
  EXPECT_TRUE(hasWarning(*load(model), "W_IMAGE_MIME"));
}

TEST_F(ImageTest, EachDistinctImageIsDecodedOnce) {
  const int view = model.view(pngPixel());
  for (int i = 0; i < 3; ++i) model.doc["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
  model.doc["textures"] = {{{"source", 1}}, {{"source", 2}}};
  model.doc["materials"][0]["normalTexture"] = {{"index", 1}};
  Limits limits;
  limits.imageBytes = 4;  // one image of one pixel
  const auto scene = load(model, limits);
  EXPECT_EQ(scene->materials[0].baseColorTexture.image, 0);
  EXPECT_EQ(scene->materials[0].normalTexture.image, 0);
  EXPECT_EQ(scene->images[0].width, 1u);
  EXPECT_EQ(scene->images[1].width, 0u);
  model.doc["images"][2]["bufferView"] = model.view(pngPixel());
  const auto same = load(model, limits);
  EXPECT_EQ(same->materials[0].normalTexture.image, 0);  // the same bytes
  EXPECT_EQ(same->images[2].width, 0u);
  Bytes other = pngPixel();
  other.push_back(std::byte{0});
  model.doc["images"][2]["bufferView"] = model.view(other);
  EXPECT_EQ(errorOf(model, limits), "L_IMAGE_BYTES at /images/2");
}

// A file may say a small picture and be large: as many of these as there are views would be hashed.
TEST_F(ImageTest, AFileMuchLargerThanItsTexelsIsNotCompared) {
  Bytes padded = pngPixel();
  padded.resize(padded.size() + 8192);
  for (int i = 0; i < 2; ++i)
    model.doc["images"].push_back({{"bufferView", model.view(padded)}, {"mimeType", "image/png"}});
  model.doc["textures"] = {{{"source", 0}}, {{"source", 1}}};
  model.doc["materials"][0]["normalTexture"] = {{"index", 1}};
  const auto scene = load(model);
  EXPECT_EQ(scene->materials[0].normalTexture.image, 1);
  EXPECT_EQ(scene->images[1].width, 1u);
}

// Several threads decode: which one meets a damaged image first must not show.
TEST_F(ImageTest, OfSeveralDamagedImagesTheFirstIsTold) {
  Bytes cut = pngPixel();
  cut.resize(cut.size() / 2);
  const char* slots[] = {"normalTexture", "occlusionTexture", "emissiveTexture"};
  model.doc["textures"] = json::array();
  for (int i = 0; i < 4; ++i) {
    const int view = model.view(i == 1 || i == 3 ? cut : pngPixel());
    model.doc["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    model.doc["textures"].push_back({{"source", i}});
    if (i > 0) model.doc["materials"][0][slots[i - 1]] = {{"index", i}};
  }
  for (int run = 0; run < 200; ++run) EXPECT_EQ(errorOf(model), "E_IMAGE_CORRUPT at /images/1");
}

}  // namespace
}  // namespace telar::test
