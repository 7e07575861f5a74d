#pragma once
#include <array>
#include <memory>
#include <set>
#include <vector>

#include "frame/camera.h"
#include "frame/ghosts.h"
#include "frame/release_material.h"
#include "pass/plan/light_set.h"
#include "pass/plan/shadow_set.h"
#include "shader/variant_key.h"
#include "telar/scene.h"

namespace telar::pass {

/// One draw call.
struct DrawItem {
  const Node* node = nullptr;
  const Primitive* primitive = nullptr;
  const Material* material = nullptr;
  shader::VariantKey key;
  bool blend = false;           ///< alpha blended, without depth writes
  bool blendsCoverage = false;  ///< drawn once more so, for what of a cut-out cloth is there in part
  bool ordered = false;         ///< of both: its triangles are drawn far to near (triangle_order.h)
  bool isPartial = false;       ///< of blendsCoverage: it is drawn once, all of it blended
  bool bothSides = false;       ///< faces of either winding, in one call
  bool mirrored = false;        ///< the node's matrix reverses the winding
  bool ghost = false;           ///< of frame::Ghosts: it casts no shadow
  bool visible = true;          ///< else it only casts its shadow
  double depth = 0;             ///< clip z of the primitive's centre
  int materialRank = 0;         ///< order of first use
  int materialIndex = -1;       ///< in the scene, in the shot's variant; -1 = glTF's default one
  std::shared_ptr<const std::vector<std::uint32_t>> farToNear;  ///< triangles of ordered draws; null = as they come

  /// Null = drawn once, where the node is.
  const Instances* instances() const { return node->instances.get(); }
  /// The smallest alpha of the base colour map that passes the alpha test; above 1 none does.
  float textureCutoff() const { return telar::textureCutoff(*material); }
  /// Whether its program knows of the lines of its relief. Facets lie too flat for them to matter.
  bool hasReliefAxis() const { return key.normalVariance && key.normalMap && !key.normalFacets; }
  /// Triangles cast, each once: the first of the two draws of a blended double-sided surface is left out.
  bool castsShadow() const { return primitive->topology == Topology::kTriangles && !key.flipSided && !ghost; }
};

/// The draw calls of a frame in the order in which three.js 0.187 draws them. Points into the scene.
struct DrawList {
  std::vector<DrawItem> opaque;
  std::vector<DrawItem> transmissive;  ///< far to near
  std::vector<DrawItem> blended;       ///< far to near
  /// For the transmission target, in linear radiance: the opaque draws, and the back sides of double-sided transmissive
  /// surfaces. Empty where nothing transmits.
  std::vector<DrawItem> behind;
  std::vector<DrawItem> behindBackSides;

  /// The draws of the picture itself, without those of the transmission target.
  std::array<const std::vector<DrawItem>*, 3> shown() const { return {&opaque, &transmissive, &blended}; }
  std::array<const std::vector<DrawItem>*, 5> all() const {
    return {&behind, &behindBackSides, &opaque, &transmissive, &blended};
  }
  std::size_t size() const;
};

/// What a frame needs besides the draws.
struct FramePlan {
  frame::Camera camera;
  glm::dvec3 origin{0};  ///< world point that shaders count world coordinates from
  LightSet lights;
  ShadowSet shadows;
  frame::Ghosts ghosts;               ///< what draws of translucent parts point to
  frame::ReleaseMaterials materials;  ///< what draws point to where a release reads a material otherwise
  std::vector<std::shared_ptr<const Material>> plain;  ///< what those of layers point to
  DrawList draws;
  shader::VariantKey frame;  ///< what all programs share: lights, tone mapping, kind of output
  bool environment = false;  ///< a lit material samples it
  bool environmentBackground = false;
  bool ground = false;        ///< shadows fall on it
  bool sheerShadows = false;  ///< light gets through what is blended
  bool everyHole = false;     ///< and through small holes of a net

  /// Every program that the draws use, each once.
  std::set<shader::VariantKey> keys() const;
};

/// Decides, without GL, what a frame compiles and draws. A key has only the features that its material and the shot
/// use.
/// @param allFeatures  turn everything on (benchmark)
/// @throws Error{E_VARIANT, L_LIGHTS, L_SHADOW_TEXELS, L_TEXTURE_UNITS}
FramePlan planDraws(const Scene& scene, const Shot& shot, const Limits& limits, bool allFeatures);

/// Turns everything on that does not change the picture: maps read neutral texels, lights are black.
void forceAllFeatures(shader::VariantKey& key);

/// The same for the layers beside the picture: every surface once, as opaque as its alpha is at least
/// frame::LAYER_ALPHA, with what its normal and its base colour are made of, and the lights that cast a shadow where
/// the shot has the layer of shadows.
FramePlan planLayers(const Scene& scene, const Shot& shot, const Limits& limits);

}  // namespace telar::pass
