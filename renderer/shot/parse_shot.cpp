#include <bit>
#include <nlohmann/json.hpp>

#include "shot/json_path.h"
#include "telar/error.h"
#include "telar/shot.h"

namespace telar {
namespace {

using shot::JsonPath;

// As js/shot/schema.mjs and js/shot/fields.mjs: what resolveShot takes is taken here.
constexpr double TINY = 1e-30;      ///< smallest length that something is divided by, metres
constexpr double FOCUS_MIN = 1e-9;  ///< least part of a spot's cone

constexpr int SIZE_MAX_PX = 8192;
constexpr int SHADOW_MAP_MAX = 4096;  ///< texels on a side
constexpr int SAMPLES_MAX = 1024;     ///< a pixel
constexpr double NOISE_MAX = 64;
constexpr int ENVIRONMENT_SAMPLES_MAX = 4096;
constexpr int REFERENCE_SAMPLES_MAX = 65536, REFERENCE_BOUNCES_MAX = 64, REFERENCE_THREADS_MAX = 256;
constexpr int PPI_MAX = 65535;  ///< what JFIF's 16-bit density field holds

/// A distance above 0.
double readDistance(const JsonPath& json) {
  const double distance = json.number(0);
  if (distance == 0) json.fail("a distance above 0");
  return distance;
}

Shot::Camera readCamera(const JsonPath& json) {
  Shot::Camera camera;
  camera.perspective = json.at("projection").choice({"orthographic", "perspective"}) == 1;
  camera.position = json.at("position").vec3();
  camera.target = json.at("target").vec3();
  camera.up = json.at("up").vec3();
  if (camera.perspective) {
    camera.fovY = json.at("fovY").number(1e-3, 179.999);
  } else {
    camera.height = json.at("height").number(TINY);
  }
  camera.near = camera.perspective ? readDistance(json.at("near")) : json.at("near").number();
  camera.far = json.at("far").number();
  if (!(camera.far > camera.near)) json.at("far").fail("a distance beyond near");
  if (camera.position == camera.target) json.at("target").fail("a point other than position");
  return camera;
}

/// Depth of field, and the exposure of the lens: 1 / (1.2 * 2^EV100), EV100 = log2(N^2 / t * 100 / S).
/// src: Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering", section 5.1.2
void readLens(const JsonPath& json, Shot& shot) {
  if (json.isNull()) return;
  const double aperture = json.at("aperture").number(0.1);
  const JsonPath focusDistance = json.at("focusDistance"), shutter = json.at("shutter"), iso = json.at("iso");
  if (!focusDistance.isNull()) shot.lens = {aperture, focusDistance.number(TINY)};
  if (shutter.isNull() || iso.isNull()) return;
  shot.exposure *= shutter.number(0) * iso.number(0) / (120 * aperture * aperture);
}

Shot::Reference readReference(const JsonPath& json) {
  using Transport = Shot::Reference::Transport;
  Shot::Reference reference;
  reference.samples = json.at("samples").integer(1, REFERENCE_SAMPLES_MAX);
  reference.seed = static_cast<std::uint64_t>(json.at("seed").integer(0, std::numeric_limits<int>::max()));
  reference.transport = std::array{Transport::kGlobal, Transport::kOcclusion,
                                   Transport::kDirect}[json.at("transport").choice({"global", "occlusion", "direct"})];
  reference.bounces = json.at("bounces").integer(0, REFERENCE_BOUNCES_MAX);
  reference.threads = json.at("threads").integer(0, REFERENCE_THREADS_MAX);
  return reference;
}

Shot::Environment readEnvironment(const JsonPath& json) {
  using Source = Shot::Environment::Source;
  Shot::Environment environment;
  const JsonPath map = json.at("map");
  if (map.isObject()) {
    map.at("bytes").number(1);  // the bytes themselves travel beside the JSON
    environment.source = Source::kBytes;
  } else {
    const std::string name = map.string();
    environment.source = name == "none" ? Source::kNone : name == "studio" ? Source::kStudio : Source::kPath;
    if (name.empty()) map.fail("none, studio, or the path of an .hdr or .exr file");
    if (environment.source == Source::kPath) environment.path = name;
  }
  environment.intensity = json.at("intensity").number(0);
  environment.rotation = json.at("rotation").number();
  return environment;
}

Shot::Light::Shadow readShadow(const JsonPath& json, Shot::Light::Type type) {
  using Type = Shot::Light::Type;
  Shot::Light::Shadow shadow;
  shadow.mapSize = json.at("mapSize").integer(16, SHADOW_MAP_MAX);
  shadow.radius = json.at("radius").number(0, 25);
  shadow.intensity = json.at("intensity").number(0, 1);
  shadow.bias = json.at("bias").number(-1, 1);
  shadow.normalBias = json.at("normalBias").number(0);
  const bool directional = type == Type::kDirectional;
  shadow.near = directional ? json.at("near").number() : readDistance(json.at("near"));
  shadow.far = json.at("far").number();
  if (!(shadow.far > shadow.near)) json.at("far").fail("a distance beyond near");
  if (directional) {
    shadow.left = json.at("left").number();
    shadow.right = json.at("right").number();
    shadow.bottom = json.at("bottom").number();
    shadow.top = json.at("top").number();
    if (!(shadow.right > shadow.left)) json.at("right").fail("a number above left");
    if (!(shadow.top > shadow.bottom)) json.at("top").fail("a number above bottom");
  }
  if (type == Type::kSpot) shadow.focus = json.at("focus").number(FOCUS_MIN, 1);
  return shadow;
}

/// castShadow, and what it needs.
void readLightShadow(const JsonPath& json, Shot::Light& light) {
  light.castShadow = json.at("castShadow").boolean();
  if (light.castShadow) light.shadow = readShadow(json.at("shadow"), light.type);
}

Shot::Light readLight(const JsonPath& json) {
  using Type = Shot::Light::Type;
  Shot::Light light;
  light.type = std::array{Type::kAmbient, Type::kHemisphere, Type::kDirectional, Type::kPoint,
                          Type::kSpot,    Type::kRect,       Type::kDisk}[json.at("type").choice(
      {"ambient", "hemisphere", "directional", "point", "spot", "rect", "disk"})];
  light.color = json.at("color").color();
  light.intensity = json.at("intensity").number(0);
  if (light.type == Type::kHemisphere) light.groundColor = json.at("groundColor").color();
  if (light.type == Type::kAmbient || light.type == Type::kHemisphere) return light;
  light.position = json.at("position").vec3();
  if (light.type != Type::kPoint) light.target = json.at("target").vec3();
  const bool area = light.type == Type::kRect || light.type == Type::kDisk;
  if (!area) readLightShadow(json, light);
  if (light.type == Type::kDirectional) return light;
  if (light.type == Type::kRect) {
    light.width = json.at("width").number(0);
    light.height = json.at("height").number(0);
  }
  if (light.type == Type::kDisk) light.radius = json.at("radius").number(0);
  if (area) return light;
  light.range = json.at("range").number(0);
  if (light.type == Type::kSpot) {
    light.angle = json.at("angle").number(0, 1.5707963267948966);
    light.penumbra = json.at("penumbra").number(0, 1);
  }
  return light;
}

Shot::Background readBackground(const JsonPath& json) {
  using Type = Shot::Background::Type;
  if (json.isArray()) return {Type::kColor, json.color()};
  if (json.isObject()) {
    json.at("type").choice({"environment"});
    return {Type::kEnvironment, {}, json.at("blur").number(0, 1)};
  }
  return {json.choice({"transparent", "environment"}) == 0 ? Type::kTransparent : Type::kEnvironment, {}};
}

std::optional<Shot::Ground> readGround(const JsonPath& json) {
  if (!json.isObject()) {
    json.choice({"none"});
    return std::nullopt;
  }
  if (!json.at("shadow").boolean()) json.at("shadow").fail("true");
  const JsonPath size = json.at("size");
  if (size.size() != 2) size.fail("an array of 2 numbers");
  return Shot::Ground{json.at("opacity").number(0, 1),
                      json.at("position").vec3(),
                      {size.at(std::size_t{0}).number(TINY), size.at(1).number(TINY)}};
}

OutputOptions readOutput(const JsonPath& json) {
  using Format = OutputOptions::Format;
  OutputOptions output;
  output.format = std::array{Format::kPng, Format::kJpeg, Format::kWebp, Format::kTiff, Format::kExr, Format::kRaw}
      [json.at("format").choice({"png", "jpeg", "webp", "tiff", "exr", "raw"})];
  output.quality = json.at("quality").integer(1, 100);
  output.bitDepth = json.at("bitDepth").integer(8, 32);
  const int depth = output.bitDepth;
  const bool eight = output.format != Format::kExr && depth == 8;
  const bool sixteen =
      (output.format == Format::kPng || output.format == Format::kTiff || output.format == Format::kExr) && depth == 16;
  const bool floats = (output.format == Format::kExr || output.format == Format::kRaw) && depth == 32;
  if (!eight && !sixteen && !floats)
    json.at("bitDepth").fail("a bit depth that " + json.at("format").string() + " has");
  output.ppi = json.at("ppi").number(0, PPI_MAX);
  output.icc = json.at("icc").boolean();
  return output;
}

DebugOutput readDebugOutput(const JsonPath& json) {
  const std::size_t position =
      json.choice({"n", "baseColor", "alpha", "metallic", "perceptualRoughness", "f0", "NoV", "dfg", "radiance",
                   "irradiance", "direct", "indirect", "transmitted", "linear", "encoded"});
  return static_cast<DebugOutput>(position + 1);
}

std::optional<Pose> readPose(const JsonPath& json) {
  if (json.isNull()) return std::nullopt;
  return Pose{json.at("animation").integer(0, std::numeric_limits<int>::max()), json.at("time").number()};
}

void readQuality(const JsonPath& json, Shot& shot) {
  if (json.has("preset") && json.at("preset").string() == "reference") {
    shot.samples = 1;
    shot.reference = readReference(json);
    return;
  }
  const JsonPath samples = json.at("samples");
  shot.samples = samples.integer(1, SAMPLES_MAX);
  if (!std::has_single_bit(static_cast<unsigned>(shot.samples)) ||
      std::bit_width(static_cast<unsigned>(shot.samples)) % 2 == 0)
    samples.fail("1, 4, 16, 64, 256 or 1024");
  const JsonPath resolve = json.at("resolve");
  shot.linearResolve = resolve.choice({"encoded", "linear"}) == 1;
  if (shot.samples > Shot::SAMPLES_OF_A_PASS && !shot.linearResolve) resolve.fail("linear with so many samples");
  shot.noise = json.at("noise").number(0, NOISE_MAX);
  shot.environmentSamples = json.at("environmentSamples").integer(0, ENVIRONMENT_SAMPLES_MAX);
}

/// A name, or for the principled shadings their base with every slot.
void readShading(const JsonPath& json, Shot& shot) {
  if (!json.isObject()) {
    shot.shading = json.choice({"three", "fabric"}) == 0 ? ShadingModel::kThree : ShadingModel::kFabric;
    return;
  }
  shot.shading =
      json.at("base").choice({"three-r115", "disney-2012"}) == 0 ? ShadingModel::kThreeR115 : ShadingModel::kDisney2012;
#define TELAR_SHADING_READ(define, member, ...) \
  shot.terms.member = static_cast<int>(json.at(#member).choice({__VA_ARGS__}));
  TELAR_SHADING_SLOTS(TELAR_SHADING_READ)
#undef TELAR_SHADING_READ
}

Shot readShot(const JsonPath& json) {
  Shot shot;
  shot.width = json.at("size").at("width").integer(1, SIZE_MAX_PX);
  shot.height = json.at("size").at("height").integer(1, SIZE_MAX_PX);
  shot.camera = readCamera(json.at("camera"));
  shot.environment = readEnvironment(json.at("environment"));
  const JsonPath lights = json.at("lights");
  for (std::size_t i = 0; i < lights.size(); ++i) shot.lights.push_back(readLight(lights.at(i)));
  shot.modelLights = json.at("modelLights").boolean();
  shot.background = readBackground(json.at("background"));
  shot.ground = readGround(json.at("ground"));
  readShading(json.at("shading"), shot);
  const JsonPath toneMapping = json.at("toneMapping");
  toneMapping.choice({"none", "linear", "reinhard", "cineon", "aces", "agx", "neutral"});
  shot.toneMapping = toneMapping.string();
  shot.exposure = json.at("exposure").number(0);
  readLens(json.at("lens"), shot);
  readQuality(json.at("quality"), shot);
  const JsonPath variant = json.at("variant");
  if (!variant.isNull()) shot.variant = variant.string();
  shot.pose = readPose(json.at("pose"));
  shot.output = readOutput(json.at("output"));
  if (json.has("debugOutput")) shot.debugOutput = readDebugOutput(json.at("debugOutput"));
  return shot;
}

}  // namespace

Shot parseShot(std::string_view resolvedJson) {
  nlohmann::json root;
  try {
    root = nlohmann::json::parse(resolvedJson);
  } catch (const nlohmann::json::exception&) {
    throw Error("E_SHOT", "the shot is not JSON: pass what resolveShot returns");
  }
  return readShot(JsonPath(root));
}

}  // namespace telar
