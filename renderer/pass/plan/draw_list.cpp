#include "pass/plan/draw_list.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "frame/layers.h"
#include "frame/sample_passes.h"
#include "frame/variant.h"
#include "pass/plan/texture_slots.h"
#include "pass/plan/world_origin.h"

namespace telar::pass {
namespace {

constexpr std::size_t ALL_FEATURES_LIGHTS = 2;  // of each kind

/// Layers of KHR_materials_* that change the picture: a layer of weight 0 is not compiled in.
void describeLayers(const Material& m, shader::VariantKey& key) {
  const PhysicalLayers& l = m.layers;
#include "pass/physical_conditions.inc"
}

/// Features that only the shading "fabric" reads.
void describeFabric(const Material& m, shader::VariantKey& key) {
  const FabricLayers& fabric = m.fabric;
  key.diffuseTransmission = fabric.diffuseTransmissionFactor > 0;
  key.flatness = fabric.flatness > 0;
  key.weave = fabric.weave;
  key.back = fabric.back && m.doubleSided;
}

/// Those of them that a principled shading reads: where its diffuse term has a use for them.
void describePrincipled(const Material& m, shader::VariantKey& key) {
  const FabricLayers& fabric = m.fabric;
  const bool thin = key.terms.diffuse == ShadingTerms::DIFFUSE_DISNEY_2015_THIN;
  key.flatness = fabric.flatness > 0 && (thin || key.terms.diffuse == ShadingTerms::DIFFUSE_DISNEY_2012);
  key.diffuseTransmission = fabric.diffuseTransmissionFactor > 0 && thin;
}

/// Whether the factor of a texture is above 0.
bool matters(const TextureSlot& slot, const Material& m, const shader::VariantKey& key) {
  using Key = shader::VariantKey;
  if (slot.map == &Key::baseColorMap) return true;
  if (key.unlit) return false;
  // Yarns have roughness of their own, times the same texels.
  if (slot.map == &Key::metallicRoughnessMap) return m.metallicFactor != 0 || m.roughnessFactor != 0 || key.weave;
  if (slot.map == &Key::occlusionMap) return m.occlusionStrength != 0;
  if (slot.map == &Key::emissiveMap) return key.emissive;
  return !slot.layer || key.*slot.layer;
}

/// Whether two textures lie on each other.
bool samePlace(const TextureRef& a, const TextureRef& b) {
  return a.texCoord == b.texCoord && a.uvTransform == b.uvTransform;
}

/// Whether one read gives the texels of both.
bool sameTexels(const TextureRef& a, const TextureRef& b) {
  return a.image == b.image && a.sampler == b.sampler && samePlace(a, b);
}

/// Whether a texture may have holes. Its texels may not be there yet.
bool mayHaveAlpha(const TextureRef& texture, const Scene& scene) {
  const auto image = static_cast<std::size_t>(texture.image);
  return texture && (image >= scene.images.size() || scene.images[image].format != "JPEG");
}

/// Texture features of a material; a map that is multiplied by 0 is not sampled.
void describeMaps(const Material& m, const Scene& scene, shader::VariantKey& key) {
  if (!key.unlit) {
    key.emissive = m.emissiveFactor != glm::vec3(0);
    if (m.physical) describeLayers(m, key);
    if (key.shading == ShadingModel::kFabric) describeFabric(m, key);
    if (isPrincipled(key.shading)) describePrincipled(m, key);
  }
  for (const TextureSlot& slot : TEXTURE_SLOTS) {
    const TextureRef& texture = slot.texture(m);
    key.*slot.map = texture && matters(slot, m, key);
    key.*slot.uv1 = key.*slot.map && texture.texCoord == 1;
  }
  key.occlusionWithRoughness =
      key.occlusionMap && key.metallicRoughnessMap && sameTexels(m.occlusionTexture, m.metallicRoughnessTexture);
  if (key.shading != ShadingModel::kFabric || key.layers) return;
  key.alphaMeans = !key.alphaOpaque && key.baseColorMap && mayHaveAlpha(m.baseColorTexture, scene);
  // Passes that read maps unfiltered need no variance and no coverage.
  if (key.fullDetail) return;
  key.normalVariance = key.normalMap || key.clearcoatNormalMap;
  key.alphaToCoverage = key.alphaMask && key.baseColorMap;
  const bool hasHoles = key.alphaToCoverage || key.alphaMeans;
  key.normalHoles = hasHoles && key.normalMap && samePlace(m.normalTexture, m.baseColorTexture);
  key.yarnRelief =
      key.normalMap && key.weaveMap && !key.normalHoles && samePlace(m.fabric.weaveTexture, m.normalTexture);
  // Colours of cloth with holes are means of what is there.
  key.metalMeans = key.baseColorMap && key.metallicRoughnessMap && m.metallicFactor > 0 && !hasHoles && !key.unlit &&
                   samePlace(m.metallicRoughnessTexture, m.baseColorTexture);
  key.metalYarns = key.metalMeans && key.weaveMap && samePlace(m.fabric.weaveTexture, m.baseColorTexture);
}

/// Whether flat facets of a normal map and the edges between them are to have highlights of their own: on polished
/// metal, whose light is all gloss.
bool hasFacets(const Material& m, const shader::VariantKey& key) {
#include "pass/polished.inc"
  const bool oneLobe = !key.weave && !key.anisotropy && !key.normalHoles;
  return key.normalVariance && key.normalMap && oneLobe && key.environmentSamples == 0 &&
         m.roughnessFactor <= POLISHED_ROUGHNESS_MAX && m.metallicFactor >= POLISHED_METALNESS_MIN;
}

/// Which sides know what of the hemisphere above them is open. Only the shading "fabric" reads it.
void describeVisibility(const Primitive& primitive, const Material& material, shader::VariantKey& key) {
  if (key.shading != ShadingModel::kFabric || key.layers) return;
  key.ambientVisibility = !primitive.visibility[0].empty();
  key.ambientVisibilityBack =
      key.ambientVisibility && !primitive.visibility[1].empty() && (material.doubleSided || key.diffuseTransmission);
}

shader::VariantKey keyOf(const Primitive& primitive, const Material& material, const Scene& scene,
                         const shader::VariantKey& frame) {
  shader::VariantKey key;
  key.toneMapping = frame.toneMapping;
  key.outputLinear = frame.outputLinear;
  key.debugOutput = frame.debugOutput;
  key.fullDetail = frame.fullDetail;
  key.layers = frame.layers;
  key.points = primitive.topology == Topology::kPoints;
  const bool lines = primitive.topology != Topology::kTriangles && !key.points;
  // three.js shows points and lines with unlit materials of the same colour.
  key.unlit = material.unlit || primitive.topology != Topology::kTriangles;
  key.vertexColor = !primitive.colors.empty();
  // three.js does not hand the cutoff of lines on.
  key.alphaMask = !lines && material.alphaMode == AlphaMode::kMask && material.alphaCutoff > 0;
  key.alphaOpaque = material.alphaMode != AlphaMode::kBlend;
  if (!key.unlit) key.shading = frame.shading, key.terms = frame.terms;
  key.three = frame.three;
  describeMaps(material, scene, key);
  if (key.points) key.baseColorUv1 = false;  // three.js's points know one set of coordinates
  if (lines && key.three.lineMap == ThreeTerms::THREE_LINE_MAP_NONE) key.baseColorMap = key.baseColorUv1 = false;
  if (key.unlit) return key;
  key.ambient = frame.ambient;
  key.environment = frame.environment;
  key.environmentSamples = frame.environmentSamples;
  key.orthographic = frame.orthographic;
  key.lights = frame.lights;
  key.flatShaded = primitive.normals.empty();
  key.normalFacets = hasFacets(material, key);
  key.ownPlaces = frame.ownPlaces && key.alphaMeans;  // of other cloth they show noise where threads are still seen
  describeVisibility(primitive, material, key);
  const bool stretched = key.anisotropy || key.weave;
  key.tangent = (key.normalMap || stretched) && !key.flatShaded && hasTangents(primitive, material);
  key.tangentFrameUv0 = stretched && !key.normalMap && !key.clearcoatNormalMap && !key.weaveMap;
  // The normal of a flat face needs no flip. Its tangent frame does.
  const bool hasFrame = key.normalMap || key.clearcoatNormalMap || stretched;
  const bool turns = hasFrame && key.three.flatFrames != ThreeTerms::THREE_FLAT_FRAMES_KEPT;
  key.doubleSided = material.doubleSided && (!key.flatShaded || turns);
  return key;
}

/// Texture units of a program as three.js counts them: its maps, its tables, and every light that casts a shadow,
/// also one that shines on nothing. WebGL 2 promises 16, and a browser shows nothing of what goes over.
/// @throws Error{L_TEXTURE_UNITS}
void checkTextureUnits(const shader::VariantKey& key, const ShadowSet& shadows, const Limits& limits) {
  if (key.unlit || shadows.casting == 0) return;
  const std::size_t areaTables = key.lights.area() > 0 ? 2 : 0;
  std::size_t units =
      1 + key.environment + (key.environmentSamples > 0) + key.transmission + areaTables + shadows.casting;
  for (const TextureSlot& slot : TEXTURE_SLOTS) units += key.*slot.map;
  units += key.metalMeans + key.yarnRelief;
  checkLimit("L_TEXTURE_UNITS", static_cast<double>(limits.textureUnits), static_cast<double>(units), "/lights");
}

/// Releases whose programs of vertex colours that morph do not compile draw nothing of such a mesh but its shadow.
bool hasProgram(const Primitive& primitive, const ThreeTerms& three) {
  if (three.morphColors != ThreeTerms::THREE_MORPH_COLORS_NO_PROGRAM || !primitive.deformers) return true;
  const auto& targets = primitive.deformers->targets;
  return std::none_of(targets.begin(), targets.end(), [](const MorphTarget& t) { return !t.colors.empty(); });
}

void describeInstances(const Node& node, const ThreeTerms& three, shader::VariantKey& key) {
  if (!node.instances) return;
  key.instancing = true;
  key.instanceColor = !node.instances->colors.empty() && three.instanceColor == ThreeTerms::THREE_INSTANCE_COLOR_DRAWN;
  key.vertexColor |= key.instanceColor;  // white where the mesh has none
}

/// Centre of the sphere that three.js sorts by, in the node's space.
glm::dvec3 centerOf(const Node& node, const Primitive& primitive, std::size_t index) {
  if (node.instances) return node.instances->centers[index];
  return primitive.center ? *primitive.center : fileBoundsOf(primitive).middle();
}

/// What three.js sorts by: clip z, in some releases over w, which is not the same for what is behind the camera.
double depthOf(const DrawItem& item, std::size_t index, const glm::dmat4& viewProjection, const ThreeTerms& three) {
  const bool origin = three.sorting == ThreeTerms::THREE_SORTING_ORIGIN;
  const glm::dvec3 place = origin ? glm::dvec3(0) : centerOf(*item.node, *item.primitive, index);
  const glm::dvec4 clip = viewProjection * item.node->world * glm::dvec4(place, 1.0);
  return three.sorting == ThreeTerms::THREE_SORTING_BOUNDING_SPHERE ? clip.z : clip.z / clip.w;
}

void sortDraws(DrawList& draws) {
  // Stable: equal items keep the scene's order, which is three.js's object id.
  std::stable_sort(draws.opaque.begin(), draws.opaque.end(), [](const DrawItem& a, const DrawItem& b) {
    return std::tie(a.materialRank, a.depth) < std::tie(b.materialRank, b.depth);
  });
  for (auto* list : {&draws.transmissive, &draws.blended}) {
    std::stable_sort(list->begin(), list->end(),
                     [](const DrawItem& a, const DrawItem& b) { return a.depth > b.depth; });
  }
}

/// Whether folds of a net or a sheer cloth are to show what lies behind them (js/three/shading/triangle_order.mjs).
bool isOrdered(const DrawItem& item) {
  return (item.blend || item.blendsCoverage) && item.key.shading == ShadingModel::kFabric && !item.key.transmission &&
         !item.key.unlit && !item.key.debugOutput && !item.instances() &&
         item.primitive->topology == Topology::kTriangles;
}

/// Cut-out cloth is drawn after all that is opaque, so that what is there in part is blended over it. Where something
/// transmits, it stays: what is blended is not seen through glass.
void blendCoverage(DrawList& draws) {
  const auto cut = std::stable_partition(draws.opaque.begin(), draws.opaque.end(),
                                         [](const DrawItem& item) { return !item.key.alphaToCoverage; });
  for (auto item = cut; item != draws.opaque.end(); ++item) {
    item->blendsCoverage = true;
    item->ordered = isOrdered(*item);
    draws.blended.push_back(*item);
  }
  draws.opaque.erase(cut, draws.opaque.end());
}

DrawItem oneSide(DrawItem item, bool back) {
  item.bothSides = item.key.doubleSided = false;
  item.key.flipSided = back;
  return item;
}

/// With what gets through casters of a shadow. One pass shows of nets what a browser does.
FramePlan withCasters(FramePlan plan, const Shot& shot) {
  plan.sheerShadows = shot.shading == ShadingModel::kFabric;
  plan.everyHole = plan.sheerShadows && frame::samplePassesOf(shot).count > 1;
  return plan;
}

/// A blended double-sided surface is drawn twice, back faces first, each as if it were single-sided. Points and lines
/// have no faces: three.js draws all of them both times.
void splitBlended(std::vector<DrawItem>& list) {
  std::vector<DrawItem> split;
  split.reserve(list.size());
  for (const DrawItem& item : list) {
    const auto side = [&item](bool back) { return item.bothSides ? oneSide(item, back) : item; };
    const bool twice = item.blend && item.material->doubleSided && !item.ordered;
    if (twice) split.push_back(side(true));
    split.push_back(twice ? side(false) : item);
  }
  list = std::move(split);
}

/// The draws into the transmission target: without exposure and tone mapping, which the surface in front applies
/// later.
void addBehind(DrawList& draws, const ThreeTerms& three) {
  const auto linear = [](DrawItem item) {
    item.key.toneMapping = shader::ToneMapping::kNone;
    item.key.outputLinear = true;
    item.key.debugOutput = false;
    return item;
  };
  for (const DrawItem& item : draws.opaque) draws.behind.push_back(linear(item));
  if (three.glassBackSides == ThreeTerms::THREE_GLASS_BACK_SIDES_NONE) return;
  for (const DrawItem& item : draws.transmissive) {
    if (item.bothSides) draws.behindBackSides.push_back(linear(oneSide(item, true)));
  }
}

FramePlan planFrame(const Scene& scene, const Shot& shot, const Limits& limits, bool allFeatures, bool layers) {
  FramePlan plan;
  plan.frame.layers = layers;
  plan.camera = frame::cameraOf(shot);
  plan.origin = worldOrigin(scene.bounds);
  const LightChoice lights(scene, shot, plan.camera, limits);
  plan.lights = collectLights(scene, shot, lights, plan.camera);
  if (allFeatures) plan.lights.pad(ALL_FEATURES_LIGHTS);
  plan.shadows = collectShadows(shot, lights, limits, scene.bounds);
  plan.ground = shot.ground && !plan.shadows.empty();
  const bool hasEnvironment = shot.environment.source != Shot::Environment::Source::kNone;
  plan.environmentBackground = hasEnvironment && shot.background.type == Shot::Background::Type::kEnvironment;

  shader::VariantKey& frame = plan.frame;
  plan.lights.describe(frame);
  plan.shadows.describe(frame);
  frame.environment = hasEnvironment && shot.environment.intensity != 0;
  frame.orthographic = plan.camera.orthographic;
  frame.debugOutput = shot.debugOutput != DebugOutput::kNone;
  frame.outputLinear =
      !frame.debugOutput && (shot.resolve == Resolve::kLinear || framePixelType(shot.output) == PixelType::kRgbaF32);
  frame.shading = shot.shading;
  if (isPrincipled(shot.shading)) frame.terms = shot.terms;
  frame.three = shot.three;
  const frame::SamplePasses passes = frame::samplePassesOf(shot);
  frame.fullDetail = passes.count > 1 && !frame.debugOutput;
  frame.ownPlaces = frame.fullDetail && passes.haveCells();
  if (frame.environment && !frame.debugOutput) {
    frame.environmentSamples = static_cast<std::uint16_t>((shot.environmentSamples + passes.count - 1) / passes.count);
  }
  frame.toneMapping = frame.outputLinear ? shader::ToneMapping::kNone : shot.toneMapping;

  plan.ghosts = frame::Ghosts(scene, shot);
  const int variant = frame::variantIndex(scene, shot.variant);
  const glm::dmat4 viewProjection = plan.camera.projection * plan.camera.view;
  std::map<int, int> ranks;
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    const auto& primitives = scene.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const Primitive& primitive = primitives[i];
      if (primitive.positions.empty()) continue;
      const int index = materialIndex(node, primitive, variant);
      DrawItem item{&node, &primitive, &frame::materialAt(scene, index, shot.shading)};
      if (const auto read = plan.materials.of(*item.material, primitive, frame.three)) item.material = read.get();
      const float opacity = plan.ghosts.opacity(node, materialIndex(primitive, variant));
      if (opacity == 0) continue;
      item.ghost = opacity < 1;
      if (item.ghost) item.material = plan.ghosts.of(*item.material, opacity).get();
      if (layers) item.material = plan.plain.emplace_back(frame::plainMaterial(*item.material)).get();
      item.key = keyOf(primitive, *item.material, scene, frame);
      const bool transmissive = item.key.transmission;
      describeInstances(node, frame.three, item.key);
      item.visible = hasProgram(primitive, frame.three);
      if (allFeatures) forceAllFeatures(item.key);
      checkTextureUnits(item.key, plan.shadows, limits);
      plan.environment |= item.key.environment;
      item.blend = item.material->alphaMode == AlphaMode::kBlend && !layers;
      item.ordered = isOrdered(item);
      item.materialIndex = index;
      item.mirrored = glm::determinant(glm::dmat3(node.world)) < 0;
      item.depth = depthOf(item, i, viewProjection, frame.three);
      item.materialRank = ranks.emplace(index, static_cast<int>(ranks.size())).first->second;
      item.bothSides = item.material->doubleSided && primitive.topology == Topology::kTriangles;
      (transmissive ? plan.draws.transmissive : item.blend ? plan.draws.blended : plan.draws.opaque).push_back(item);
    }
  }
  if (plan.draws.transmissive.empty() && !frame.debugOutput) blendCoverage(plan.draws);
  sortDraws(plan.draws);
  if (!plan.draws.transmissive.empty()) addBehind(plan.draws, frame.three);
  splitBlended(plan.draws.transmissive);
  splitBlended(plan.draws.blended);
  return plan;
}

}  // namespace

std::size_t DrawList::size() const {
  std::size_t sum = 0;
  for (const auto* list : all()) sum += list->size();
  return sum;
}

std::set<shader::VariantKey> FramePlan::keys() const {
  std::set<shader::VariantKey> keys;
  for (const auto* list : draws.all()) {
    for (const DrawItem& item : *list) keys.insert(item.key);
  }
  return keys;
}

void forceAllFeatures(shader::VariantKey& key) {
  if (key.unlit) return;
  key.baseColorMap = key.metallicRoughnessMap = key.normalMap = key.occlusionMap = key.emissive = key.emissiveMap =
      true;
  key.vertexColor = key.alphaMask = key.environment = true;
  // Anisotropy is left out: its frame changes the picture even at strength 0.
  key.specular = key.clearcoat = key.sheen = key.iridescence = true;
  key.transmission = key.volume = key.attenuation = true;
  // Releases of three.js that do not know them have no text for them.
  key.diffuseRoughness = key.three.diffuseRoughness != ThreeTerms::THREE_DIFFUSE_ROUGHNESS_NONE;
  key.dispersion = key.three.dispersion != ThreeTerms::THREE_DISPERSION_NONE;
}

FramePlan planDraws(const Scene& scene, const Shot& shot, const Limits& limits, bool allFeatures) {
  return withCasters(planFrame(scene, shot, limits, allFeatures, false), shot);
}

FramePlan planLayers(const Scene& scene, const Shot& shot, const Limits& limits) {
  Shot plain = shot;
  plain.environment = {};
  plain.background = {};
  plain.modelLights = false;
  const bool shadows = shot.hasLayer(Layer::kShadow);
  std::erase_if(plain.lights, [&](const Shot::Light& light) { return !shadows || !light.castShadow; });
  if (!shadows) plain.ground.reset();
  plain.debugOutput = DebugOutput::kNone;
  plain.toneMapping = ToneMapping::kNone;
  plain.samples = 1;
  plain.maxLights = 0;
  return withCasters(planFrame(scene, plain, limits, false, true), shot);
}

}  // namespace telar::pass
