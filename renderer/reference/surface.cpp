#include "reference/surface.h"

#include <cmath>
#include <optional>

#include "reference/texture_read.h"

namespace telar::reference {
namespace {

using brdf_f::SurfaceInfo;

/// The triangle of a hit, and its streams at one point.
class Corners {
 public:
  Corners(const PlacedMesh& mesh, std::uint32_t triangle) : mesh_(mesh), index_(mesh.triangles[triangle]) {
    for (int k = 0; k < 3; ++k) p_[k] = mesh.positions[index_[k]];
  }
  template <class Stream>
  auto at(const Stream& stream, const glm::vec2& b) const {
    return stream[index_.x] * (1 - b.x - b.y) + stream[index_.y] * b.x + stream[index_.z] * b.y;
  }
  /// Of the tangents at all three.
  bool haveLength(const std::vector<glm::vec4>& tangents) const {
    const auto has = [&](std::uint32_t i) { return glm::vec3(tangents[i]) != glm::vec3(0); };
    return has(index_.x) && has(index_.y) && has(index_.z);
  }
  glm::vec3 position(const glm::vec2& b) const { return p_[0] * (1 - b.x - b.y) + p_[1] * b.x + p_[2] * b.y; }
  glm::vec3 edge(int k) const { return p_[k] - p_[0]; }
  glm::vec3 cross() const { return glm::cross(edge(1), edge(2)); }

  glm::vec3 normal(const glm::vec2& b) const {
    return glm::normalize(mesh_.normalMatrix * at(mesh_.primitive->normals, b));
  }
  glm::vec2 uv(int set, const glm::vec2& b) const {
    const auto& stream = mesh_.primitive->uvs[static_cast<std::size_t>(set)];
    return stream.empty() ? glm::vec2(0) : at(stream, b);
  }
  /// Change of a texture's coordinates along an edge, after its transform.
  glm::vec2 uvEdge(const TextureRef& texture, int k) const {
    const auto& stream = mesh_.primitive->uvs[static_cast<std::size_t>(texture.texCoord)];
    if (stream.empty()) return glm::vec2(0);
    return glm::vec2(texture.uvTransform * glm::vec3(stream[index_[k]] - stream[index_[0]], 0.0f));
  }

  /// Where a ray meets the triangle's plane; empty where it runs along it.
  std::optional<glm::vec2> barycentric(const Ray& ray) const {
    const glm::vec3 n = cross();
    const float along = glm::dot(n, ray.direction), area2 = glm::dot(n, n);
    if (along == 0 || area2 == 0) return std::nullopt;
    const glm::vec3 p = ray.origin + ray.direction * (glm::dot(n, p_[0] - ray.origin) / along) - p_[0];
    return glm::vec2(glm::dot(glm::cross(p, edge(2)), n) / area2, glm::dot(glm::cross(edge(1), p), n) / area2);
  }

 private:
  const PlacedMesh& mesh_;
  glm::uvec3 index_;
  glm::vec3 p_[3];
};

/// The frame that normal maps stand in: shaders/material/normal.glsl with the triangle's edges in place of derivatives.
glm::mat3 tangentFrame(const PlacedMesh& mesh, const Corners& corners, const glm::vec2& b, const glm::vec3& n,
                       const TextureRef& texture, const glm::vec3& v, float face) {
  const Primitive& primitive = *mesh.primitive;
  const bool hasTangents = !primitive.tangents.empty() && !primitive.normals.empty();
  if (hasTangents && corners.haveLength(primitive.tangents)) {
    const glm::vec4 tangent = corners.at(primitive.tangents, b);
    const glm::vec3 t = glm::normalize(mesh.linear * glm::vec3(tangent));
    const glm::vec3 vertexNormal = n * face;
    return {t * face, glm::normalize(glm::cross(vertexNormal, t) * (tangent.w < 0 ? -1.0f : 1.0f)) * face, n};
  }
  const glm::vec2 d1 = corners.uvEdge(texture, 1), d2 = corners.uvEdge(texture, 2);
  // Screen derivatives turn like the triangle does: the sign tells whether its corners run counter-clockwise on screen.
  const float turn = glm::dot(corners.cross(), v) < 0 ? -1.0f : 1.0f;
  const glm::vec3 t = turn * glm::cross(corners.edge(2) * d1.x - corners.edge(1) * d2.x, n);
  const glm::vec3 bt = turn * glm::cross(corners.edge(2) * d1.y - corners.edge(1) * d2.y, n);
  const float det = std::max(glm::dot(t, t), glm::dot(bt, bt));
  const float scale = (det == 0 ? 0.0f : 1.0f / std::sqrt(det)) * (mesh.material->doubleSided ? face : 1.0f);
  return {t * scale, bt * (hasTangents ? -scale : scale), n};
}

glm::vec3 mappedNormal(const glm::mat3& frame, const glm::vec4& texel, const glm::vec2& scale) {
  glm::vec3 n = glm::vec3(texel) * 2.0f - 1.0f;
  n.x *= scale.x, n.y *= scale.y;
  return brdf_f::safeNormalize(frame * n, frame[2]);
}

/// Reads the material's textures at one point.
struct Reader {
  const Textures& textures;
  const Corners& corners;
  glm::vec2 barycentric;
  glm::vec4 operator()(const TextureRef& texture, bool srgb = false) const {
    if (!texture) return glm::vec4(1.0f);
    return textures.read(texture, corners.uv(texture.texCoord, barycentric), srgb);
  }
};

/// Perceptual roughness to shade with: modelRoughness() of shaders/material/layer_info.glsl.
float modelRoughness(float perceptualRoughness, float geometric, const ShadingTerms* terms) {
  return terms ? perceptualRoughness : brdf_f::shadedRoughness(perceptualRoughness, geometric);
}

/// @param ownRoughness  in place of the material's and its texture; null = none
void readBase(SurfaceInfo& s, const Material& m, const Reader& read, const glm::vec3& baseColor, float geometric,
              glm::vec2 (*dfg)(float, float), const ShadingTerms* terms, const float* ownRoughness) {
  const glm::vec4 texel = read(m.metallicRoughnessTexture);
  s.baseColor = baseColor;
  s.metallic = m.metallicFactor * texel.b;
  s.diffuse = brdf_f::diffuseAlbedo(baseColor, s.metallic);
  const PhysicalLayers& l = m.layers;
  s.f0Dielectric = glm::vec3(brdf_f::F0_DIELECTRIC);
  s.f90 = 1;
  if (m.physical) {
    const float factor = l.specularFactor * read(l.specularTexture).a;
    const glm::vec3 color = l.specularColorFactor * glm::vec3(read(l.specularColorTexture, true));
    const float ratio = (l.ior - 1) / (l.ior + 1);
    s.f90 = glm::mix(factor, 1.0f, s.metallic);
    s.f0Dielectric = glm::min(ratio * ratio * color, glm::vec3(1.0f)) * factor;
  }
  s.f0 = glm::mix(s.f0Dielectric, baseColor, s.metallic);
  const float roughness = ownRoughness ? *ownRoughness : m.roughnessFactor * texel.g;
  s.perceptualRoughness = modelRoughness(roughness, geometric, terms);
  s.alpha = brdf_f::alphaFromRoughness(s.perceptualRoughness);
  s.NoV = brdf_f::saturate(glm::dot(s.n, s.v));
  s.dfg = dfg(s.perceptualRoughness, s.NoV);
}

void readAnisotropy(SurfaceInfo& s, const PhysicalLayers& l, const Reader& read, const glm::mat3& frame) {
  glm::vec2 direction =
      l.anisotropyStrength * glm::vec2(std::cos(l.anisotropyRotation), std::sin(l.anisotropyRotation));
  if (l.anisotropyTexture) {
    const glm::mat2 rotation(direction.x, direction.y, -direction.y, direction.x);
    const glm::vec4 texel = read(l.anisotropyTexture);
    const glm::vec2 axis = 2.0f * glm::vec2(texel) - 1.0f;
    direction = rotation * (glm::dot(axis, axis) > 0 ? glm::normalize(axis) : glm::vec2(1, 0)) * texel.b;
  }
  s.anisotropyStrength = glm::length(direction);
  direction = s.anisotropyStrength == 0 ? glm::vec2(1, 0) : direction / s.anisotropyStrength;
  s.anisotropyStrength = brdf_f::saturate(s.anisotropyStrength);
  s.alphaT = brdf_f::alphaAlongTangent(s.perceptualRoughness, s.anisotropyStrength);
  s.t = frame[0] * direction.x + frame[1] * direction.y;
  s.b = frame[1] * direction.x - frame[0] * direction.y;
}

void readFilm(SurfaceInfo& s, const PhysicalLayers& l, const Reader& read) {
  const float thickness = glm::mix(l.iridescenceThicknessMinimum, l.iridescenceThicknessMaximum,
                                   l.iridescenceThicknessTexture ? read(l.iridescenceThicknessTexture).g : 1.0f);
  s.iridescence = thickness == 0 ? 0 : brdf_f::saturate(l.iridescenceFactor * read(l.iridescenceTexture).r);
  s.filmFresnel = s.filmF0Dielectric = s.filmF0Metal = glm::vec3(0);
  if (s.iridescence == 0) return;
  const glm::vec3 dielectric = brdf_f::F_Iridescence(l.iridescenceIor, thickness, s.NoV, s.f0Dielectric);
  const glm::vec3 metal = brdf_f::F_Iridescence(l.iridescenceIor, thickness, s.NoV, s.baseColor);
  s.filmFresnel = glm::mix(dielectric, metal, s.metallic);
  s.filmF0Dielectric = brdf_f::f0FromSchlick(dielectric, s.NoV);
  s.filmF0Metal = brdf_f::f0FromSchlick(metal, s.NoV);
}

void readLayers(SurfaceInfo& s, const Material& m, const Reader& read, const glm::mat3& frame,
                const glm::vec3& coatNormal, float geometric, glm::vec2 (*dfg)(float, float),
                const ShadingTerms* terms) {
  const PhysicalLayers& l = m.layers;
  s.diffuseRoughness = brdf_f::saturate(l.diffuseRoughnessFactor * read(l.diffuseRoughnessTexture).r);
  readAnisotropy(s, l, read, frame);
  readFilm(s, l, read);
  s.sheenColor = l.sheen ? l.sheenColorFactor * glm::vec3(read(l.sheenColorTexture, true)) : glm::vec3(0);
  s.sheenRoughness =
      std::max(std::min(l.sheenRoughnessFactor, 1.0f) * read(l.sheenRoughnessTexture).a, brdf_f::SHEEN_ROUGHNESS_MIN);
  s.coatNormal = coatNormal;
  s.clearcoat = brdf_f::saturate(l.clearcoatFactor * read(l.clearcoatTexture).r);
  const float coatRoughness = l.clearcoatRoughnessFactor * read(l.clearcoatRoughnessTexture).g;
  s.clearcoatRoughness = modelRoughness(coatRoughness, geometric, terms);
  s.clearcoatNoV = brdf_f::saturate(glm::dot(coatNormal, s.v));
  s.coatDfg = dfg(s.clearcoatRoughness, s.clearcoatNoV);
}

bool isWoven(const PlacedMesh& mesh) { return mesh.shading == ShadingModel::kFabric && mesh.material->fabric.weave; }

/// The yarns on top at this point. Finer than a pixel they are not taken together: many samples do that.
/// @param up  the frame's second axis is Y of the tangent space, else -Y
void readYarns(SurfaceInfo& s, const Material& m, const Reader& read, const glm::mat3& frame, bool up,
               float geometric) {
  const FabricLayers& f = m.fabric;
  const float texel = read(m.metallicRoughnessTexture).g;
  const glm::vec3 weft = brdf_f::safeNormalize(frame[0] - s.n * glm::dot(s.n, frame[0]), brdf_f::anyTangent(s.n));
  glm::vec3 warp = glm::cross(s.n, weft);
  if ((glm::dot(warp, frame[1]) < 0) == up) warp = -warp;
  glm::vec2 coverage(f.warp.coverage, f.weft.coverage), turn(1, 0);
  float slope = 0;
  if (f.weaveTexture) {
    const glm::vec4 weave = read(f.weaveTexture);
    coverage = (coverage.x + coverage.y) * glm::vec2(weave.a, 1 - weave.a);
    turn = 2.0f * glm::vec2(weave) - 1.0f;
    slope = 2 * weave.b - 1;
  }
  const auto yarn = [&](const Yarn& y, float share, const glm::vec3& axis, const glm::vec3& aside) {
    return brdf_f::fabric::yarnLobe(s.n, axis, aside, turn, slope, share,
                                    brdf_f::shadedRoughness(y.roughness * texel, geometric), y.anisotropy,
                                    y.specularColor);
  };
  s.t = weft;
  s.b = warp;
  s.warp = yarn(f.warp, coverage.x, warp, -weft);
  s.weft = yarn(f.weft, coverage.y, weft, warp);
}

/// What FabricLayers adds.
void readCloth(SurfaceInfo& s, const Material& m, const Reader& read, const glm::vec3& geometricNormal) {
  const FabricLayers& f = m.fabric;
  s.geometricNormal = geometricNormal;
  s.slopeVariance = 0;  // rays see every bump
  s.flatness = f.flatness;
  s.diffuseTransmission = brdf_f::saturate(f.diffuseTransmissionFactor * read(f.diffuseTransmissionTexture).a);
  s.transmittedColor = f.diffuseTransmissionColorFactor * glm::vec3(read(f.diffuseTransmissionColorTexture, true));
  s.warp.coverage = s.weft.coverage = 0;
}

Glass readGlass(const PhysicalLayers& l, const Reader& read, const PlacedMesh& mesh) {
  Glass glass;
  glass.weight = brdf_f::saturate(l.transmissionFactor * read(l.transmissionTexture).r);
  if (glass.weight == 0) return glass;
  glass.ior = l.ior;
  glass.dispersion = l.dispersion;
  const glm::mat3& m = mesh.linear;
  const glm::vec3 scale(glm::length(m[0]), glm::length(m[1]), glm::length(m[2]));
  glass.thickness = l.thicknessFactor * read(l.thicknessTexture).g * scale;
  glass.attenuates = std::isfinite(l.attenuationDistance);
  glass.attenuationColor = l.attenuationColor;
  glass.attenuationDistance = l.attenuationDistance;
  return glass;
}

/// Geometric roughness of three.js: how much the interpolated normal turns within a pixel.
float roughnessOfCurvature(const Corners& corners, const glm::vec3& n, const Footprint& footprint) {
  const auto change = [&](const Ray& neighbour) {
    const auto b = corners.barycentric(neighbour);
    return b ? footprint.toView * (corners.normal(*b) - n) : glm::vec3(0);
  };
  return brdf_f::geometricRoughness(change(footprint.right), change(footprint.above));
}

}  // namespace

Surface surfaceAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit, const Ray& ray,
                  const Footprint* footprint, glm::vec2 (*dfg)(float, float), const ShadingTerms* terms) {
  const Material& m = *mesh.material;
  const Primitive& primitive = *mesh.primitive;
  const Corners corners(mesh, hit.triangle);
  const glm::vec2 b = hit.barycentric;
  const Reader read{textures, corners, b};
  Surface surface{.position = corners.position(b)};
  surface.distance = hit.distance;
  SurfaceInfo& s = surface.info;
  s.v = -ray.direction;
  const glm::vec3 cross = corners.cross();
  const bool front = (glm::dot(cross, s.v) < 0) == mesh.mirrored;
  const float face = front ? 1.0f : -1.0f;
  surface.front = front;
  surface.geometricNormal = brdf_f::safeNormalize(glm::dot(cross, s.v) < 0 ? -cross : cross, s.v);
  glm::vec4 baseColor = m.baseColorFactor * read(m.baseColorTexture, true) * glm::vec4(mesh.tint, 1.0f);
  if (!primitive.colors.empty()) baseColor *= corners.at(primitive.colors, b);
  surface.alpha = m.alphaMode == AlphaMode::kBlend ? brdf_f::saturate(baseColor.a) : 1.0f;
  surface.shown = (front || m.doubleSided) && !(m.alphaMode == AlphaMode::kMask && baseColor.a < m.alphaCutoff);
  surface.unlit = m.unlit;
  surface.emitted = m.unlit ? glm::vec3(baseColor) : m.emissiveFactor * glm::vec3(read(m.emissiveTexture, true));
  if (!surface.shown || surface.unlit) return surface;

  const bool flat = primitive.normals.empty();
  const glm::vec3 interpolated = flat ? surface.geometricNormal : corners.normal(b);
  const glm::vec3 n = flat || !m.doubleSided ? interpolated : interpolated * face;
  const float geometric = flat || !footprint ? 0.0f : roughnessOfCurvature(corners, interpolated, *footprint);
  // Without vertex tangents the frame follows the texture's rows downwards.
  const glm::vec2 signs(1, primitive.tangents.empty() ? -1 : 1);
  s.n = n;
  const bool cloth = mesh.shading == ShadingModel::kFabric;
  const TextureRef& framing = m.normalTexture                          ? m.normalTexture
                              : isWoven(mesh) && m.fabric.weaveTexture ? m.fabric.weaveTexture
                                                                       : m.layers.clearcoatNormalTexture;
  const glm::mat3 mapped = tangentFrame(mesh, corners, b, n, framing, s.v, face);
  if (m.normalTexture) s.n = mappedNormal(mapped, read(m.normalTexture), signs * m.normalScale);
  // The shading takes a viewer behind the normal along the surface, where terms of stretched lobes have poles.
  s.n = brdf_f::normalFacing(s.n, s.v);
  // The frame of texture coordinates is not square: without a stretched highlight any square one about the mapped
  // normal shades the same.
  glm::mat3 frame = brdf_f::basisAbout(s.n);
  const bool stretched = m.layers.anisotropyStrength > 0 || isWoven(mesh);
  if (stretched && glm::dot(mapped[0], mapped[0]) > 0 && glm::dot(mapped[1], mapped[1]) > 0) frame = mapped;
  glm::vec3 coatNormal = n;
  if (const TextureRef& map = m.layers.clearcoatNormalTexture) {
    const glm::mat3 coatFrame = tangentFrame(mesh, corners, b, n, map, s.v, face);
    coatNormal = mappedNormal(coatFrame, read(map), signs * m.layers.clearcoatNormalScale);
  }
  coatNormal = brdf_f::normalFacing(coatNormal, s.v);
  const bool back = cloth && m.fabric.back && m.doubleSided && !front;
  if (back)
    baseColor = glm::vec4(m.fabric.backColorFactor * glm::vec3(read(m.fabric.backColorTexture, true)), baseColor.a);
  readBase(s, m, read, glm::vec3(baseColor), geometric, dfg, terms, back ? &m.fabric.backRoughnessFactor : nullptr);
  readLayers(s, m, read, frame, coatNormal, geometric, dfg, terms);
  if (terms) s.terms = *terms;
  readCloth(s, m, read, m.normalTexture ? n : s.n);
  if (isWoven(mesh)) readYarns(s, m, read, frame, !primitive.tangents.empty(), geometric);
  surface.glass = readGlass(m.layers, read, mesh);
  if (m.occlusionTexture) surface.occlusion = brdf_f::diffuseOcclusion(read(m.occlusionTexture).r, m.occlusionStrength);
  return surface;
}

}  // namespace telar::reference
