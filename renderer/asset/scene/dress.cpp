#include "telar/dress.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <map>
#include <new>
#include <set>
#include <utility>

#include "asset/check/pointer.h"
#include "asset/check/warnings.h"
#include "asset/material/fabric_layers.h"
#include "asset/material/material.h"
#include "core/dye.h"
#include "core/mean_of_srgb.h"
#include "telar/variant_material.h"

namespace telar {
namespace {

const Material& materialOf(const Scene& cloth) {
  for (const Node& node : cloth.nodes) {
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : cloth.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (primitive.material >= 0) return cloth.materials[static_cast<std::size_t>(primitive.material)];
    }
  }
  throw Error("E_CLOTH", "the file of the cloth draws nothing with a material");
}

/// From a garment's texture coordinates to those of a cloth: to metres, turned, to the cloth's own measure.
glm::dmat3 placement(const glm::dvec2& garment, const glm::dvec2& cloth, const Dressing& dressing) {
  const double c = std::cos(dressing.rotation), s = std::sin(dressing.rotation);
  const glm::dvec2 per = 1.0 / (cloth * dressing.scale);
  // v runs down the picture: what turns counter-clockwise to the eye is looked up by (c -s; s c).
  return {glm::dvec3(garment.x * c * per.x, garment.x * s * per.y, 0),
          glm::dvec3(-garment.y * s * per.x, garment.y * c * per.y, 0), glm::dvec3(0, 0, 1)};
}

/// The mean of what is there of a picture of a colour; one where that is not known, or is black in a channel.
glm::vec3 meanColor(const Image8& image) {
  const auto mean = meanOfSrgb(image, true);
  return mean && glm::all(glm::greaterThan(*mean, glm::dvec3(0))) ? glm::vec3(*mean) : glm::vec3(1);
}

class Dresser {
 public:
  Dresser(const std::shared_ptr<const Scene>& model, const CancelToken& cancel)
      : model_(*model), out_(std::make_shared<Scene>(model_)), cancel_(cancel), warnings_(std::move(out_->warnings)) {
    out_->model = model->model ? model->model : model;
  }

  /// Measures what the dressings need, once.
  void measure(const std::vector<Dressing>& dressings) {
    std::vector<bool> wanted(model_.fileMaterials, false);
    for (const Dressing& dressing : dressings) {
      if (!dressing.cloth) continue;
      for (const int material : dressing.materials) wanted[static_cast<std::size_t>(material)] = true;
      if (!dressing.nodes.empty()) wanted.assign(wanted.size(), true);
    }
    scales_ = metresPerUv(model_, wanted, cancel_);
  }

  void dress(const Dressing& dressing) {
    const int images = dressing.cloth ? addImages(dressing.cloth) : 0;
    for (const int material : dressing.materials) {
      const auto at = static_cast<std::size_t>(material);
      out_->materials[at] = wear(material, dressing, images);
    }
    const std::set<int> meant(dressing.nodes.begin(), dressing.nodes.end());
    std::map<int, int> worn;                                            // by material
    std::map<int, std::shared_ptr<const std::map<int, int>>> ofMeshes;  // by mesh
    for (Node& node : out_->nodes) {
      if (node.mesh < 0 || !meant.contains(node.file.node)) continue;
      auto& ofMesh = ofMeshes[node.mesh];
      if (!ofMesh) ofMesh = dressedMesh(node.mesh, dressing, images, worn);
      node.materials = ofMesh;
    }
  }

  std::shared_ptr<const Scene> take() {
    out_->warnings = warnings_.take();
    return out_;
  }

 private:
  /// @return index of the cloth's first image in the scene
  int addImages(const std::shared_ptr<const Scene>& cloth) {
    const auto [at, isNew] = firstImages_.emplace(cloth.get(), static_cast<int>(out_->images.size()));
    if (isNew) {
      waitForImages(*cloth, cancel_);
      out_->cloths.push_back({cloth, out_->images.size()});
      out_->images = out_->images.joined(cloth->images);
    }
    return at->second;
  }

  /// @param worn  what this dressing has made so far, by material
  std::shared_ptr<const std::map<int, int>> dressedMesh(int mesh, const Dressing& dressing, int images,
                                                        std::map<int, int>& worn) {
    std::map<int, int> out;
    const auto add = [&](int material) {
      if (material < 0 || out.contains(material)) return;
      const auto [made, isNew] = worn.emplace(material, 0);
      if (isNew) {
        Material dressed = wear(material, dressing, images);
        made->second = static_cast<int>(out_->materials.size());
        out_->materials.push_back(std::move(dressed));
      }
      out[material] = made->second;
    };
    for (const Primitive& primitive : out_->meshes[static_cast<std::size_t>(mesh)].primitives) {
      add(primitive.material);
      for (const auto& [variant, material] : primitive.variantMaterials) add(material);
    }
    return std::make_shared<const std::map<int, int>>(std::move(out));
  }

  /// @param at     index of the material that is replaced
  /// @param images of addImages()
  Material wear(int at, const Dressing& dressing, int images) {
    const Material& own = model_.materials[static_cast<std::size_t>(at)];
    if (!dressing.cloth) return recolored(own, dressing);
    const Material& cloth = materialOf(*dressing.cloth);
    Material out = worn(own, cloth, dressing, images, at);
    if (cloth.withPreset < 0) return out;
    out.withPreset = static_cast<int>(out_->materials.size());
    const Material& filled = dressing.cloth->materials[static_cast<std::size_t>(cloth.withPreset)];
    out_->materials.push_back(worn(own, filled, dressing, images, at));
    return out;
  }

  Material recolored(const Material& own, const Dressing& dressing) {
    Material out = own;
    if (dressing.color) paint(out, *dressing.color);
    if (own.withPreset >= 0 && dressing.color) {
      Material filled = model_.materials[static_cast<std::size_t>(own.withPreset)];
      paint(filled, *dressing.color);
      // A sheen that the file does not have is the preset's, in the colour that was.
      if (own.layers.sheenColorFactor == glm::vec3(0))
        filled.layers.sheenColorFactor *= sheenDye(*dressing.color) / sheenDye(glm::vec3(own.baseColorFactor));
      // So is light that passes through.
      if (own.fabric.diffuseTransmissionFactor == 0)
        filled.fabric.diffuseTransmissionColorFactor *=
            transmissionDye(*dressing.color) / transmissionDye(glm::vec3(own.baseColorFactor));
      out.withPreset = static_cast<int>(out_->materials.size());
      out_->materials.push_back(std::move(filled));
    }
    return out;
  }

  /// A picture that cuts the part's shape out stays.
  static void paint(Material& material, const glm::vec3& color) {
    material.baseColorFactor = glm::vec4(color, material.baseColorFactor.a);
    if (isOpaque(material)) material.baseColorTexture = {};
    asset::colorBack(material, material.fabric);
  }

  Material worn(const Material& own, const Material& cloth, const Dressing& dressing, int images, int at) {
    Material out = cloth;
    out.name = own.name;
    out.doubleSided = own.doubleSided;
    out.ignoresTangents = dressing.rotation != 0;
    place(out, dressing, images, at);
    out.occlusionTexture = own.occlusionTexture;
    out.occlusionStrength = own.occlusionStrength;
    out.withPreset = -1;
    const glm::vec3 dye = dressing.color.value_or(glm::vec3(own.baseColorFactor));
    out.layers.sheenColorFactor *= sheenDye(dye);
    out.fabric.diffuseTransmissionColorFactor *= transmissionDye(dye);
    if (dressing.color) {
      out.baseColorFactor = glm::vec4(*dressing.color / meanOf(out.baseColorTexture), cloth.baseColorFactor.a);
    } else {
      const glm::vec3 color = glm::vec3(own.baseColorFactor) / meanOf(out.baseColorTexture);
      out.baseColorFactor = glm::vec4(color, own.baseColorFactor.a);
      if (!cloth.baseColorTexture) {
        out.baseColorTexture = own.baseColorTexture;
        out.fabric.diffuseTransmissionColorTexture = own.baseColorTexture;
        out.alphaMode = own.alphaMode;
        out.alphaCutoff = own.alphaCutoff;
      }
    }
    asset::colorBack(out, out.fabric);
    return out;
  }

  /// The colour of a cloth is the mean of what its picture shows.
  glm::vec3 meanOf(const TextureRef& texture) {
    if (!texture) return glm::vec3(1);
    const auto [mean, isNew] = means_.emplace(texture.image, 1);
    if (isNew) mean->second = meanColor(out_->images[static_cast<std::size_t>(texture.image)]);
    return mean->second;
  }

  void place(Material& material, const Dressing& dressing, int images, int at) {
    const auto uses = asset::texturesOf(material);
    if (uses.empty()) return;
    const auto& garment = scales_[static_cast<std::size_t>(at)];
    const auto cloth = clothScale(*dressing.cloth);
    if (!garment || !cloth) {
      warnings_.add("W_CLOTH_UV", "the surface has no texture coordinates: the maps of its cloth are not drawn",
                    asset::pointer("materials", at));
      for (const asset::TextureUse& use : uses) *use.texture = {};
      return;
    }
    const glm::dmat3 to = placement(dressing.metresPerUv.value_or(*garment), *cloth, dressing);
    for (const asset::TextureUse& use : uses) {
      TextureRef& texture = *use.texture;
      texture.image += images;
      texture.texCoord = 0;
      texture.uvTransform = glm::mat3(glm::dmat3(texture.uvTransform) * to);
      texture.hasTransform = texture.placed = true;
    }
  }

  std::optional<glm::dvec2> clothScale(const Scene& cloth) const {
    const auto at = static_cast<std::size_t>(&materialOf(cloth) - cloth.materials.data());
    std::vector<bool> wanted(at + 1, false);
    wanted[at] = true;
    return metresPerUv(cloth, wanted, cancel_)[at];
  }

  const Scene& model_;
  std::shared_ptr<Scene> out_;
  const CancelToken& cancel_;
  asset::Warnings warnings_;
  std::map<const Scene*, int> firstImages_;
  std::map<int, glm::vec3> means_;                 ///< by image
  std::vector<std::optional<glm::dvec2>> scales_;  ///< by material
};

}  // namespace

std::shared_ptr<const Scene> dressScene(const std::shared_ptr<const Scene>& model,
                                        const std::vector<Dressing>& dressings, const CancelToken& cancel) {
  try {
    Dresser dresser(model, cancel);
    dresser.measure(dressings);
    for (const Dressing& dressing : dressings) dresser.dress(dressing);
    return dresser.take();
  } catch (const std::bad_alloc&) {
    throw Error("X_MEMORY", "there is not enough memory to dress the model");
  }
}

}  // namespace telar
