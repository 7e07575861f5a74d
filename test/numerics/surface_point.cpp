#include "surface_point.h"

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "brdf/dfg_lookup.h"
#include "reference/sphere.h"
#include "reference/surface.h"
#include "reference/texture_read.h"
#include "shading_terms.h"

namespace telar::numerics {
namespace {

/// What the renderer does with the normal after it is known.
void turnNormal(brdf_f::SurfaceInfo& s, const glm::vec3& n) {
  s.n = n;
  s.NoV = brdf_f::saturate(glm::dot(n, s.v));
  s.dfg = brdf::dfgLookup(s.perceptualRoughness, s.NoV);
}

void turnCoat(brdf_f::SurfaceInfo& s, const glm::vec3& n) {
  s.coatNormal = n;
  s.clearcoatNoV = brdf_f::saturate(glm::dot(n, s.v));
  s.coatDfg = brdf::dfgLookup(s.clearcoatRoughness, s.clearcoatNoV);
}

/// A triangle with a normal, standing any way round.
class Stage {
 public:
  explicit Stage(const glm::mat3& axes) : axes_(axes) {
    const glm::vec3 x = axes[0], y = axes[1];
    primitive_.positions = {-x - y, x - y, y};
    primitive_.normals = {axes[2], axes[2], axes[2]};
    primitive_.uvs[0] = {{0, 0}, {1, 0}, {0.5f, 1}};
  }

  brdf_f::SurfaceInfo read(ShadingModel model, const Material& material, const glm::vec3& v) const {
    reference::PlacedMesh mesh;
    mesh.primitive = &primitive_;
    mesh.material = &material;
    mesh.shading = model;
    mesh.positions = primitive_.positions;
    mesh.triangles = {{0, 1, 2}};
    reference::Hit hit;
    hit.barycentric = glm::vec2(1.0f / 3);
    const auto& corners = primitive_.positions;
    hit.normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    static const Scene empty;
    static const reference::Textures textures(empty);
    const ShadingTerms terms = termsOf(model);
    const bool principled = isPrincipled(model);
    brdf_f::SurfaceInfo info =
        reference::surfaceAt(textures, mesh, hit, {v, -v}, nullptr, ThreeTerms{}, principled ? &terms : nullptr).info;
    // The path tracer turns every normal that is seen edge on, and so does fabric; the others shade it as it is.
    if (model != ShadingModel::kFabric) stand(info);
    return info;
  }

  /// The surface about the stage's own normal, whatever it was turned to.
  void stand(brdf_f::SurfaceInfo& info) const {
    const glm::vec3& n = axes_[2];
    turnNormal(info, n);
    turnCoat(info, n);
    info.t = glm::normalize(info.t - n * glm::dot(n, info.t));
    info.b = glm::cross(n, info.t) * (glm::dot(glm::cross(n, info.t), info.b) < 0 ? -1.0f : 1.0f);
  }

  glm::vec3 toWorld(const glm::dvec3& local) const { return glm::vec3(glm::dmat3(axes_) * local); }

 private:
  glm::mat3 axes_;
  Primitive primitive_;
};

const Stage& flatStage() {
  static const Stage stage(glm::mat3(1.0f));
  return stage;
}

glm::dvec3 local(double cosine, double phi) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

double edgedCosine(Seeded& r) { return r.edged(0, 1, {0, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.6, 0.9, 1}); }

/// Directions through each other and along each other: l = -v, l = v, l its mirror.
glm::vec3 specialLight(Seeded& r, const brdf_f::SurfaceInfo& s, const glm::vec3& l) {
  switch (r.below(48)) {
    case 0:
      return -s.v;
    case 1:
      return s.v;
    case 2:
      return 2 * glm::dot(s.v, s.n) * s.n - s.v;
    case 3:
      return glm::vec3(0);  // a light on the surface itself
    default:
      return l;
  }
}

}  // namespace

SurfacePoint pointOn(ShadingModel model, const Material& material, const Directions& d) {
  SurfacePoint point{model, material, {}, {}};
  point.material.doubleSided = true;  // a viewer in the plane sees a side
  point.info = flatStage().read(model, point.material, flatStage().toWorld(local(d.NoV, d.turn)));
  point.l = flatStage().toWorld(local(d.NoL, d.turn + d.phi));
  return point;
}

SurfacePoint exchanged(const SurfacePoint& point) {
  return {point.model, point.material, flatStage().read(point.model, point.material, point.l), point.info.v};
}

SurfacePoint randomPoint(ShadingModel model, std::uint64_t seed) {
  Seeded r(seed);
  SurfacePoint point{model, randomMaterial(r, Layers::random(r)), {}, {}};
  point.material.doubleSided = true;
  const glm::vec2 direction(static_cast<float>(r.unit()), static_cast<float>(r.unit()));
  const Stage stage(r.chance(0.1) ? glm::mat3(1.0f) : brdf_f::basisAbout(reference::sampleSphere(direction)));
  const double phi = r.between(-std::numbers::pi, std::numbers::pi);
  point.info = stage.read(model, point.material, stage.toWorld(local(edgedCosine(r), phi)));
  const double turned = r.edged(-std::numbers::pi, std::numbers::pi, {0, 1e-3, 0.5, 1, 2, std::numbers::pi});
  const double NoL = r.chance(0.1) ? -edgedCosine(r) : edgedCosine(r);
  point.l = stage.toWorld(local(NoL, phi + turned));
  const auto tilted = [&] {
    return glm::normalize(stage.toWorld(local(r.between(-0.3, 1), r.between(-std::numbers::pi, std::numbers::pi))));
  };
  if (r.chance(0.1)) turnNormal(point.info, tilted());
  if (r.chance(0.1)) {
    turnCoat(point.info, tilted());
  }
  point.l = specialLight(r, point.info, point.l);
  return point;
}

namespace {

constexpr std::array ROUGHNESS{0.0, 0.01, 0.045, 0.089, 0.2, 0.5, 0.8, 1.0};
constexpr std::array COSINE{0.0, 1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.6, 0.9, 1.0};
constexpr std::array AZIMUTH{0.0, 1e-3, 0.5, 1.0, 2.0, std::numbers::pi};
constexpr std::array IOR{1.0, 1.329, 1.5, 5.828, 1000.0};  // normal reflectances 0, 0.02, 0.04, 0.5, 1
constexpr std::array SHEEN_ROUGHNESS{0.0, 0.04, 0.1, 0.3, 0.5, 1.0};
constexpr std::uint64_t SHEENS = 1 + 2 * SHEEN_ROUGHNESS.size();

/// Digits of a mixed-radix number, lowest first.
struct Digits {
  std::uint64_t rest;
  std::uint64_t next(std::uint64_t radix) {
    const std::uint64_t digit = rest % radix;
    rest /= radix;
    return digit;
  }
  template <class List>
  double pick(const List& list) {
    return list[next(list.size())];
  }
};

}  // namespace

std::uint64_t gridSize() {
  return ROUGHNESS.size() * COSINE.size() * COSINE.size() * AZIMUTH.size() * IOR.size() * SHEENS * 4;
}

SurfacePoint gridPoint(ShadingModel model, std::uint64_t index) {
  Digits digits{index};
  Directions d{digits.pick(COSINE), digits.pick(COSINE), digits.pick(AZIMUTH)};
  Material m;
  m.physical = true;
  m.baseColorFactor = {0.8f, 0.4f, 0, 1};
  m.roughnessFactor = static_cast<float>(digits.pick(ROUGHNESS));
  m.layers.ior = static_cast<float>(digits.pick(IOR));
  if (const std::uint64_t sheen = digits.next(SHEENS)) {
    m.layers.sheenColorFactor = glm::vec3(sheen % 2 ? 0.5f : 1.0f);
    m.layers.sheenRoughnessFactor = static_cast<float>(SHEEN_ROUGHNESS[(sheen - 1) / 2]);
  }
  m.metallicFactor = static_cast<float>(digits.next(2));
  if (digits.next(2)) {
    m.layers.clearcoatFactor = 0.5f;
    m.layers.clearcoatRoughnessFactor = m.roughnessFactor;
    m.layers.anisotropyStrength = 0.8f;
    m.layers.diffuseRoughnessFactor = 0.5f;
    m.fabric.weave = true;
    m.fabric.warp = {0.6f, m.roughnessFactor, 0.7f};
    m.fabric.weft = {0.3f, 0.5f, 0.7f};
    m.fabric.diffuseTransmissionFactor = 0.5f;
  }
  return pointOn(model, m, d);
}

bool hasYarns(const SurfacePoint& point) { return point.info.warp.coverage + point.info.weft.coverage > 0; }

std::string describe(const SurfacePoint& p) {
  std::ostringstream out;
  out.precision(9);
  const float NoL = glm::dot(p.info.n, p.l);
  out << describe(p.material) << " NoV " << glm::dot(p.info.n, p.info.v) << " NoL " << NoL << " LoV "
      << glm::dot(p.l, p.info.v);
  return out.str();
}

}  // namespace telar::numerics
