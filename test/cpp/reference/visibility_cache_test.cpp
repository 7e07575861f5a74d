#include "trace/visibility_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "core/disk_cache.h"
#include "telar/visibility.h"

namespace telar::trace {
namespace {

namespace fs = std::filesystem;

const std::string KEY(64, 'a');

FoundVisibility some() {
  FoundVisibility found;
  found[{0, 0}] = {std::vector<glm::vec4>{{0, 0, 1, 0.5f}, {0, 1, 0, 0.25f}, {1, 0, 0, 1}},
                   std::vector<glm::vec4>{{0, 0, -1, 1}, {0, -1, 0, 0}, {-1, 0, 0, 0.75f}}};
  found[{2, 1}] = {std::vector<glm::vec4>{{0, 0, 1, 0.1f}}, {}};
  return found;
}

/// One triangle.
std::shared_ptr<Scene> triangle() {
  Primitive primitive;
  primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  primitive.normals.assign(3, {0, 0, 1});
  primitive.material = 0;
  Mesh mesh;
  mesh.primitives = {primitive};
  auto out = std::make_shared<Scene>();
  out->meshes.push_back(mesh);
  out->fileMeshes = 1;
  out->materials.resize(1);
  Node node;
  node.mesh = node.file.mesh = 0;
  out->nodes.push_back(node);
  out->sha256 = std::string(64, '1');
  return out;
}

TEST(VisibilityCache, AFileHasEveryBitOfWhatWasFound) {
  EXPECT_EQ(unpackVisibility(packVisibility(some(), KEY), KEY), some());
  EXPECT_EQ(unpackVisibility(packVisibility({}, KEY), KEY), FoundVisibility());
}

TEST(VisibilityCache, AFileOfAnotherKeyOrWithAnyByteChangedIsNone) {
  const auto file = packVisibility(some(), KEY);
  EXPECT_FALSE(unpackVisibility(file, std::string(64, 'b')));
  for (std::size_t i = 0; i < file.size(); ++i) {
    auto broken = file;
    broken[i] ^= std::byte{1};
    EXPECT_FALSE(unpackVisibility(broken, KEY)) << i;
    EXPECT_FALSE(unpackVisibility(std::span(file).first(i), KEY)) << i;
  }
}

TEST(VisibilityCache, AKeyTellsFileRaysVersionAndWhatIsMissing) {
  const auto scene = triangle();
  const std::string key = visibilityKey(*scene, 64, "1.0.0");
  EXPECT_EQ(key.size(), 64u);
  EXPECT_NE(visibilityKey(*scene, 65, "1.0.0"), key);
  EXPECT_NE(visibilityKey(*scene, 64, "1.0.1"), key);
  scene->warnings.push_back({"W_IMAGE", "it cannot be read", "/images/0"});
  EXPECT_NE(visibilityKey(*scene, 64, "1.0.0"), key);
  scene->warnings.clear();
  scene->sha256.back() = '2';
  EXPECT_NE(visibilityKey(*scene, 64, "1.0.0"), key);
}

TEST(VisibilityCache, WhatIsKeptTakesThePlaceOfRays) {
  const fs::path folder = fs::path(testing::TempDir()) / ("telar-visibility-" + std::to_string(getpid()));
  const auto scene = triangle();
  const VisibilityCache cache{folder.string(), 1u << 20, "1"};
  FoundVisibility told;
  told[{0, 0}] = some().at({0, 0});
  const std::string key = visibilityKey(*scene, 64, "1");
  DiskCache(folder, 1u << 20).write(DiskCache::Kind::kVisibility, key, packVisibility(told, key));
  const auto out = withAmbientVisibility(scene, 64, cache, Limits(), CancelToken());
  EXPECT_EQ(out->meshes[0].primitives[0].visibility, told.at({0, 0})) << "which no ray would find";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace telar::trace
