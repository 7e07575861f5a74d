#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "telar/fabric.h"
#include "telar/image.h"
#include "telar/luminance.h"
#include "telar/motion.h"
#include "telar/pending_images.h"
#include "telar/shading.h"
#include "telar/shared_list.h"
#include "telar/texture_ref.h"

/// A glTF file after loading: plain data, checked, owned, free of GL. Units are glTF's: metres, radians, candela, lux.
/// Everything an index points to exists: consumers index without checks.
namespace telar {

enum class AlphaMode { kOpaque, kMask, kBlend };
enum class Topology { kPoints, kLines, kLineLoop, kLineStrip, kTriangles };  ///< strips and fans are made triangles

/// What the KHR_materials_* extensions add to metallic-roughness: js/material/table.mjs. Factors are linear Rec.709;
/// the defaults change nothing.
struct PhysicalLayers {
#include "telar/physical_layers.inc"
};

/// A vector in the plane. @param angle radians, counter-clockwise from x
inline glm::vec2 polar(float length, float angle) {
  return glm::vec2(glm::dvec2(length * std::cos(double{angle}), length * std::sin(double{angle})));
}

/// glTF metallic-roughness material. Factors are linear Rec.709.
struct Material {
  std::string name;
  glm::vec4 baseColorFactor{1.0f};
  TextureRef baseColorTexture;  ///< sRGB
  float metallicFactor = 1.0f;
  float roughnessFactor = 1.0f;         ///< perceptual
  TextureRef metallicRoughnessTexture;  ///< linear: G roughness, B metalness
  TextureRef normalTexture;             ///< linear
  float normalScale = 1.0f;
  TextureRef occlusionTexture;  ///< linear: R
  float occlusionStrength = 1.0f;
  glm::vec3 emissiveFactor{0.0f};
  TextureRef emissiveTexture;  ///< sRGB
  AlphaMode alphaMode = AlphaMode::kOpaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  /// The tangent frame follows its textures' coordinates: the mesh's tangents belong to others.
  bool ignoresTangents = false;
  bool unlit = false;     ///< KHR_materials_unlit
  bool physical = false;  ///< an extension of `layers` is there: three.js shades with MeshPhysicalMaterial
  PhysicalLayers layers;
  FabricLayers fabric;  ///< read by the shading "fabric" only
  std::string preset;   ///< of TELAR_materials_fabric; empty = none
  int withPreset = -1;  ///< index into Scene::materials of this material with its preset: the shading "fabric" takes it
};

/// Axis-aligned box in metres, in double; empty when min > max.
struct Bounds {
  glm::dvec3 min{std::numeric_limits<double>::infinity()};
  glm::dvec3 max{-std::numeric_limits<double>::infinity()};
  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  void add(const glm::dvec3& p) { min = glm::min(min, p), max = glm::max(max, p); }
  glm::dvec3 middle() const { return (min + max) * 0.5; }     ///< @pre not empty
  double diagonal() const { return glm::length(max - min); }  ///< metres; infinite where it is empty
  std::array<glm::dvec3, 8> corners() const {
    std::array<glm::dvec3, 8> out;
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = {(i & 1 ? max : min).x, (i & 2 ? max : min).y, (i & 4 ? max : min).z};
    return out;
  }
};

/// Vertex streams of one draw. A stream is empty when the file has none; else it has positions.size() entries.
struct Primitive {
  Topology topology = Topology::kTriangles;
  std::vector<glm::vec3> positions;  ///< finite
  std::vector<glm::vec3> normals;    ///< as in the file; empty = shade flat
  std::vector<glm::vec4> tangents;   ///< w = +-1
  std::array<std::vector<glm::vec2>, 2> uvs;
  std::vector<glm::vec4> colors;  ///< linear, alpha 1 where the file gives RGB
  bool colorsHaveAlpha = false;
  /// Ambient visibility of the front and of the back: w the part of the hemisphere above that is open, by the cosine,
  /// 0..1; xyz the mean open direction as normals are given, not unit, 0 where the normal stands for it.
  std::array<std::vector<glm::vec4>, 2> visibility;
  std::vector<std::uint32_t> indices;          ///< empty = draw vertices in order; every index < positions.size()
  int file = -1;                               ///< index in its mesh of the file; -1 = of no file
  int material = -1;                           ///< -1 = glTF's default material
  std::map<int, int> variantMaterials;         ///< by variant index; a variant that is not here keeps `material`
  Bounds bounds;                               ///< of positions, in mesh space
  Bounds fileBounds;                           ///< as the file declares them, else of all vertices; empty = `bounds`
  std::optional<glm::dvec3> center;            ///< that draws are sorted by, mesh space; none = of fileBounds
  std::shared_ptr<const Deformers> deformers;  ///< null = its vertices stand still in mesh space
};

/// Bounds that three.js has of it: what no index names lies in them too.
inline const Bounds& fileBoundsOf(const Primitive& primitive) {
  return primitive.fileBounds.empty() ? primitive.bounds : primitive.fileBounds;
}

/// Whether all of a surface is there, whatever its alpha.
inline bool isOpaque(const Material& material) {
  return material.alphaMode == AlphaMode::kOpaque ||
         (material.alphaMode == AlphaMode::kMask && material.alphaCutoff <= 0);
}

/// Whether the tangent frame of a material is that of the mesh's own tangents.
inline bool hasTangents(const Primitive& primitive, const Material& material) {
  return !primitive.tangents.empty() && !material.ignoresTangents;
}

struct Mesh {
  std::string name;
  SharedList<Primitive> primitives;
  int file = -1;  ///< index in the file; -1 = of no file
};

enum class LightType { kDirectional, kPoint, kSpot };

/// KHR_lights_punctual.
struct ModelLight {
  LightType type = LightType::kPoint;
  std::string name;
  glm::vec3 color{1.0f};        ///< linear
  float intensity = 1.0f;       ///< lux (directional) or candela
  float range = 0.0f;           ///< metres, 0 = infinite
  float innerConeAngle = 0.0f;  ///< radians
  float outerConeAngle = 0.7853982f;
  bool isCopied = false;  ///< several nodes of the file name it
};

/// Where light comes from that a node's light gives along one direction, not unit. Lights of glTF shine along -Z; but GLTFLoader
/// copies one that several nodes name, and its copies shine from their place towards the world's origin. Zero = they give nothing.
inline glm::dvec3 towardsLight(const ModelLight& light, const glm::dmat4& world) {
  return glm::dvec3(world[light.isCopied ? 3 : 2]);
}

/// Whether it gives light anywhere, where its node is.
inline bool shines(const ModelLight& light, const glm::dmat4& world) {
  return shines(light.color, light.intensity) &&
         (light.type == LightType::kPoint || towardsLight(light, world) != glm::dvec3(0));
}

struct ModelCamera {
  std::string name;
  bool perspective = true;
  double fovY = 0;            ///< radians
  double aspectRatio = 0;     ///< 0 = not given
  double xmag = 0, ymag = 0;  ///< orthographic half extents, metres
  double near = 0, far = 0;   ///< metres, far 0 = infinite
};

/// A node that is reached from the drawn scene, parents before children.
struct Node {
  std::string name;
  int parent = -1;        ///< index into Scene::nodes
  glm::dmat4 local{1.0};  ///< column-major, column vectors
  glm::dmat4 world{1.0};
  int mesh = -1, light = -1, camera = -1;  ///< as drawn: none where the node is squeezed to nothing
  struct {
    int node = -1, mesh = -1, light = -1, camera = -1;
  } file;                      ///< as the file has them; `mesh` stands for itself or for a deformed copy of file.mesh
  Transform transform;         ///< that `local` is made of
  int skin = -1;               ///< index into Motion::skins
  std::vector<float> weights;  ///< of the morph targets
  std::shared_ptr<const Instances> instances;  ///< null = drawn once, where the node is
  /// By index of a material: the one that its mesh shows in its place. Null = its own; nodes of one mesh share it.
  std::shared_ptr<const std::map<int, int>> materials;

  /// How many times its mesh is to be seen.
  std::size_t places() const { return instances ? instances->matrices.size() : 1; }
};

struct Warning {
  std::string code;  ///< W_*, a row of js/error/table.mjs
  std::string message;
  std::string pointer;  ///< may be empty
};

struct Scene;

/// A scene whose images another one shows.
struct WornCloth {
  std::shared_ptr<const Scene> scene;
  std::size_t firstImage = 0;  ///< place of its first image in `images` of the other
};

struct Scene {
  std::string name;
  std::string generator, copyright;
  std::vector<Node> nodes;
  std::vector<Mesh> meshes;  ///< see fileMeshes
  std::vector<Material> materials;
  SharedList<Image8> images;  ///< see pendingImages; width 0 = not used by any reached material
  std::vector<ModelLight> lights;
  std::vector<ModelCamera> cameras;
  std::vector<std::string> variants;  ///< KHR_materials_variants names
  std::vector<std::string> extensionsUsed;
  std::vector<Warning> warnings;                                    ///< at most 100, no two alike
  Bounds bounds;                                                    ///< of all drawn vertices in world space
  std::uint64_t vertexCount = 0, triangleCount = 0, drawCount = 0;  ///< over all draws
  std::uint64_t fileBytes = 0;
  std::string sha256;                    ///< of the file and the parts that it names, hashModel()
  std::uint64_t memoryBytes = 0;         ///< of what is here and of its copies on the GPU, see Limits::memoryBytes
  std::size_t fileWarnings = 0;          ///< so many of `warnings` are the file's; those of the pose follow
  std::size_t fileMaterials = 0;         ///< so many of `materials` are the file's; those with presets follow
  std::size_t fileMeshes = 0;            ///< so many of `meshes` are the file's; deformed ones follow
  std::size_t fileImages = 0;            ///< so many of `images` are the file's; those of cloths follow
  std::shared_ptr<const Motion> motion;  ///< null = nothing moves
  /// Of a scene that was made of another one (posed, dressed, exploded): the one as loaded, which owns the file's
  /// meshes and images.
  std::shared_ptr<const Scene> model;
  std::vector<WornCloth> cloths;                 ///< of a dressed scene: whose images those beyond fileImages are
  std::shared_ptr<PendingImages> pendingImages;  ///< null = the pixels of all images are there
};

/// To be called before pixels of images are read. @throws Error as PendingImages::wait()
inline void waitForImages(const Scene& scene, const CancelToken& cancel) {
  if (scene.pendingImages) scene.pendingImages->wait(cancel);
}

/// The alpha of its texture from which on a cut-out material is there: the factor multiplies it. Above 1 = nowhere.
inline float textureCutoff(const Material& material) {
  const float factor = material.baseColorFactor.a;
  return factor > 0 ? material.alphaCutoff / factor : 2.0f;
}

/// What a shading draws of one of the scene's materials: the shading "fabric" takes it with its preset.
inline const Material& shownMaterial(const Scene& scene, const Material& material, ShadingModel shading) {
  const bool filled = shading == ShadingModel::kFabric && material.withPreset >= 0;
  return filled ? scene.materials[static_cast<std::size_t>(material.withPreset)] : material;
}

}  // namespace telar
