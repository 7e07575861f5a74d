#include "extreme_rows.h"

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "shading_terms.h"
#include "telar/codec.h"

namespace telar::numerics {
namespace {

using Light = Shot::Light;

constexpr int SIZE = 64;

/// Every layer at once: what is drawn where nothing else is said.
Material everything() {
  Material m;
  m.baseColorFactor = {0.8f, 0.5f, 0.3f, 1};
  m.metallicFactor = 0.3f;
  m.roughnessFactor = 0.4f;
  m.physical = true;
  m.layers.clearcoatFactor = 0.5f;
  m.layers.clearcoatRoughnessFactor = 0.2f;
  m.layers.sheenColorFactor = {0.3f, 0.2f, 0.4f};
  m.layers.sheenRoughnessFactor = 0.4f;
  m.layers.anisotropyStrength = 0.6f;
  m.layers.diffuseRoughnessFactor = 0.5f;
  m.doubleSided = true;
  return m;
}

Primitive ball() { return test::spherePrimitive(1, 16); }

Image8 texels(std::initializer_list<glm::u8vec4> list) {
  Image8 image{static_cast<std::uint32_t>(list.size()), 1, {}};
  for (const glm::u8vec4& t : list)
    for (int c = 0; c < 4; ++c) image.pixels.push_back(t[c]);
  return image;
}

Light sun(const glm::dvec3& from, double lux = 3) {
  Light light{Light::Type::kDirectional};
  light.position = from;
  light.intensity = lux;
  return light;
}

Light lamp(const glm::dvec3& at, double candela = 3) {
  Light light{Light::Type::kPoint};
  light.position = at;
  light.intensity = candela;
  return light;
}

std::vector<std::byte> exrOf(const std::vector<glm::vec3>& colors, std::uint32_t width) {
  Frame frame{width, static_cast<std::uint32_t>(colors.size()) / width, PixelType::kRgbaF32, {}};
  std::vector<float> pixels;
  for (const glm::vec3& c : colors) pixels.insert(pixels.end(), {c.x, c.y, c.z, 1.0f});
  frame.pixels.resize(pixels.size() * sizeof(float));
  std::memcpy(frame.pixels.data(), pixels.data(), frame.pixels.size());
  OutputOptions output;
  output.format = OutputOptions::Format::kExr;
  output.bitDepth = 32;
  return encode(frame, output, CancelToken());
}

/// Radiance 1 everywhere but for one texel.
std::vector<std::byte> evenBut(const glm::vec3& odd) {
  std::vector<glm::vec3> colors(64 * 32, glm::vec3(1));
  colors[10 * 64 + 20] = odd;
  return exrOf(colors, 64);
}

class ExtremeRows {
 public:
  explicit ExtremeRows(ShadingModel shading) : shading_(shading) {}

  /// A lit ball of every layer, to be changed.
  ExtremeRow& add(const std::string& name, Material material = everything(), Primitive primitive = ball()) {
    ExtremeRow row;
    row.name = name;
    row.scene = test::sceneOf(std::move(primitive), std::move(material));
    row.shot = test::shotOf(SIZE);
    row.shot.output.bitDepth = 32;
    row.shot.samples = 1;
    row.shot.shading = shading_;
    row.shot.terms = termsOf(shading_);
    row.shot.lights = {sun({1, 2, 3}), lamp({-2, 1, 2})};
    row.shot.environment.source = Shot::Environment::Source::kStudio;
    list.push_back(std::move(row));
    return list.back();
  }
  std::vector<ExtremeRow> list;

 private:
  ShadingModel shading_;
};

void addEnvironments(ExtremeRows& rows) {
  constexpr float INF = std::numeric_limits<float>::infinity(), NOT = std::numeric_limits<float>::quiet_NaN();
  const std::pair<const char*, glm::vec3> odd[] = {{"infinite", glm::vec3(INF)},
                                                   {"NaN", glm::vec3(NOT)},
                                                   {"-1", glm::vec3(-1)},
                                                   {"1e5", glm::vec3(1e5f)},
                                                   {"1.6e9", glm::vec3(1.6e9f)}};
  for (const auto& [name, value] : odd) {
    ExtremeRow& row = rows.add(std::string("environment with one texel ") + name);
    row.shot.environment.source = Shot::Environment::Source::kBytes;
    row.environment = evenBut(value);
  }
  rows.add("environment of intensity 1e30").shot.environment.intensity = 1e30;
}

void addLights(ExtremeRows& rows) {
  rows.add("lamp on the surface").shot.lights[1].position = {0, 0, 1};
  rows.add("lamp inside").shot.lights[1].position = {0, 0, 0};
  rows.add("lamp in the eye").shot.lights[1].position = {0, 0, 5};
  ExtremeRow& behind = rows.add("parallel view against the light");
  behind.shot.lights[0] = sun({0, 0, -5});
  behind.shot.camera.projection = Projection::kOrthographic;
  behind.shot.camera.height = 2.4;
  rows.add("sun of 1.6e9 lux").shot.lights[0].intensity = 1.6e9;
  ExtremeRow& blinding = rows.add("sun of 1e30 lux and a colour of 1e30");
  blinding.shot.lights[0].intensity = 1e30;
  blinding.shot.lights[0].color = glm::vec3(1e30f);
  rows.add("lamp of 1e30 candela on the surface").shot.lights[1] = lamp({0, 0, 1}, 1e30);
  rows.add("sun without a direction").shot.lights[0].position = {0, 0, 0};
  rows.add("lamp of range 1e-30").shot.lights[1].range = 1e-30;
}

void addSurfaces(ExtremeRows& rows) {
  Primitive noUv = ball(), flatUv = ball(), zeroNormals = ball(), opposite = ball(), flat = ball();
  noUv.uvs[0].clear();
  flatUv.uvs[0].assign(flatUv.positions.size(), glm::vec2(0.5f));
  zeroNormals.normals.assign(zeroNormals.positions.size(), glm::vec3(0));
  for (std::size_t i = 0; i < opposite.normals.size(); i += 2) opposite.normals[i] *= -1.0f;  // they cancel between
  flat.normals.clear();
  Material mapped = everything();
  mapped.normalTexture.image = 0;
  const auto withMap = [&](const char* name, Primitive primitive, std::initializer_list<glm::u8vec4> map) {
    rows.add(name, mapped, std::move(primitive)).scene->images = {texels(map)};
  };
  rows.add("no texture coordinates", everything(), noUv);
  withMap("normal map on coordinates of no extent", flatUv, {{128, 128, 255, 255}});
  withMap("normal map of black and white", ball(), {{0, 0, 0, 255}, {255, 255, 255, 255}});
  withMap("normal map of no length", ball(), {{127, 127, 127, 255}, {128, 128, 128, 255}});
  withMap("normal map on flat faces", flat, {{128, 0, 255, 255}, {0, 128, 0, 255}});
  rows.add("vertex normals of length 0", everything(), zeroNormals);
  rows.add("vertex normals that cancel", everything(), opposite);
  Material fuzzless = everything();
  fuzzless.layers.sheenRoughnessTexture.image = fuzzless.layers.sheenColorTexture.image = 0;
  rows.add("sheen map of 0", fuzzless).scene->images = {texels({{255, 255, 255, 0}})};
  Material occluded = everything();
  occluded.occlusionTexture.image = 0;
  rows.add("occlusion map of 0", occluded).scene->images = {texels({{0, 0, 0, 0}})};
  Material clear = everything();
  clear.alphaMode = AlphaMode::kBlend;
  clear.baseColorFactor.a = 0;
  rows.add("alpha 0", clear);
  Material glass = everything();
  glass.layers.transmissionFactor = 1;
  glass.layers.thicknessFactor = 1;
  glass.layers.attenuationColor = glm::vec3(0);
  glass.layers.attenuationDistance = 1e-12f;
  glass.layers.ior = 1000;
  rows.add("glass that lets nothing through", glass);
}

void addTransforms(ExtremeRows& rows) {
  const std::pair<const char*, glm::dvec3> scales[] = {{"scale (1, 1, 0)", {1, 1, 0}},
                                                       {"scale (-1, 2, 0.5)", {-1, 2, 0.5}},
                                                       {"scale 0", {0, 0, 0}},
                                                       {"scale (1e-6, 1, 1)", {1e-6, 1, 1}}};
  for (const auto& [name, scale] : scales) {
    ExtremeRow& row = rows.add(name);
    row.scene->nodes[0].world = glm::rotate(glm::scale(glm::dmat4(1), scale), 0.4, glm::dvec3(1, 1, 0));
  }
}

double mostOf(const Frame& frame) {
  double most = 0;
  for (std::uint32_t y = 0; y < frame.height; ++y)
    for (std::uint32_t x = 0; x < frame.width; ++x) most = std::max<double>(most, test::pixelF(frame, x, y)[0]);
  return most;
}

void addExposures(ExtremeRows& rows) {
  for (const double exposure : {0.0, 1e6, 1e30}) {
    ExtremeRow& row = rows.add("exposure " + std::string(exposure == 0 ? "0" : exposure == 1e6 ? "1e6" : "1e30"));
    row.shot.exposure = exposure;
    row.measure = mostOf;
    row.low = row.high = exposure == 0 ? 0 : 65504;  // nothing, or the largest half
  }
}

}  // namespace

std::vector<ExtremeRow> extremeRows(ShadingModel shading) {
  ExtremeRows rows(shading);
  addEnvironments(rows);
  addLights(rows);
  addSurfaces(rows);
  addTransforms(rows);
  addExposures(rows);
  return std::move(rows.list);
}

}  // namespace telar::numerics
