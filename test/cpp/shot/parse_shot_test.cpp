#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "expect_error.h"
#include "shading_terms.h"
#include "telar/error.h"
#include "telar/shot.h"

namespace telar {
namespace {

using nlohmann::json;

// What resolveShot writes for a shot without keys (test/js/shot_native.test.mjs sends its real output through the
// addon).
json standard() {
  return json::parse(R"({
    "size": {"width": 512, "height": 256},
    "camera": {"projection": "perspective", "position": [0, 1, 5], "target": [0, 1, 0], "up": [0, 1, 0],
               "fovY": 30, "near": 0.5, "far": 9},
    "environment": {"map": "studio", "intensity": 1, "rotation": 0},
    "lens": null, "lights": [], "modelLights": true, "background": "transparent", "ground": "none", "shading": "three", "toneMapping": "neutral",
    "exposure": 1, "quality": {"preset": "standard", "samples": 4, "resolve": "encoded", "noise": 0, "environmentSamples": 0}, "variant": "", "pose": null, "layers": ["beauty"],
    "output": {"format": "png", "quality": 90, "bitDepth": 8, "ppi": 0, "icc": false}})");
}

json with(const std::string& pointer, const json& value) {
  json shot = standard();
  shot[json::json_pointer(pointer)] = value;
  return shot;
}

Error failure(const json& shot) {
  try {
    parseShot(shot.dump());
  } catch (const Error& error) {
    return error;
  }
  return {"none", "nothing was thrown"};
}

TEST(ParseShot, ReadsEveryField) {
  json written = standard();
  written["camera"] = {{"projection", "orthographic"},
                       {"position", {1, 2, 3}},
                       {"target", {4, 5, 6}},
                       {"up", {0, 0, 1}},
                       {"height", 2.5},
                       {"near", -1},
                       {"far", 8}};
  written["environment"] = {{"map", "/maps/sky.exr"}, {"intensity", 0.5}, {"rotation", -90}};
  written["modelLights"] = false;
  written["background"] = {0.25, 0.5, 1};
  written["toneMapping"] = "agx";
  written["exposure"] = 1.5;
  written["quality"] = {{"samples", 16}, {"resolve", "linear"}, {"noise", 0.5}, {"environmentSamples", 64}};
  written["variant"] = "navy";
  written["pose"] = {{"animation", 2}, {"time", 0.25}};
  written["output"] = {{"format", "exr"}, {"quality", 1}, {"bitDepth", 32}, {"ppi", 300}, {"icc", true}};
  const Shot shot = parseShot(written.dump());
  EXPECT_EQ(shot.width, 512);
  EXPECT_EQ(shot.height, 256);
  EXPECT_FALSE(shot.camera.perspective);
  EXPECT_EQ(shot.camera.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(shot.camera.target, glm::dvec3(4, 5, 6));
  EXPECT_EQ(shot.camera.up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(shot.camera.height, 2.5);
  EXPECT_EQ(shot.camera.near, -1);
  EXPECT_EQ(shot.camera.far, 8);
  EXPECT_EQ(shot.environment.source, Shot::Environment::Source::kPath);
  EXPECT_EQ(shot.environment.path, "/maps/sky.exr");
  EXPECT_EQ(shot.environment.intensity, 0.5);
  EXPECT_EQ(shot.environment.rotation, -90);
  EXPECT_FALSE(shot.modelLights);
  EXPECT_EQ(shot.background.type, Shot::Background::Type::kColor);
  EXPECT_EQ(shot.background.color, glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(shot.shading, ShadingModel::kThree);
  EXPECT_EQ(shot.toneMapping, "agx");
  EXPECT_EQ(shot.exposure, 1.5);
  EXPECT_EQ(shot.samples, 16);
  EXPECT_TRUE(shot.linearResolve);
  EXPECT_EQ(shot.noise, 0.5);
  EXPECT_EQ(shot.environmentSamples, 64);
  EXPECT_EQ(shot.variant, "navy");
  EXPECT_EQ(shot.pose, (Pose{2, 0.25}));
  EXPECT_EQ(shot.output.format, OutputOptions::Format::kExr);
  EXPECT_EQ(shot.output.quality, 1);
  EXPECT_EQ(shot.output.bitDepth, 32);
  EXPECT_EQ(shot.output.ppi, 300);
  EXPECT_TRUE(shot.output.icc);
}

TEST(ParseShot, ReadsTheOtherForms) {
  const Shot shot = parseShot(standard().dump());
  EXPECT_TRUE(shot.camera.perspective);
  EXPECT_EQ(shot.camera.fovY, 30);
  EXPECT_EQ(shot.environment.source, Shot::Environment::Source::kStudio);
  EXPECT_EQ(shot.background.type, Shot::Background::Type::kTransparent);
  EXPECT_EQ(shot.variant, "");
  EXPECT_FALSE(shot.pose);
  using Source = Shot::Environment::Source;
  EXPECT_EQ(parseShot(with("/environment/map", "none").dump()).environment.source, Source::kNone);
  EXPECT_EQ(parseShot(with("/environment/map", {{"bytes", 12}}).dump()).environment.source, Source::kBytes);
  EXPECT_EQ(parseShot(with("/background", "environment").dump()).background.type, Shot::Background::Type::kEnvironment);
  EXPECT_EQ(parseShot(with("/background", "environment").dump()).background.blur, 0);
  const json blurred = {{"type", "environment"}, {"blur", 0.25}};
  EXPECT_EQ(parseShot(with("/background", blurred).dump()).background.type, Shot::Background::Type::kEnvironment);
  EXPECT_EQ(parseShot(with("/background", blurred).dump()).background.blur, 0.25);
}

TEST(ParseShot, ReadsTheTermsOfAShading) {
  json shading = {{"base", "disney-2012"},
                  {"parameters", "disney-2012"},
                  {"diffuse", "disney-2012"},
                  {"distribution", "gtr2-anisotropic"},
                  {"visibility", "smith-separable"},
                  {"fresnel", "schlick"},
                  {"sheen", "zeltner"},
                  {"clearcoat", "disney-2012"},
                  {"layering", "disney-2012"},
                  {"scattering", "single"},
                  {"environment", "three-table"}};
  const Shot shot = parseShot(with("/shading", shading).dump());
  EXPECT_EQ(shot.shading, ShadingModel::kDisney2012);
  ShadingTerms expected = termsOf(ShadingModel::kDisney2012);
  expected.sheen = 4;
  EXPECT_EQ(shot.terms, expected);
  EXPECT_EQ(termsOf(ShadingModel::kThreeR115), ShadingTerms());
  shading.erase("fresnel");
  EXPECT_STREQ(failure(with("/shading", shading)).what(),
               "shot.shading.fresnel: expected a value, got nothing: pass what resolveShot returns");
  EXPECT_EQ(failure(with("/shading", "three-r115")).pointer, "/shading");
  EXPECT_EQ(parseShot(with("/shading", "fabric").dump()).shading, ShadingModel::kFabric);
}

TEST(ParseShot, ALensExposesByEv100AndSetsWhatIsSharp) {
  const json sunny = {{"aperture", 16}, {"shutter", 0.01}, {"iso", 100}, {"focusDistance", nullptr}};
  const Shot exposed = parseShot(with("/lens", sunny).dump());
  const double ev100 = std::log2(16.0 * 16.0 / 0.01 * 100 / 100);
  EXPECT_NEAR(exposed.exposure, 1 / (1.2 * std::exp2(ev100)), 1e-15);
  EXPECT_FALSE(exposed.lens);
  const json wide = {{"aperture", 1.4}, {"shutter", nullptr}, {"iso", nullptr}, {"focusDistance", 2}};
  const Shot blurred = parseShot(with("/lens", wide).dump());
  EXPECT_EQ(blurred.exposure, 1);
  ASSERT_TRUE(blurred.lens);
  EXPECT_EQ(blurred.lens->aperture, 1.4);
  EXPECT_EQ(blurred.lens->focusDistance, 2);
}

TEST(ParseShot, ReadsWhatThePathTracerDoes) {
  EXPECT_FALSE(parseShot(standard().dump()).reference);
  json quality = json::parse(R"({"preset": "reference", "samples": 9, "seed": 1000000000, "transport": "occlusion",
                                 "bounces": 0, "threads": 3})");
  const Shot shot = parseShot(with("/quality", quality).dump());
  ASSERT_TRUE(shot.reference);
  EXPECT_EQ(shot.samples, 1);
  EXPECT_EQ(shot.reference->samples, 9);
  EXPECT_EQ(shot.reference->seed, 1000000000u);
  EXPECT_EQ(shot.reference->transport, Shot::Reference::Transport::kOcclusion);
  EXPECT_EQ(shot.reference->threads, 3);
  quality["samples"] = 0;
  EXPECT_STREQ(failure(with("/quality", quality)).what(),
               "shot.quality.samples: expected an integer from 1 to 65536, got 0");
}

TEST(ParseShot, ReadsEveryLight) {
  const json lights = json::parse(R"([
    {"type": "ambient", "color": [1, 0.5, 0], "intensity": 2},
    {"type": "hemisphere", "color": [1, 1, 1], "groundColor": [0, 0, 0.5], "intensity": 3},
    {"type": "directional", "color": [1, 1, 1], "intensity": 4, "position": [0, 1, 0], "target": [1, 0, 0],
     "castShadow": true, "shadow": {"mapSize": 512, "radius": 2, "intensity": 0.5, "bias": -0.25, "normalBias": 0.125,
     "near": -1, "far": 6, "left": -2, "right": 3, "bottom": -4, "top": 5}},
    {"type": "point", "color": [1, 1, 1], "intensity": 5, "position": [0, 2, 0], "range": 6, "castShadow": false},
    {"type": "spot", "color": [1, 1, 1], "intensity": 7, "position": [0, 3, 0], "target": [0, 0, 0], "range": 8,
     "angle": 0.5, "penumbra": 0.25, "castShadow": true, "shadow": {"mapSize": 16, "radius": 0, "intensity": 1,
     "bias": 0, "normalBias": 0, "near": 1, "far": 8, "focus": 0.75}},
    {"type": "rect", "color": [1, 1, 1], "intensity": 9, "position": [0, 4, 0], "target": [0, 1, 0], "width": 2,
     "height": 0.5},
    {"type": "disk", "color": [1, 1, 1], "intensity": 9, "position": [0, 4, 0], "target": [0, 1, 0], "radius": 0.25}])");
  const std::vector<Shot::Light> read = parseShot(with("/lights", lights).dump()).lights;
  ASSERT_EQ(read.size(), 7u);
  using Type = Shot::Light::Type;
  EXPECT_EQ(read[0].type, Type::kAmbient);
  EXPECT_EQ(read[0].color, glm::vec3(1, 0.5f, 0));
  EXPECT_EQ(read[0].intensity, 2);
  EXPECT_EQ(read[1].type, Type::kHemisphere);
  EXPECT_EQ(read[1].groundColor, glm::vec3(0, 0, 0.5f));
  EXPECT_EQ(read[2].type, Type::kDirectional);
  EXPECT_EQ(read[2].target, glm::dvec3(1, 0, 0));
  ASSERT_TRUE(read[2].castShadow);
  const Shot::Light::Shadow& shadow = read[2].shadow;
  EXPECT_EQ(shadow.mapSize, 512);
  EXPECT_EQ(std::vector({shadow.radius, shadow.intensity, shadow.bias, shadow.normalBias}),
            std::vector({2.0, 0.5, -0.25, 0.125}));
  EXPECT_EQ(std::vector({shadow.near, shadow.far, shadow.left, shadow.right, shadow.bottom, shadow.top}),
            std::vector<double>({-1, 6, -2, 3, -4, 5}));
  EXPECT_EQ(read[6].type, Type::kDisk);
  EXPECT_EQ(read[6].radius, 0.25);
  EXPECT_FALSE(read[3].castShadow);
  EXPECT_EQ(read[4].shadow.focus, 0.75);
  EXPECT_EQ(read[3].type, Type::kPoint);
  EXPECT_EQ(read[3].position, glm::dvec3(0, 2, 0));
  EXPECT_EQ(read[3].range, 6);
  EXPECT_EQ(read[4].type, Type::kSpot);
  EXPECT_EQ(read[4].range, 8);
  EXPECT_EQ(read[4].angle, 0.5);
  EXPECT_EQ(read[4].penumbra, 0.25);
  EXPECT_EQ(read[5].type, Type::kRect);
  EXPECT_EQ(read[5].target, glm::dvec3(0, 1, 0));
  EXPECT_EQ(read[5].width, 2);
  EXPECT_EQ(read[5].height, 0.5);
}

TEST(ParseShot, ReadsTheGround) {
  EXPECT_FALSE(parseShot(standard().dump()).ground);
  const json ground = {{"shadow", true}, {"opacity", 0.5}, {"position", {1, 2, 3}}, {"size", {4, 5}}};
  const Shot shot = parseShot(with("/ground", ground).dump());
  ASSERT_TRUE(shot.ground);
  EXPECT_EQ(shot.ground->opacity, 0.5);
  EXPECT_EQ(shot.ground->position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(shot.ground->size, glm::dvec2(4, 5));
  EXPECT_STREQ(failure(with("/ground", "floor")).what(), "shot.ground: expected one of none, got \"floor\"");
  for (const auto& [key, value] : ground.items()) {
    json less = with("/ground", ground);
    less["ground"].erase(key);
    EXPECT_EQ(failure(less).pointer, "/ground/" + key);
  }
}

/// A light that casts a shadow, its `shadow` less or with one key.
json casting(const std::string& key, const json& value) {
  json light = {{"type", "point"}, {"color", {1, 1, 1}},    {"intensity", 1},
                {"range", 0},      {"position", {0, 2, 0}}, {"castShadow", true}};
  light["shadow"] = {{"mapSize", 512}, {"radius", 2},     {"intensity", 0.5}, {"bias", 0},
                     {"near", 1},      {"normalBias", 0}, {"far", 2}};
  light["shadow"].erase(key);
  if (!value.is_null()) light["shadow"][key] = value;
  return with("/lights", json::array({light}));
}

TEST(ParseShot, RefusesAbsurdShadows) {
  EXPECT_EQ(failure(casting("bias", 0.5)).code, "none");
  const std::vector<std::pair<const char*, json>> wrong{
      {"mapSize", 0},   {"mapSize", 4097}, {"mapSize", -512},       {"mapSize", 64.5}, {"mapSize", 1e300}, {"bias", 2},
      {"bias", "0"},    {"radius", -1},    {"radius", 26},          {"near", 0},       {"near", 2},        {"far", 1},
      {"intensity", 2}, {"far", nullptr},  {"normalBias", nullptr}, {"normalBias", -1}};
  for (const auto& [key, value] : wrong) {
    const Error error = failure(casting(key, value));
    EXPECT_EQ(error.code, "E_SHOT") << key << " " << value;
    ASSERT_TRUE(error.pointer) << key << " " << value;
    EXPECT_EQ(error.pointer->rfind("/lights/0/shadow/", 0), 0u) << *error.pointer;
  }
}

TEST(ParseShot, EveryKeyIsNeeded) {
  const std::vector<std::string> optional{"/quality/preset", "/layers", "/layers/0"};
  const json flat = standard().flatten();
  int removed = 0;
  for (const auto& [pointer, value] : flat.items()) {
    if (std::ranges::find(optional, pointer) != optional.end() || pointer == "/lights") continue;
    json shot = standard();
    const json::json_pointer where(pointer);
    json& parent = shot[where.parent_pointer()];
    if (!parent.is_object()) continue;
    parent.erase(where.back());
    const Error error = failure(shot);
    EXPECT_EQ(error.code, "E_SHOT") << pointer;
    EXPECT_EQ(error.pointer, pointer);
    EXPECT_NE(std::string(error.what()).find("expected a value, got nothing"), std::string::npos) << error.what();
    ++removed;
  }
  EXPECT_GE(removed, 20);
}

struct Wrong {
  const char* pointer;
  json value;
  const char* message;
};

TEST(ParseShot, NamesPathExpectationAndValue) {
  const std::vector<Wrong> cases{
      {"/size/width", 0, "shot.size.width: expected an integer from 1 to 8192, got 0"},
      {"/size/width", 1.5, "shot.size.width: expected an integer from 1 to 8192, got 1.5"},
      {"/size/height", "9", "shot.size.height: expected an integer from 1 to 8192, got \"9\""},
      {"/camera/projection", "fish", "shot.camera.projection: expected one of orthographic, perspective, got \"fish\""},
      {"/camera/position", {1, 2}, "shot.camera.position: expected an array of 3 numbers, got an array of 2"},
      {"/camera/fovY", 180, "shot.camera.fovY: expected a number of at most 179.999, got 180"},
      {"/camera/near", 0, "shot.camera.near: expected a distance above 0, got 0"},
      {"/camera/far", 0.5, "shot.camera.far: expected a distance beyond near, got 0.5"},
      {"/camera/target", {0, 1, 5}, "shot.camera.target: expected a point other than position, got an array of 3"},
      {"/environment/map", "",
       "shot.environment.map: expected none, studio, or the path of an .hdr or .exr file, got \"\""},
      {"/environment/map", 4, "shot.environment.map: expected a string, got 4"},
      {"/environment/intensity", -1, "shot.environment.intensity: expected a number of at least 0.0, got -1"},
      {"/lights", {{"type", "spot"}}, "shot.lights: expected an array, got an object"},
      {"/modelLights", 1, "shot.modelLights: expected true or false, got 1"},
      {"/background",
       {0, -1, 0},
       "shot.background: expected a linear colour with components from 0 to 1e+30, got an array of 3"},
      {"/background", "red", "shot.background: expected one of transparent, environment, got \"red\""},
      {"/toneMapping", nullptr,
       "shot.toneMapping: expected one of none, linear, reinhard, cineon, aces, agx, neutral, got null"},
      {"/quality/samples", 3, "shot.quality.samples: expected 1, 4, 16, 64, 256 or 1024, got 3"},
      {"/quality/noise", -1, "shot.quality.noise: expected a number of at least 0.0, got -1"},
      {"/quality/environmentSamples", -1,
       "shot.quality.environmentSamples: expected an integer from 0 to 4096, got -1"},
      {"/variant", json::object(), "shot.variant: expected a string, got an object"},
      {"/pose/animation", -1, "shot.pose.animation: expected an integer from 0 to 2147483647, got -1"},
      {"/output/bitDepth", 16, "nothing was thrown"},
      {"/output/bitDepth", 32, "shot.output.bitDepth: expected a bit depth that png has, got 32"},
      {"/output/quality", 101, "shot.output.quality: expected an integer from 1 to 100, got 101"},
  };
  for (const Wrong& wrong : cases) {
    const Error error = failure(with(wrong.pointer, wrong.value));
    EXPECT_STREQ(error.what(), wrong.message);
    if (error.code == "E_SHOT") {
      EXPECT_EQ(error.pointer, wrong.pointer);
    }
  }
}

TEST(ParseShot, ManySamplesAreAveragedInLinearLight) {
  EXPECT_STREQ(failure(with("/quality/samples", 16)).what(),
               "shot.quality.resolve: expected linear with so many samples, got \"encoded\"");
}

TEST(ParseShot, RefusesWhatIsNoShot) {
  EXPECT_ERROR(parseShot(""), "E_SHOT");
  EXPECT_ERROR(parseShot("{"), "E_SHOT");
  EXPECT_ERROR(parseShot("[]"), "E_SHOT");
  EXPECT_ERROR(parseShot("null"), "E_SHOT");
  EXPECT_ERROR(parseShot(R"({"size": {"width": 1e999, "height": 1}})"), "E_SHOT");
}

TEST(ParseShot, NamesTheLight) {
  const json lights = json::parse(
      R"([{"type": "ambient", "color": [1, 1, 1], "intensity": 1}, {"type": "spot", "color": [1, "x", 1]}])");
  const Error error = failure(with("/lights", lights));
  EXPECT_STREQ(error.what(), "shot.lights[1].color[1]: expected a number, got \"x\"");
  EXPECT_EQ(error.pointer, "/lights/1/color/1");
}

TEST(ParseShot, ADebugOutputIsReadWhereThereIsOne) {
  EXPECT_EQ(parseShot(standard().dump()).debugOutput, DebugOutput::kNone);
  EXPECT_EQ(parseShot(with("/debugOutput", "n").dump()).debugOutput, DebugOutput::kNormal);
  EXPECT_EQ(parseShot(with("/debugOutput", "encoded").dump()).debugOutput, DebugOutput::kEncoded);
  EXPECT_EQ(failure(with("/debugOutput", "N")).pointer, "/debugOutput");
}

}  // namespace
}  // namespace telar
