#include "frame/release_material.h"

#include <utility>

#include "telar/material_textures.inc"

namespace telar::frame {
namespace {

/// Calls `visit` with every use that three.js makes of a texture.
template <typename Visit>
void forTextures(Material& m, const Visit& visit) {
#define TELAR_VISIT_TEXTURE(field, ...) visit(m.field);
  TELAR_CORE_TEXTURES(TELAR_VISIT_TEXTURE)
  TELAR_LAYER_TEXTURES(TELAR_VISIT_TEXTURE)
#undef TELAR_VISIT_TEXTURE
}

void dropUnread(Material& m, const ThreeTerms& three) {
  PhysicalLayers& l = m.layers;
  if (three.dispersion == ThreeTerms::THREE_DISPERSION_NONE) l.dispersion = 0;
  if (three.anisotropyDirection == ThreeTerms::THREE_ANISOTROPY_DIRECTION_NONE) {
    l.anisotropyStrength = 0;
    l.anisotropyTexture = {};
  }
  if (three.diffuseRoughness == ThreeTerms::THREE_DIFFUSE_ROUGHNESS_NONE) {
    l.diffuseRoughnessFactor = 0;
    l.diffuseRoughnessTexture = {};
  }
  if (three.bump == ThreeTerms::THREE_BUMP_NONE) l.bumpTexture = {};
}

/// T S R in place of T R S: x and y keep their own scale when they are turned.
void turnFirst(glm::mat3& t) { t[0][1] = -std::exchange(t[1][0], -t[0][1]); }

/// The map that lends all others its transform, in the order in which 0.150 asks for them. Null = no map.
const TextureRef* firstMap(const Material& m) {
  const PhysicalLayers& l = m.layers;
  for (const TextureRef* map :
       {&m.baseColorTexture, &m.normalTexture, &m.metallicRoughnessTexture, &m.emissiveTexture, &l.clearcoatTexture,
        &l.clearcoatNormalTexture, &l.clearcoatRoughnessTexture, &l.iridescenceTexture, &l.iridescenceThicknessTexture,
        &l.specularTexture, &l.specularColorTexture, &l.transmissionTexture, &l.thicknessTexture, &l.sheenColorTexture,
        &l.sheenRoughnessTexture}) {
    if (*map) return map;
  }
  return nullptr;
}

/// One transform and the first coordinates for all maps but occlusion, which has the second ones where a mesh has them.
void shareCoordinates(Material& m, bool secondUvs) {
  const TextureRef* first = firstMap(m);
  const glm::mat3 transform = first ? first->uvTransform : glm::mat3(1.0f);
  const TextureRef occlusion = m.occlusionTexture;
  forTextures(m, [&](TextureRef& texture) {
    texture.uvTransform = transform;
    texture.texCoord = 0;
  });
  m.occlusionTexture.uvTransform = occlusion.uvTransform;
  m.occlusionTexture.texCoord = secondUvs ? 1 : 0;
}

}  // namespace

std::shared_ptr<const Material> ReleaseMaterials::of(const Material& material, const Primitive& primitive,
                                                     const ThreeTerms& three) {
  if (three == ThreeTerms{}) return nullptr;
  const bool secondUvs = !primitive.uvs[1].empty();
  auto& kept = read_[{&material, secondUvs}];
  if (kept) return kept;
  auto read = std::make_shared<Material>(material);
  dropUnread(*read, three);
  if (three.textureTransform == ThreeTerms::THREE_TEXTURE_TRANSFORM_TSR)
    forTextures(*read, [](TextureRef& texture) {
      if (!texture.placed) turnFirst(texture.uvTransform);
    });
  if (three.textureCoordinates == ThreeTerms::THREE_TEXTURE_COORDINATES_FIRST_MAP) shareCoordinates(*read, secondUvs);
  kept = std::move(read);
  return kept;
}

}  // namespace telar::frame
