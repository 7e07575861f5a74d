#include "fuzz_scene.h"

#include <array>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "frames.h"
#include "pass/plan/texture_slots.h"
#include "shading_terms.h"

namespace telar::numerics {
namespace {

using Light = Shot::Light;

/// What all bodies of a frame have in common.
struct Kind {
  Layers layers;
  std::array<bool, pass::TEXTURE_SLOTS.size()> maps{};
  bool nearest, flat, tangents, uvs, colors, doubleSided, unlit;
  AlphaMode alpha;

  explicit Kind(Seeded& r) : layers(Layers::random(r)) {
    const bool textured = r.chance(0.6);
    for (bool& map : maps) map = textured && r.chance(0.3);
    nearest = r.chance(0.3);
    flat = r.chance(0.1);
    tangents = r.chance(0.3);
    uvs = r.chance(0.9);
    colors = r.chance(0.2);
    doubleSided = r.chance(0.4);
    unlit = r.chance(0.02);
    alpha = r.chance(0.2) ? (r.chance(0.5) ? AlphaMode::kMask : AlphaMode::kBlend) : AlphaMode::kOpaque;
  }
};

/// All of one size: a software driver compiles a program again for each kind of texture.
Image8 image(const std::function<glm::u8vec4(std::uint32_t, std::uint32_t)>& texel) {
  constexpr std::uint32_t SIZE = 16;
  Image8 out{SIZE, SIZE, {}};
  for (std::uint32_t y = 0; y < SIZE; ++y) {
    for (std::uint32_t x = 0; x < SIZE; ++x) {
      const glm::u8vec4 t = texel(x, y);
      for (int c = 0; c < 4; ++c) out.pixels.push_back(t[c]);
    }
  }
  return out;
}

/// Noise, nothing, everything, stripes of both, a flat normal map, and a normal that lies in the surface.
std::vector<Image8> images() {
  Seeded noise(99);
  return {
      image([&](auto, auto) {
        const auto b = [&] { return static_cast<std::uint8_t>(noise.below(256)); };
        const std::uint8_t x = b(), y = b(), z = b();
        return glm::u8vec4(x, y, z, b());
      }),
      image([](auto, auto) { return glm::u8vec4(0); }),
      image([](auto, auto) { return glm::u8vec4(255); }),
      image([](auto x, auto) { return glm::u8vec4(x % 2 ? 255 : 0); }),
      image([](auto, auto) { return glm::u8vec4(128, 128, 255, 255); }),
      image([](auto, auto) { return glm::u8vec4(0, 255, 127, 1); }),
  };
}

glm::mat3 uvTransform(Seeded& r) {
  const auto scale = [&] { return r.edged(-3, 3, {0, 1e-6, 1e6, 1}, 0.3); };
  glm::dmat3 m(1.0);
  const double angle = r.between(-3, 3), x = scale(), y = scale();
  m[0] = {x * std::cos(angle), -x * std::sin(angle), 0};
  m[1] = {y * std::sin(angle), y * std::cos(angle), 0};
  m[2] = {r.between(-2, 2), r.between(-2, 2), 1};
  return glm::mat3(m);
}

Material bodyMaterial(Seeded& r, const Kind& kind, std::size_t imageCount) {
  Material m = randomMaterial(r, kind.layers);
  m.baseColorFactor.a = static_cast<float>(r.edged(0, 1, {0, 1}));
  m.alphaMode = kind.alpha;
  m.doubleSided = kind.doubleSided;
  m.unlit = kind.unlit;
  m.normalScale = static_cast<float>(r.edged(-2, 2, {0, 1, -1e6, 1e6}));
  m.layers.clearcoatNormalScale = m.normalScale;
  m.occlusionStrength = static_cast<float>(r.edged(0, 1, {0, 1}));
  if (r.chance(0.3)) m.emissiveFactor = glm::vec3(static_cast<float>(r.edged(0, 1, {65504})));
  for (std::size_t i = 0; i < kind.maps.size(); ++i) {
    if (!kind.maps[i]) continue;
    // The table gives them to read.
    auto& texture = const_cast<TextureRef&>(pass::TEXTURE_SLOTS[i].texture(m));
    texture.image = static_cast<int>(r.below(imageCount));
    texture.uvTransform = uvTransform(r);
    if (kind.nearest) texture.sampler.magFilter = texture.sampler.minFilter = 9728;
  }
  return m;
}

Primitive body(Seeded& r, const Kind& kind) {
  Primitive p = test::spherePrimitive(0.45f, 6);
  const std::size_t count = p.positions.size();
  if (kind.tangents)
    for (const glm::vec3& n : p.normals)
      p.tangents.emplace_back(glm::normalize(glm::cross(n, glm::vec3(0.3f, 1, 0.2f))), r.chance(0.5) ? 1.0f : -1.0f);
  if (kind.flat) p.normals.clear();
  if (!kind.uvs) {
    p.uvs[0].clear();
  } else if (r.chance(0.1)) {
    p.uvs[0].assign(count, glm::vec2(static_cast<float>(r.edged(0, 1, {0, 1e6}))));  // of no extent
  }
  if (kind.colors) {
    const float most = r.chance(0.1) ? 65504.0f : 1.0f;
    for (std::size_t i = 0; i < count; ++i) p.colors.emplace_back(glm::vec3(static_cast<float>(r.unit()) * most), 1);
  }
  return p;
}

glm::dmat4 placed(Seeded& r, int index) {
  const double half = FuzzFrame::SIDE / 2.0 - 0.5;
  glm::dmat4 m = glm::translate(
      glm::dmat4(1), glm::dvec3(index % FuzzFrame::SIDE - half, half - index / FuzzFrame::SIDE, r.between(-0.2, 0.2)));
  m = glm::rotate(m, r.between(-3, 3), glm::normalize(glm::dvec3(r.between(-1, 1), r.between(-1, 1), 0.3)));
  if (r.chance(0.2)) {
    const auto axis = [&] { return r.edged(-1, 1, {1, -1, 1e-6}, 0.2); };
    const double x = axis(), y = axis();
    m = glm::scale(m, glm::dvec3(x, y, axis()));
  }
  return m;
}

/// Somewhere about the bodies, in their midst, or on the surface of one.
glm::dvec3 place(Seeded& r) {
  if (r.chance(0.1)) return {r.chance(0.5) ? 0.5 : 0.05, 0.5, r.edged(-0.5, 0.5, {0, 0.45})};
  const double far = r.edged(1, 20, {1, 1e6});
  return {r.between(-far, far), r.between(-far, far), r.between(-far, far)};
}

double intensity(Seeded& r) { return r.chance(0.1) ? (r.chance(0.5) ? 1.6e9 : 1e30) : std::pow(10, r.between(-4, 4)); }

Light randomLight(Seeded& r) {
  constexpr std::array TYPES{Light::Type::kAmbient, Light::Type::kHemisphere, Light::Type::kDirectional,
                             Light::Type::kPoint,   Light::Type::kSpot,       Light::Type::kRect,
                             Light::Type::kDisk};
  Light light{TYPES[r.below(TYPES.size())]};
  light.color = {static_cast<float>(r.unit()), static_cast<float>(r.edged(0, 1, {0, 1})), 1};
  light.groundColor = {0, static_cast<float>(r.unit()), 1};
  light.intensity = intensity(r);
  light.position = place(r);
  light.target = r.chance(0.05) ? light.position : place(r);
  if (r.chance(0.1)) light.position = {0, 0, -30}, light.target = {0, 0, 0};  // straight behind
  light.range = r.edged(0, 30, {0, 1e-6, 1e30});
  light.angle = r.edged(0.05, 1.57, {1e-6, 1.5707963267948966});
  light.penumbra = r.edged(0, 1, {0, 1});
  light.width = r.edged(0.1, 5, {1e-6, 1e6});
  light.height = r.edged(0.1, 5, {1e-6, 1e6});
  light.radius = r.edged(0.1, 5, {1e-6, 1e6});
  return light;
}

void setCamera(Seeded& r, Shot& shot) {
  constexpr double HEIGHT = FuzzFrame::SIDE, DISTANCE = 30;
  shot.camera.position = {0, 0, DISTANCE};
  shot.camera.near = DISTANCE - 2;
  shot.camera.far = DISTANCE + 2;
  shot.camera.projection = r.chance(0.7) ? Projection::kPerspective : Projection::kOrthographic;
  shot.camera.fovY = glm::degrees(2 * std::atan(HEIGHT / 2 / DISTANCE));
  shot.camera.height = HEIGHT;
}

}  // namespace

FuzzFrame::FuzzFrame(std::uint64_t seed, ShadingModel shading) : scene(std::make_shared<Scene>()) {
  Seeded r(seed);
  const Kind kind(r);
  scene->images = images();
  for (int i = 0; i < MATERIALS; ++i) {
    Primitive p = body(r, kind);
    p.material = i;
    scene->materials.push_back(bodyMaterial(r, kind, scene->images.size()));
    scene->meshes.push_back({"body", {std::move(p)}});
    Node node;
    node.mesh = i;
    node.world = placed(r, i);
    scene->nodes.push_back(node);
  }
  scene->bounds = {glm::dvec3(-SIDE), glm::dvec3(SIDE)};
  shot = test::shotOf(SIDE * PIXELS);
  setCamera(r, shot);
  shot.shading = shading;
  shot.terms = termsOf(shading);
  shot.samples = 1;
  shot.output.bitDepth = 32;
  shot.debugOutput = DebugOutput::kLinear;
  for (std::uint64_t i = r.below(4); i > 0; --i) shot.lights.push_back(randomLight(r));
  if (shot.lights.empty() || r.chance(0.5)) {
    shot.environment.source = r.chance(0.7) ? Shot::Environment::Source::kStudio : Shot::Environment::Source::kBytes;
    shot.environment.intensity = r.edged(0, 2, {1, 1e6});
    shot.environment.rotation = r.between(-180, 180);
    // A sun of one texel that no half can hold, in a black sky.
    environment = hdrOf(64, [](int x, int y) { return glm::vec3(x == 20 && y == 8 ? 1.6e9f : 0.0f); });
  }
}

const Material& FuzzFrame::materialAt(std::size_t pixel) const {
  const std::size_t width = static_cast<std::size_t>(shot.width);
  const std::size_t row = pixel / width / PIXELS, column = pixel % width / PIXELS;
  return scene->materials[row * SIDE + column];
}

}  // namespace telar::numerics
