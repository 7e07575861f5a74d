#include "asset/container/container.h"

#include "asset/model_builder.h"

namespace telar::test {
namespace {

ModelBuilder texturedQuad() {
  ModelBuilder model;
  json& primitive = model.quad();
  primitive["attributes"]["TEXCOORD_0"] = model.accessor(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, 5126, "VEC2");
  primitive["material"] = 0;
  model.doc["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  model.doc["textures"] = {{{"source", model.image()}}};
  return model;
}

void putU32(Bytes& file, std::size_t at, std::uint32_t value) { std::memcpy(&file[at], &value, sizeof value); }

TEST(Container, EveryPrefixOfAGlbIsATypedErrorWithItsPlace) {
  const Bytes whole = texturedQuad().glb();
  ASSERT_EQ(errorOf(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    try {
      loadBytes(std::span(whole).first(size), {}, {});
      FAIL() << "a GLB of " << whole.size() << " bytes loaded from its first " << size;
    } catch (const Error& error) {
      const std::string expected = size == 0 ? "E_EMPTY" : size < 12 ? "E_GLB_HEADER" : "E_GLB_CHUNK";
      ASSERT_EQ(error.code, expected) << "at size " << size;
      ASSERT_TRUE(error.offset.has_value()) << "at size " << size;
    }
  }
}

TEST(Container, EveryPrefixOfAGltfIsATypedError) {
  const Bytes whole = texturedQuad().gltf();
  ASSERT_EQ(errorOf(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ASSERT_EQ(errorOf(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
              size == 0 ? "E_EMPTY" : "E_JSON");
  }
}

TEST(Container, EveryFlippedByteEndsInASceneOrATypedError) {
  const Bytes whole = texturedQuad().glb();
  int loaded = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const unsigned mask : {0x01u, 0x20u, 0x80u, 0xffu}) {
      Bytes file = whole;
      file[at] ^= static_cast<std::byte>(mask);
      loaded += errorOf(file).empty();  // anything but a telar::Error fails the test
    }
  }
  EXPECT_GT(loaded, 0);
}

TEST(Container, HeaderFaults) {
  const Bytes good = texturedQuad().glb();
  const auto with = [&](std::size_t at, std::uint32_t value) {
    Bytes file = good;
    putU32(file, at, value);
    return errorOf(file);
  };
  EXPECT_EQ(with(0, 0x04034b50), "E_NOT_GLTF");  // zip
  EXPECT_EQ(with(4, 1), "E_GLB_VERSION");
  EXPECT_EQ(with(8, 12), "E_GLB_LENGTH");
  EXPECT_EQ(with(8, static_cast<std::uint32_t>(good.size()) - 4), "E_GLB_LENGTH");
  EXPECT_EQ(with(8, static_cast<std::uint32_t>(good.size()) + 4), "E_GLB_CHUNK");
  EXPECT_EQ(with(12, 0), "E_GLB_CHUNK");
  EXPECT_EQ(with(12, 0xffffffff), "E_GLB_CHUNK");
  EXPECT_EQ(with(12, 0xffffffec), "E_GLB_CHUNK");  // 20 + length wraps to 0 in 32 bits
  EXPECT_EQ(with(16, 0x004e4942), "E_GLB_CHUNK");  // BIN first
}

TEST(Container, WhatIsNoGltfIsCalledWhatItLooksLike) {
  const auto said = [](std::string_view content) {
    const auto* bytes = reinterpret_cast<const std::byte*>(content.data());
    try {
      loadBytes(std::span(bytes, content.size()), {}, {});
    } catch (const Error& error) {
      EXPECT_EQ(error.offset, 0u);
      return error.code + ": " + error.what();
    }
    return std::string("nothing was thrown");
  };
  const std::string start = ": the file is neither GLB nor glTF JSON; it looks like ";
  EXPECT_EQ(said("PK\x03\x04\x14 zip"), "E_NOT_GLTF" + start + "a ZIP archive: unpack it, or export as GLB");
  const auto zipOf = [](const std::string& name) {
    return "PK\x03\x04" + std::string(22, '\0') + static_cast<char>(name.size()) + std::string(3, '\0') + name +
           "content";
  };
  EXPECT_EQ(said(zipOf("shirt.usdc")), "E_NOT_GLTF" + start + "a USDZ model: export as GLB");
  EXPECT_EQ(said(zipOf("shirt.glb")), "E_NOT_GLTF" + start + "a ZIP archive: unpack it, or export as GLB");
  EXPECT_EQ(said(std::string_view("Kaydara FBX Binary  \0\x1a\0", 23)),
            "E_NOT_GLTF" + start + "an FBX model: export as GLB");
  EXPECT_EQ(said("; FBX 7.4.0 project file\n"), "E_JSON" + start + "an FBX model: export as GLB");
  const std::string page = "an HTML page, as a download that failed leaves";
  EXPECT_EQ(said("<?xml version=\"1.0\"?>\n<!-- x -->\n<!DOCTYPE html PUBLIC \"\">"), "E_JSON" + start + page);
  EXPECT_EQ(said("<!-- saved -->\n<html>"), "E_JSON" + start + page);
  EXPECT_EQ(said("<?xml version=\"1.0\"?><Error><Code>AccessDenied"),
            "E_JSON" + start + "an error page of a file store, as a download that failed leaves");
  EXPECT_EQ(said("<?xml version=\"1.0\"?>\n<COLLADA xmlns"), "E_JSON" + start + "a COLLADA model: export as GLB");
  EXPECT_EQ(said("<?xml version=\"1.0\"?>\n<other/>"), "E_JSON" + start + "an XML file");
  EXPECT_EQ(said("<?xml version=\"1.0\"?>"), "E_JSON" + start + "an XML file");
  EXPECT_EQ(said("#usda 1.0\n"), "E_JSON" + start + "a USD model: export as GLB");
  EXPECT_EQ(said("#\n#Exported\n\nvn 0 0 1\n"), "E_JSON" + start + "a Wavefront OBJ model: export as GLB");
  EXPECT_EQ(said("# objects\ng shirt\n"), "E_JSON" + start + "a Wavefront OBJ model: export as GLB");
  EXPECT_EQ(said("\x89PNG\r\n\x1a\n"), "E_NOT_GLTF" + start + "a PNG image");
  EXPECT_EQ(said("\x01\x02\x03\x04"), "E_NOT_GLTF" + start + "an archive, an image or another model format");
  EXPECT_EQ(said("\n<!DOCTYPE HTML><p>404"), "E_JSON" + start + "an HTML page, as a download that failed leaves");
  EXPECT_EQ(said("version https://git-lfs.github.com/spec/v1\noid x"),
            "E_JSON" + start + "a Git LFS pointer: fetch the file itself with `git lfs pull`");
  EXPECT_EQ(said("# made by hand\n# twice\nmtllib a.mtl\n"), "E_JSON" + start + "a Wavefront OBJ model: export as GLB");
  EXPECT_EQ(said("a note to myself"), "E_JSON" + start + "plain text");
  EXPECT_EQ(said("#"), "E_JSON" + start + "plain text");
  EXPECT_EQ(said("# "), "E_JSON" + start + "plain text");
  EXPECT_EQ(said(" \n"), "E_JSON" + start + "plain text");
}

TEST(Container, UnknownChunksAreSkippedWithAWarning) {
  Bytes file = texturedQuad().glb();
  const std::uint32_t chunk[] = {4, 0x41424344, 0};
  const auto* bytes = reinterpret_cast<const std::byte*>(chunk);
  file.insert(file.end(), bytes, bytes + sizeof chunk);
  putU32(file, 8, static_cast<std::uint32_t>(file.size()));
  EXPECT_TRUE(hasWarning(*load(file), "W_GLB_CHUNK"));
}

TEST(Container, FileLimit) {
  Limits limits;
  limits.fileBytes = 100;
  EXPECT_EQ(errorOf(texturedQuad().glb(), limits), "L_FILE_BYTES");
}

TEST(Container, CancelledBeforeTheFirstByte) {
  const CancelToken cancel;
  cancel.cancel();
  const Bytes file = texturedQuad().glb();
  try {
    loadBytes(file, {}, cancel);
    FAIL() << "a cancelled job loaded";
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "X_CANCELLED");
  }
}

}  // namespace
}  // namespace telar::test
