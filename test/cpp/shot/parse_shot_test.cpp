#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "expect_error.h"
#include "shading_terms.h"
#include "shot/visit_rows.inc"
#include "telar/error.h"
#include "telar/shot.h"

namespace telar {
namespace {

using nlohmann::json;

/// What resolveShot writes: "standard" for a shot without keys, "full" for one with every light and what else may be
/// absent. js/build/docs/resolved_shots.mjs has them.
json resolved(const char* name) {
  std::ifstream file(TELAR_SOURCE_DIR "/test/cpp/shot/resolved_shots.json");
  return json::parse(file).at(name);
}

json standard() { return resolved("standard"); }

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
  written["camera"] = resolved("full")["camera"];
  written["camera"].update(
      {{"position", {1, 2, 3}}, {"target", {4, 5, 6}}, {"up", {0, 0, 1}}, {"near", -1}, {"far", 8}});
  written["environment"].update({{"map", "/maps/sky.exr"}, {"intensity", 0.5}, {"rotation", -90}});
  written["modelLights"] = false;
  written["background"] = {0.25, 0.5, 1};
  written["toneMapping"] = "agx";
  written["exposure"] = 1.5;
  written["quality"].update({{"samples", 16}, {"resolve", "linear"}, {"noise", 0.5}, {"environmentSamples", 64}});
  written["variant"] = "navy";
  written["pose"] = resolved("full")["pose"];
  written["output"].update({{"format", "exr"}, {"quality", 1}, {"bitDepth", 32}, {"ppi", 300}, {"icc", true}});
  const Shot shot = parseShot(written.dump());
  EXPECT_EQ(shot.width, 512);
  EXPECT_EQ(shot.height, 256);
  EXPECT_EQ(shot.camera.projection, Projection::kOrthographic);
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
  EXPECT_EQ(shot.toneMapping, ToneMapping::kAgx);
  EXPECT_EQ(shot.exposure, 1.5);
  EXPECT_EQ(shot.samples, 16);
  EXPECT_EQ(shot.resolve, Resolve::kLinear);
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
  EXPECT_EQ(shot.camera.projection, Projection::kPerspective);
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
  const json blurred = resolved("full")["background"];
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
  json full = resolved("full");
  const Shot exposed = parseShot(full.dump());
  const double ev100 = std::log2(16.0 * 16.0 / 0.01 * 100 / 100);
  EXPECT_NEAR(exposed.exposure, 1 / (1.2 * std::exp2(ev100)), 1e-15);
  EXPECT_FALSE(exposed.lens->focusDistance);
  full["lens"].update({{"aperture", 1.4}, {"shutter", nullptr}, {"iso", nullptr}, {"focusDistance", 2}});
  const Shot blurred = parseShot(full.dump());
  EXPECT_EQ(blurred.exposure, 1);
  ASSERT_TRUE(blurred.lens);
  EXPECT_EQ(blurred.lens->aperture, 1.4);
  EXPECT_EQ(blurred.lens->focusDistance, 2);
}

TEST(ParseShot, ReadsWhatThePathTracerDoes) {
  EXPECT_FALSE(parseShot(standard().dump()).reference);
  json full = resolved("full");
  full["quality"].update({{"samples", 9}, {"seed", 1000000000}, {"transport", "occlusion"}, {"threads", 3}});
  const Shot shot = parseShot(full.dump());
  ASSERT_TRUE(shot.reference);
  EXPECT_EQ(shot.samples, 1);
  EXPECT_EQ(shot.reference->samples, 9);
  EXPECT_EQ(shot.reference->seed, 1000000000);
  EXPECT_EQ(shot.reference->transport, Shot::Reference::Transport::kOcclusion);
  EXPECT_EQ(shot.reference->threads, 3);
  full["quality"]["samples"] = 0;
  EXPECT_STREQ(failure(full).what(), "shot.quality.samples: expected an integer from 1 to 65536, got 0");
}

/// Another value for each number, no two alike, and none that a default is.
void renumber(json& value, int& next) {
  if (value.is_structured()) {
    for (json& inner : value) renumber(inner, next);
  } else if (value.is_number_float() || value.is_number_integer()) {
    value = next++ / 64.0;
  }
}

/// Looks for each member of a struct in the JSON that it was read from.
class Compare {
 public:
  explicit Compare(const json& from) : from_(from) {}

  template <class Member, class... Domain>
  void operator()(std::string_view key, const Member& member, const Domain&...) const {
    EXPECT_EQ(asJson(member), from_.at(std::string(key))) << key;
    ++compared;
  }
  void operator()(std::string_view key, int member, std::initializer_list<int>) const { (*this)(key, member); }
  template <class Members>
  void within(std::string_view key, const Members& members) const {
    members(Compare(from_.at(std::string(key))));
  }

  static inline int compared = 0;

 private:
  template <class Member>
  static json asJson(const Member& member) {
    if constexpr (std::is_enum_v<Member>)
      return namesOf(member)[static_cast<std::size_t>(member)];
    else
      return member;
  }
  static json asJson(const std::optional<double>& member) { return member ? json(*member) : json(); }
  static json asJson(const glm::dvec2& v) { return {v.x, v.y}; }
  static json asJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
  static json asJson(const glm::vec3& v) { return {v.x, v.y, v.z}; }

  const json& from_;
};

template <class Row>
void expectRead(Row row, const json& from) {
  visitRows(row, Compare(from));
}

TEST(ParseShot, ReadsEachNumberOfTheTableIntoItsMember) {
  json written = resolved("full");
  int next = 1;
  for (const char* key : {"camera", "environment", "lights", "background", "ground", "exposure"}) {
    renumber(written[key], next);
  }
  int size = 16;
  for (json& light : written["lights"]) {
    if (light.contains("shadow")) light["shadow"]["mapSize"] = size++;
  }
  written["quality"].update({{"samples", 9}, {"seed", 1000000000}, {"transport", "occlusion"}, {"bounces", 0}});
  written["lens"]["focusDistance"] = 2.5;
  const double factor = 0.01 * 100 / (120.0 * 16 * 16);
  Shot shot = parseShot(written.dump());
  shot.exposure /= factor;
  written["exposure"] = shot.exposure;
  Compare::compared = 0;
  expectRead<shot::Values>(shot, written);
  expectRead<shot::Size>(shot, written["size"]);
  expectRead(shot.camera, written["camera"]);
  expectRead(*shot.lens, written["lens"]);
  expectRead<shot::Environment>(shot.environment, written["environment"]);
  ASSERT_EQ(shot.lights.size(), written["lights"].size());
  for (std::size_t i = 0; i < shot.lights.size(); ++i) expectRead(shot.lights[i], written["lights"][i]);
  expectRead<shot::EnvironmentBackground>(shot.background, written["background"]);
  expectRead(*shot.ground, written["ground"]);
  expectRead(*shot.reference, written["quality"]);
  expectRead(*shot.pose, written["pose"]);
  expectRead(shot.output, written["output"]);
  EXPECT_GT(Compare::compared, 80);
}

TEST(ParseShot, ReadsALight) {
  const std::vector<Shot::Light> read = parseShot(resolved("full").dump()).lights;
  using Type = Shot::Light::Type;
  ASSERT_EQ(read.size(), 7u);
  EXPECT_EQ(read[2].type, Type::kDirectional);
  EXPECT_EQ(read[2].position, glm::dvec3(1, 3, 2));
  EXPECT_EQ(read[2].shadow.mapSize, 1024);
  EXPECT_LT(read[2].shadow.left, read[2].shadow.right);
  EXPECT_GT(read[4].shadow.focus, 0);
  EXPECT_NEAR(read[4].angle, 1.0471975511965976, 1e-15);
  EXPECT_EQ(read[6].type, Type::kDisk);
  EXPECT_EQ(read[6].radius, 1);
}

TEST(ParseShot, ReadsTheGround) {
  EXPECT_FALSE(parseShot(standard().dump()).ground);
  EXPECT_EQ(parseShot(resolved("full").dump()).ground->opacity, 0.5);
  EXPECT_STREQ(failure(with("/ground", "floor")).what(), "shot.ground: expected one of none, got \"floor\"");
}

/// A light that casts a shadow, its `shadow` less or with one key.
json casting(const std::string& key, const json& value) {
  json shot = resolved("full");
  json light = shot["lights"][3];
  light["shadow"].erase(key);
  if (!value.is_null()) light["shadow"][key] = value;
  shot["lights"] = json::array({light});
  return shot;
}

TEST(ParseShot, RefusesShadowsOfAnotherType) {
  EXPECT_EQ(failure(casting("bias", 0.5)).code, "none");
  const std::vector<std::pair<const char*, json>> wrong{
      {"mapSize", 0}, {"mapSize", 4097}, {"mapSize", -512},       {"mapSize", 64.5},   {"mapSize", 1e300},
      {"bias", "0"},  {"far", nullptr},  {"normalBias", nullptr}, {"intensity", false}};
  for (const auto& [key, value] : wrong) {
    const Error error = failure(casting(key, value));
    EXPECT_EQ(error.code, "E_SHOT") << key << " " << value;
    ASSERT_TRUE(error.pointer) << key << " " << value;
    EXPECT_EQ(*error.pointer, std::string("/lights/0/shadow/") + key);
  }
}

/// Keys that say nothing to the renderer: what there is one of, where settings are from, and what others are made of.
bool isNotRead(const std::string& pointer) {
  const std::vector<std::string> keys{"/quality/preset", "/scale",           "/materials",     "/metering",
                                      "/look",           "/background/type", "/ground/shadow", "/ground/gap"};
  return std::ranges::find(keys, pointer) != keys.end();
}

/// @return pointers of the keys of objects, at any depth
std::vector<json::json_pointer> keysOf(const json& value, const json::json_pointer& at) {
  std::vector<json::json_pointer> keys;
  for (const auto& [key, inner] : value.items()) {
    const json::json_pointer here = value.is_array() ? at / static_cast<std::size_t>(std::stoul(key)) : at / key;
    if (value.is_object() && !isNotRead(here.to_string())) keys.push_back(here);
    if (!inner.is_structured()) continue;
    const auto deeper = keysOf(inner, here);
    keys.insert(keys.end(), deeper.begin(), deeper.end());
  }
  return keys;
}

TEST(ParseShot, EveryKeyIsNeeded) {
  std::size_t removed = 0;
  for (const char* name : {"standard", "full"}) {
    const json written = resolved(name);
    for (const json::json_pointer& where : keysOf(written, json::json_pointer())) {
      json shot = written;
      shot[where.parent_pointer()].erase(where.back());
      const Error error = failure(shot);
      EXPECT_EQ(error.code, "E_SHOT") << where;
      EXPECT_EQ(error.pointer, where.to_string());
      EXPECT_NE(std::string(error.what()).find("expected a value, got nothing"), std::string::npos) << error.what();
      ++removed;
    }
  }
  EXPECT_GE(removed, 120u);
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
      {"/camera/projection", "fish", "shot.camera.projection: expected one of perspective, orthographic, got \"fish\""},
      {"/camera/position", {1, 2}, "shot.camera.position: expected an array of 3 numbers, got an array of 2"},
      {"/camera/fovY", "30", "shot.camera.fovY: expected a number, got \"30\""},
      {"/environment/map", 4, "shot.environment.map: expected a string, got 4"},
      {"/lights", {{"type", "spot"}}, "shot.lights: expected an array, got an object"},
      {"/modelLights", 1, "shot.modelLights: expected true or false, got 1"},
      {"/background", {0, 1}, "shot.background: expected an array of 3 numbers, got an array of 2"},
      {"/background", "red", "shot.background: expected one of transparent, environment, got \"red\""},
      {"/quality/resolve", nullptr, "shot.quality.resolve: expected one of encoded, linear, got null"},
      {"/quality/samples", 3, "shot.quality.samples: expected one of 1, 4, 16, 64, 256, 1024, got 3"},
      {"/quality/noise", nullptr, "shot.quality.noise: expected a number, got null"},
      {"/quality/environmentSamples", -1,
       "shot.quality.environmentSamples: expected an integer from 0 to 4096, got -1"},
      {"/variant", json::object(), "shot.variant: expected a string, got an object"},
      {"/pose/animation", -1, "shot.pose.animation: expected an integer from 0 to 2147483647, got -1"},
      {"/output/bitDepth", 16, "nothing was thrown"},
      {"/output/bitDepth", 12, "shot.output.bitDepth: expected one of 8, 16, 32, got 12"},
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

TEST(ParseShot, TrustsTheValuesThatResolveShotHasLookedAt) {
  EXPECT_EQ(parseShot(with("/camera/near", 1e-12).dump()).camera.near, 1e-12);
  EXPECT_EQ(parseShot(with("/exposure", -1).dump()).exposure, -1);
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
  EXPECT_EQ(parseShot(with("/debugOutput", "n").dump()).debugOutput, DebugOutput::kN);
  EXPECT_EQ(parseShot(with("/debugOutput", "encoded").dump()).debugOutput, DebugOutput::kEncoded);
  EXPECT_EQ(failure(with("/debugOutput", "N")).pointer, "/debugOutput");
}

}  // namespace
}  // namespace telar
