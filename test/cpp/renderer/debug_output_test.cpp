#include <gtest/gtest.h>

#include <cmath>

#include "renderer/scenes.h"

namespace telar::debug_output_test {
namespace {

using test::pixelF;
using test::sceneOf;
using test::shotOf;
using test::spherePrimitive;

constexpr int SIZE = 33;  // odd, so that a pixel's centre is the picture's
constexpr std::uint32_t CENTRE = 16;

Shot debugShot(DebugOutput output) {
  Shot shot = shotOf(SIZE);
  shot.samples = 1;
  shot.output.bitDepth = 32;
  shot.debugOutput = output;
  shot.lights.push_back({Shot::Light::Type::kAmbient});
  return shot;
}

Material leather() {
  Material material;
  material.baseColorFactor = {0.5f, 0.25f, 0.125f, 1};
  material.metallicFactor = 0.25f;
  material.roughnessFactor = 0.5f;
  return material;
}

/// One quantity at the centre of a sphere that faces the viewer.
glm::vec4 atCentre(DebugOutput output, const Material& material, ToneMapping toneMapping = ToneMapping::kNone) {
  Shot shot = debugShot(output);
  shot.toneMapping = toneMapping;
  FrameInfo info;
  const Frame frame = Renderer::create({})->draw(sceneOf(spherePrimitive(1), material), shot, {}, CancelToken(), info);
  EXPECT_EQ(frame.type, PixelType::kRgbaF32);
  EXPECT_EQ(pixelF(frame, 0, 0)[3], 0.0f) << "nothing is drawn in the corner";
  const float* pixel = pixelF(frame, CENTRE, CENTRE);
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

void expectNear(const glm::vec4& actual, const glm::vec4& expected, float tolerance) {
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "component " << c;
}

TEST(DebugOutput, GivesWhatTheMaterialSays) {
  expectNear(atCentre(DebugOutput::kN, leather()), {0, 0, 1, 1}, 1e-4f);
  expectNear(atCentre(DebugOutput::kBaseColor, leather()), {0.5f, 0.25f, 0.125f, 1}, 0);
  expectNear(atCentre(DebugOutput::kMetallic, leather()), {0.25f, 0.25f, 0.25f, 1}, 0);
  expectNear(atCentre(DebugOutput::kNoV, leather()), {1, 1, 1, 1}, 1e-4f);
  expectNear(atCentre(DebugOutput::kF0, leather()), {0.155f, 0.0925f, 0.06125f, 1}, 1e-6f);
  expectNear(atCentre(DebugOutput::kIrradiance, leather()), {1, 1, 1, 1}, 0);
  expectNear(atCentre(DebugOutput::kDirect, leather()), {0, 0, 0, 1}, 0);
}

TEST(DebugOutput, TheViewDirectionLeadsBackAlongTheRayOfThePixel) {
  FrameInfo info;
  const Frame frame = Renderer::create({})->draw(sceneOf(spherePrimitive(1), leather()),
                                                 debugShot(DebugOutput::kViewDirection), {}, CancelToken(), info);
  const double slope = std::tan(glm::radians(15.0));
  for (const auto& [x, y] : {std::pair{16u, 16u}, {20u, 16u}, {13u, 9u}, {25u, 19u}}) {
    const glm::dvec3 ray((2 * (x + 0.5) / SIZE - 1) * slope, (1 - 2 * (y + 0.5) / SIZE) * slope, -1);
    const glm::dvec3 back = -glm::normalize(ray);
    const float* pixel = pixelF(frame, x, y);
    expectNear({pixel[0], pixel[1], pixel[2], pixel[3]}, {back.x, back.y, back.z, 1}, 1e-5f);
  }
}

TEST(DebugOutput, TheLastTwoAreThePictureBeforeAndAfterEncoding) {
  Material shining = leather();
  shining.unlit = true;
  shining.baseColorFactor = {0.5f, 0.2140411f, 0.0031308f, 1};
  expectNear(atCentre(DebugOutput::kLinear, shining), {0.5f, 0.2140411f, 0.0031308f, 1}, 0);
  expectNear(atCentre(DebugOutput::kEncoded, shining), {0.7353569f, 0.5f, 0.0404499f, 1}, 1e-4f);
  const glm::vec4 toned = atCentre(DebugOutput::kEncoded, shining, ToneMapping::kReinhard);
  EXPECT_NEAR(toned[0], 0.6125f, 1e-3f) << "sRGB of 1/3";
}

TEST(DebugOutput, AnUnlitMaterialHasNoShading) {
  Material unlit = leather();
  unlit.unlit = true;
  EXPECT_EQ(atCentre(DebugOutput::kN, unlit), glm::vec4(0));
  EXPECT_EQ(atCentre(DebugOutput::kDirect, unlit), glm::vec4(0));
  expectNear(atCentre(DebugOutput::kBaseColor, unlit), {0.5f, 0.25f, 0.125f, 1}, 0);
}

TEST(DebugOutput, IsCompiledOnlyWhenAskedFor) {
  const auto scene = sceneOf(spherePrimitive(1, 4));
  EXPECT_EQ(planFrame(*scene, debugShot(DebugOutput::kNone), Limits{}).find("debug-output"), std::string::npos);
  EXPECT_NE(planFrame(*scene, debugShot(DebugOutput::kNoV), Limits{}).find("debug-output"), std::string::npos);
}

}  // namespace
}  // namespace telar::debug_output_test
