#include "pass/plan/varyings.h"

#include <gtest/gtest.h>

#include <algorithm>

// What the fragments of the visibility buffer read; that the bytes of pictures stay is seen in
// visibility_buffer_test.cpp.

namespace telar::varyings_test {
namespace {

/// A base colour, a normal map and an occlusion map; the last one has other coordinates.
Material material() {
  Material m;
  m.normalTexture.uvTransform = m.baseColorTexture.uvTransform = glm::mat3(glm::mat2(50));
  m.occlusionTexture.uvTransform = glm::mat3(1);
  return m;
}

shader::VariantKey keyOf(bool shared) {
  shader::VariantKey key;
  key.baseColorMap = key.normalMap = key.occlusionMap = true;
  if (shared) key.uvOf = pass::sharedUvs(material(), key);
  return key;
}

TEST(Varyings, AreSharedByMapsOfTheSameCoordinates) {
  const std::vector<std::uint8_t> uvOf = keyOf(true).uvOf;
  ASSERT_EQ(uvOf.size(), 3u);
  EXPECT_EQ(std::ranges::count(uvOf, 0), 2);  // of two maps the first one
  const auto varyings = pass::varyingsOf(keyOf(true));
  EXPECT_EQ(pass::componentsOf(varyings) + 2, pass::componentsOf(pass::varyingsOf(keyOf(false))));
  for (const pass::Varying& varying : varyings) {
    EXPECT_EQ(varying.same.size(), varying.name == "vBaseColorUv" ? 1u : 0u) << varying.name;
  }
  shader::VariantKey other = keyOf(false);
  other.normalUv1 = true;  // the same transform of another set
  EXPECT_EQ(std::ranges::count(pass::sharedUvs(material(), other), 0), 1);
}

TEST(Varyings, EndWithFactsThatTheProgramReads) {
  const std::string source = "void readVaryings();\n";
  shader::VariantKey key = keyOf(true);
  EXPECT_EQ(pass::factsOf(key), 0u);
  EXPECT_EQ(pass::texelsOf(key), 3u);  // position, normal, two coordinates
  EXPECT_EQ(pass::withVaryings(source, key).find("triangleFront"), std::string::npos);
  key.doubleSided = true;
  EXPECT_EQ(pass::factsOf(key), 1u);
  EXPECT_EQ(pass::texelsOf(key), 3u);
  EXPECT_NE(pass::withVaryings(source, key).find("triangleFront = t2.z > 0.0;"), std::string::npos);
  key = keyOf(true);
  key.lights.directionalShadows = key.lights.directional = 1;
  EXPECT_EQ(pass::factsOf(key), 3u);
}

}  // namespace
}  // namespace telar::varyings_test
