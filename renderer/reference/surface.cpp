#include "reference/surface.h"

#include <cmath>
#include <optional>

#include "brdf/material_inputs.h"
#include "core/prefetch.h"
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
  template <class Stream>
  auto of(const Stream& stream, int k) const {
    return stream[index_[k]];
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
  const bool ownTangents = hasTangents(primitive, *mesh.material) && !primitive.normals.empty();
  if (ownTangents && corners.haveLength(primitive.tangents)) {
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
  return {t * scale, bt * (ownTangents ? -scale : scale), n};
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
  glm::vec4 operator()(const TextureRef& texture, bool srgb = false, bool byAlpha = false) const {
    if (!texture) return glm::vec4(1.0f);
    return textures.read(texture, corners.uv(texture.texCoord, barycentric), srgb, byAlpha);
  }
};

bool isWoven(const PlacedMesh& mesh) { return mesh.shading == ShadingModel::kFabric && mesh.material->fabric.weave; }

float transmissionOf(const PhysicalLayers& l, const Reader& read) {
  return brdf_f::saturate(l.transmissionFactor * read(l.transmissionTexture).r);
}

Glass readGlass(const PhysicalLayers& l, const Reader& read, const PlacedMesh& mesh, const ThreeTerms& three) {
  Glass glass;
  glass.weight = transmissionOf(l, read);
  if (glass.weight == 0) return glass;
  glass.ior = iorOf(l, three);
  glass.dispersion = three.dispersion == ThreeTerms::THREE_DISPERSION_NONE ? 0 : l.dispersion;
  const glm::mat3& m = mesh.linear;
  const glm::vec3 scale(glm::length(m[0]), glm::length(m[1]), glm::length(m[2]));
  glass.thickness = l.thicknessFactor * read(l.thicknessTexture).g * scale;
  glass.attenuates = std::isfinite(l.attenuationDistance);
  glass.attenuationColor = l.attenuationColor;
  glass.attenuationDistance = l.attenuationDistance;
  return glass;
}

/// The normal as heights tilt it, where the neighbours of the pixel are known: a height is measured against its width.
glm::vec3 bumpedAt(const PhysicalLayers& l, const Corners& corners, const Reader& read, const glm::vec3& n,
                   const Footprint& footprint, float face) {
  const auto right = corners.barycentric(footprint.right), above = corners.barycentric(footprint.above);
  if (!right || !above) return n;
  const auto height = [&](const glm::vec2& b) { return Reader{read.textures, corners, b}(l.bumpTexture).r; };
  const float here = height(read.barycentric);
  const glm::vec3 p = corners.position(read.barycentric);
  const glm::vec2 rise = l.bumpFactor * glm::vec2(height(*right) - here, height(*above) - here);
  return brdf_f::bumpedNormal(n, corners.position(*right) - p, corners.position(*above) - p, rise, face);
}

/// shadingNormals() of shaders/material/normal.glsl; no normal is turned away from the viewer, where terms of stretched
/// lobes have poles.
/// @param n  of the surface, unit      @param face  1 on the front, -1 on the back
brdf_f::Normals normalsAt(const PlacedMesh& mesh, const Corners& corners, const Reader& read, const glm::vec3& n,
                          const glm::vec3& v, float face, const Footprint* footprint) {
  const Material& m = *mesh.material;
  const bool ownTangents = hasTangents(*mesh.primitive, m);
  const TextureRef& coatMap = m.layers.clearcoatNormalTexture;
  // Without vertex tangents the frame follows the texture's rows downwards.
  const glm::vec2 signs(1, ownTangents ? 1 : -1);
  const auto frameOf = [&](const TextureRef& texture) {
    return tangentFrame(mesh, corners, read.barycentric, n, texture, v, face);
  };
  const bool framedByWeave = isWoven(mesh) && m.fabric.weaveTexture;
  const glm::mat3 mapped = frameOf(m.normalTexture ? m.normalTexture : framedByWeave ? m.fabric.weaveTexture : coatMap);
  brdf_f::Normals normals{};
  normals.shading = normals.coat = n;
  if (m.normalTexture)
    normals.shading = mappedNormal(mapped, read(m.normalTexture), signs * m.normalScale);
  else if (m.layers.bumpTexture && footprint)
    normals.shading = bumpedAt(m.layers, corners, read, n, *footprint, face);
  if (coatMap) normals.coat = mappedNormal(frameOf(coatMap), read(coatMap), signs * m.layers.clearcoatNormalScale);
  normals = brdf_f::facingViewer(normals, v);
  normals.geometric = m.normalTexture ? n : normals.shading;
  // The frame of texture coordinates is not square: without a stretched highlight any square one about the mapped
  // normal shades the same.
  const bool stretched = m.layers.anisotropyStrength > 0 || isWoven(mesh);
  const bool framed = stretched && glm::dot(mapped[0], mapped[0]) > 0 && glm::dot(mapped[1], mapped[1]) > 0;
  normals.frame = framed ? mapped : brdf_f::basisAbout(normals.shading);
  normals.upward = ownTangents ? 1.0f : -1.0f;
  return normals;
}

/// Geometric roughness of three.js: how much the interpolated normal turns within a pixel.
float roughnessOfCurvature(const Corners& corners, const glm::vec3& n, const Footprint& footprint) {
  const auto change = [&](const Ray& neighbour) {
    const auto b = corners.barycentric(neighbour);
    return b ? footprint.toView * (corners.normal(*b) - n) : glm::vec3(0);
  };
  return brdf_f::geometricRoughness(change(footprint.right), change(footprint.above));
}

/// Factor, texture, tint and vertex colours.
glm::vec4 baseColorAt(const PlacedMesh& mesh, const Corners& corners, const Reader& read) {
  const Material& m = *mesh.material;
  const bool isSheer = mesh.shading == ShadingModel::kFabric && m.alphaMode == AlphaMode::kBlend;
  const glm::vec4 color = m.baseColorFactor * read(m.baseColorTexture, true, isSheer) * glm::vec4(mesh.tint, 1.0f);
  const auto& ofVertices = mesh.primitive->colors;
  return ofVertices.empty() ? color : color * corners.at(ofVertices, read.barycentric);
}

/// Ambient visibility of one side, in world space. Without numbers a side is open.
glm::vec4 visibilityAt(const PlacedMesh& mesh, const Corners& corners, const glm::vec2& b, bool front) {
  const auto& stream = mesh.primitive->visibility[front ? 0 : 1];
  if (stream.empty()) return {0, 0, 0, 1};
  const glm::vec3 weights(1 - b.x - b.y, b.x, b.y);
  glm::vec4 sum(0);
  for (int k = 0; k < 3; ++k) {
    // As in the vertex stage: each corner's direction counts alike, however long it is.
    const glm::vec4 v = corners.of(stream, k);
    const glm::vec3 direction = brdf_f::safeNormalize(mesh.normalMatrix * glm::vec3(v), glm::vec3(0));
    sum += weights[k] * glm::vec4(direction, v.w);
  }
  return sum;
}

/// Whether a direction comes upon the side that the triangle's winding shows.
bool meetsFront(const PlacedMesh& mesh, const Hit& hit, const glm::vec3& direction) {
  return (glm::dot(hit.normal, direction) > 0) == mesh.mirrored;
}

bool isCutOut(const Material& m, float alpha) { return m.alphaMode == AlphaMode::kMask && alpha < m.alphaCutoff; }

/// Of a base colour. 1 where the material is not blended.
float opacityOf(const Material& m, float alpha) {
  return m.alphaMode == AlphaMode::kBlend ? brdf_f::saturate(alpha) : 1.0f;
}

}  // namespace

Meeting meetingAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit, const glm::vec3& direction) {
  const Material& m = *mesh.material;
  Meeting meeting{.front = meetsFront(mesh, hit, direction)};
  meeting.shown = meeting.front || m.doubleSided;
  if (!meeting.shown || m.alphaMode == AlphaMode::kOpaque) return meeting;
  const Corners corners(mesh, hit.triangle);
  const float own = baseColorAt(mesh, corners, {textures, corners, hit.barycentric}).a;
  meeting.shown = !isCutOut(m, own);
  meeting.alpha = opacityOf(m, own);
  return meeting;
}

float transmissionAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit) {
  if (mesh.material->unlit) return 0;
  const Corners corners(mesh, hit.triangle);
  return transmissionOf(mesh.material->layers, {textures, corners, hit.barycentric});
}

bool endsAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit, const glm::vec3& direction, float alpha) {
  const Meeting meeting = meetingAt(textures, mesh, hit, direction);
  return meeting.shown && meeting.alpha >= alpha;
}

void prefetchTriangle(const PlacedMesh& mesh, const Hit& hit) { prefetch(&mesh.triangles[hit.triangle]); }

void prefetchVertices(const PlacedMesh& mesh, const Hit& hit) {
  const glm::uvec3& corners = mesh.triangles[hit.triangle];
  const Primitive& primitive = *mesh.primitive;
  for (int k = 0; k < 3; ++k) {
    prefetch(&mesh.positions[corners[k]]);
    if (!primitive.normals.empty()) prefetch(&primitive.normals[corners[k]]);
    if (!primitive.uvs[0].empty()) prefetch(&primitive.uvs[0][corners[k]]);
  }
}

void prefetchTexels(const Textures& textures, const PlacedMesh& mesh, const Hit& hit) {
  const Material& m = *mesh.material;
  const Corners corners(mesh, hit.triangle);
  for (const TextureRef* texture :
       {&m.baseColorTexture, &m.normalTexture, &m.metallicRoughnessTexture, &m.fabric.weaveTexture})
    if (*texture) textures.prefetch(*texture, corners.uv(texture->texCoord, hit.barycentric));
}

Surface surfaceAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit, const Ray& ray,
                  const Footprint* footprint, const ThreeTerms& three, const ShadingTerms* terms, bool baked) {
  const Material& m = *mesh.material;
  const Primitive& primitive = *mesh.primitive;
  const Corners corners(mesh, hit.triangle);
  const glm::vec2 b = hit.barycentric;
  const Reader read{textures, corners, b};
  Surface surface;
  surface.position = corners.position(b);
  surface.distance = hit.distance;
  const glm::vec3 v = -ray.direction;
  const glm::vec3 cross = corners.cross();
  const bool front = meetsFront(mesh, hit, ray.direction);
  const float face = front ? 1.0f : -1.0f;
  surface.geometricNormal = brdf_f::safeNormalize(glm::dot(cross, v) < 0 ? -cross : cross, v);
  const glm::vec4 baseColor = baseColorAt(mesh, corners, read);
  surface.unlit = m.unlit;
  surface.emitted = m.unlit ? glm::vec3(baseColor) : m.emissiveFactor * glm::vec3(read(m.emissiveTexture, true));
  if (surface.unlit) return surface;

  const bool flat = primitive.normals.empty();
  const glm::vec3 interpolated = flat ? surface.geometricNormal : corners.normal(b);
  const glm::vec3 n = flat || !m.doubleSided ? interpolated : interpolated * face;
  const float geometric = flat || !footprint ? 0.0f : roughnessOfCurvature(corners, interpolated, *footprint);
  const brdf_f::Normals normals = normalsAt(mesh, corners, read, n, v, face, footprint);
  brdf_f::MaterialInputs in = materialInputs<brdf_f::MaterialInputs>(m, glm::vec3(baseColor), three, read);
  // Finer than a pixel yarns are not taken together: many samples do that.
  if (isWoven(mesh) && m.fabric.weaveTexture) brdf_f::readWeaveTexel(in, read(m.fabric.weaveTexture));
  if (mesh.shading == ShadingModel::kFabric && m.fabric.back && m.doubleSided && !front) {
    in.baseColor = m.fabric.backColorFactor * glm::vec3(read(m.fabric.backColorTexture, true));
    in.roughness = m.fabric.backRoughnessFactor;
  }
  if (!terms) brdf_f::shadeRoughness(in, geometric);
  SurfaceInfo& s = surface.info;
  brdf_f::readSurface(s, in, normals, v, m.physical, isWoven(mesh));
  surface.hasVisibility = baked && mesh.shading == ShadingModel::kFabric && !primitive.visibility[0].empty();
  if (surface.hasVisibility)
    s = brdf_f::withVisibility(s, visibilityAt(mesh, corners, b, front), visibilityAt(mesh, corners, b, !front));
  if (terms) s.terms = *terms;
  surface.glass = readGlass(m.layers, read, mesh, three);
  // The fabric's energies are curves: only its glass reads the table.
  if (mesh.shading != ShadingModel::kFabric || surface.glass.weight > 0) {
    s.dfg = brdf_f::splitSum(three, s.perceptualRoughness, s.NoV);
    if (s.clearcoat > 0) s.coatDfg = brdf_f::splitSum(three, s.clearcoatRoughness, s.clearcoatNoV);
  }
  if (baked && m.occlusionTexture)
    surface.occlusion = brdf_f::diffuseOcclusion(read(m.occlusionTexture).r, m.occlusionStrength);
  s.visibility = brdf_f::visibilityBesideMap(s.visibility, surface.occlusion);
  return surface;
}

}  // namespace telar::reference
