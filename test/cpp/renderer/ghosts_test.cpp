#include "frame/ghosts.h"

#include <gtest/gtest.h>

#include "expect_error.h"

namespace telar::frame {
namespace {

TEST(Ghosts, AStarStandsForAnyCharacters) {
  for (const auto& [pattern, name] : {std::pair("front", "front"), std::pair("*", ""), std::pair("*", "front"),
                                      std::pair("f*", "front"), std::pair("*t", "front"), std::pair("f*n*", "front"),
                                      std::pair("*ab", "aab"), std::pair("a*b*c", "aXbYbZc"), std::pair("f**", "f")})
    EXPECT_TRUE(matchesName(pattern, name)) << pattern << " " << name;
  for (const auto& [pattern, name] :
       {std::pair("front", "fron"), std::pair("fron", "front"), std::pair("", "f"), std::pair("*x", "front"),
        std::pair("f*x*t", "front"), std::pair("f.o", "fro"), std::pair("F*", "front")})
    EXPECT_FALSE(matchesName(pattern, name)) << pattern << " " << name;
}

/// A body with a child that it wears, and a collar.
Scene dressed() {
  Scene scene;
  scene.meshes.resize(1);
  scene.materials.resize(2);
  scene.materials[0].name = "skin", scene.materials[1].name = "cloth";
  scene.fileMaterials = 2;
  for (int i = 0; i < 3; ++i) {
    Node& node = scene.nodes.emplace_back();
    node.file.node = i;
    node.mesh = 0;
  }
  scene.nodes[0].name = "body", scene.nodes[1].name = "shirt", scene.nodes[2].name = "collar";
  scene.nodes[1].parent = 0;
  return scene;
}

PartQuery node(const char* name) { return {PartQuery::Kind::kNode, std::string(name), {}}; }

TEST(Ghosts, ANodeTakesWhatIsBeneathItAlong) {
  const Scene scene = dressed();
  Shot shot;
  shot.ghost = {{node("body"), 0.0f}, {node("shirt"), 0.5f}, {{PartQuery::Kind::kMaterial, 1, {}}, 0.5f}};
  const Ghosts ghosts(scene, shot);
  EXPECT_EQ(ghosts.opacity(scene.nodes[0], 0), 0.0f);
  EXPECT_EQ(ghosts.opacity(scene.nodes[1], 0), 0.5f) << "the last that means it";
  EXPECT_EQ(ghosts.opacity(scene.nodes[1], 1), 0.25f) << "times that of its material";
  EXPECT_EQ(ghosts.opacity(scene.nodes[2], -1), 1.0f);
  EXPECT_EQ(Ghosts(scene, Shot()).opacity(scene.nodes[0], 0), 1.0f);
}

TEST(Ghosts, ACopyIsBlendedAndTheModelStaysAsItIs) {
  Material material;
  material.baseColorFactor.a = 0.8f;
  material.alphaMode = AlphaMode::kMask;
  Ghosts ghosts;
  const auto ghost = ghosts.of(material, 0.5f);
  EXPECT_EQ(ghost->alphaMode, AlphaMode::kBlend);
  EXPECT_FLOAT_EQ(ghost->baseColorFactor.a, 0.4f);
  EXPECT_EQ(material.alphaMode, AlphaMode::kMask);
  EXPECT_EQ(ghosts.of(material, 0.5f), ghost) << "made once";
  EXPECT_NE(ghosts.of(material, 0.4f), ghost);
}

TEST(Ghosts, WhatIsOpaqueHasNoAlphaOfItsOwn) {
  Material material;
  material.baseColorFactor.a = 0;
  Ghosts ghosts;
  EXPECT_EQ(ghosts.of(material, 0.5f)->baseColorFactor.a, 0.5f);
}

TEST(Ghosts, APartThatIsNotThereIsNamed) {
  Shot shot;
  shot.ghost = {{node("sleeve*"), 0.5f}};
  EXPECT_ERROR(Ghosts(dressed(), shot), "E_FRAME");
}

}  // namespace
}  // namespace telar::frame
