#include "asset/pose/place.h"

#include "asset/check/pointer.h"
#include "asset/geometry/drawn_points.h"
#include "asset/geometry/repair.h"
#include "asset/pose/deform.h"
#include "asset/pose/transform.h"

namespace telar::asset {
namespace {

constexpr double WORLD_MAX = 1e30;  // a float holds it, so that a world coordinate can be tried as one

std::uint64_t trianglesOf(const Primitive& primitive) {
  if (primitive.topology != Topology::kTriangles) return 0;
  return (primitive.indices.empty() ? primitive.positions.size() : primitive.indices.size()) / 3;
}

bool isDrawable(const Bounds& bounds) {
  return !bounds.empty() && asset::isDrawable(glm::vec3(glm::clamp(bounds.min, -WORLD_MAX, WORLD_MAX))) &&
         asset::isDrawable(glm::vec3(glm::clamp(bounds.max, -WORLD_MAX, WORLD_MAX)));
}

class Placer {
 public:
  Placer(Scene& scene, Warnings& warnings, const CancelToken& cancel)
      : scene_(scene), warnings_(warnings), cancel_(cancel), points_(cancel) {
    if (scene.motion) joints_.resize(scene.motion->skins.size());
  }

  void run() {
    scene_.meshes.resize(scene_.fileMeshes);
    scene_.bounds = Bounds();
    scene_.vertexCount = scene_.triangleCount = scene_.drawCount = 0;
    for (Node& node : scene_.nodes) placeNode(node);
    for (Node& node : scene_.nodes) {
      if (node.mesh >= 0) placeMesh(node);
    }
  }

 private:
  void placeNode(Node& node) {
    node.local = matrixOf(node.transform);
    node.world = node.parent < 0 ? node.local : scene_.nodes[static_cast<std::size_t>(node.parent)].world * node.local;
    node.mesh = node.light = node.camera = -1;
    if (!isCollapsed(node.world)) {
      node.mesh = node.file.mesh, node.light = node.file.light, node.camera = node.file.camera;
    } else if (node.file.mesh >= 0) {
      warnings_.add("W_SCALE", "the node's scale is zero or not finite, so its mesh is not drawn",
                    pointer("nodes", node.file.node));
    }
  }

  void placeMesh(Node& node) {
    cancel_.check();
    deform(node);
    const auto& primitives = scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    Bounds bounds;
    for (const Primitive& primitive : primitives) {
      points_.visit(node, primitive, [&](const glm::dvec3& p) { bounds.add(p); });
    }
    if (!isDrawable(bounds)) {
      if (!primitives.empty()) {
        warnings_.add("W_NONFINITE",
                      "the mesh of the node " + telar::quoted(node.name) + " is too far away or too large to draw");
      }
      node.mesh = -1;
      return;
    }
    scene_.bounds.min = glm::min(scene_.bounds.min, bounds.min);
    scene_.bounds.max = glm::max(scene_.bounds.max, bounds.max);
    scene_.drawCount += primitives.size();
    for (const auto& p : primitives) {
      scene_.vertexCount += p.positions.size() * node.places();
      scene_.triangleCount += trianglesOf(p) * node.places();
    }
  }

  /// Gives the node a mesh of its own where something deforms its mesh now.
  void deform(Node& node) {
    const Mesh& source = scene_.meshes[static_cast<std::size_t>(node.mesh)];
    Deformation deformation;
    deformation.weights = node.weights;
    if (node.skin >= 0 && !node.instances) {
      deformation.joints = jointsOf(node.skin);
      deformation.worldToNode = inverseOf(node.world);
    }
    bool any = false;
    for (const Primitive& primitive : source.primitives) any |= deforms(deformation, primitive);
    if (!any) return;
    std::size_t dropped = 0;
    std::vector<Primitive> primitives;
    for (const Primitive& primitive : source.primitives) {
      cancel_.check();
      primitives.push_back(deformed(primitive, deformation, dropped));
    }
    if (dropped > 0) {
      warnings_.add("W_NONFINITE", std::to_string(dropped) + " elements are not finite where they are deformed to",
                    pointer("nodes", node.file.node));
    }
    node.mesh = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back({source.name, std::move(primitives)});
  }

  /// Zero where there is none, as three.js has it: the mesh is then not to be seen.
  static glm::dmat4 inverseOf(const glm::dmat4& world) {
    return glm::determinant(glm::dmat3(world)) == 0 ? glm::dmat4(0.0) : glm::inverse(world);
  }

  const std::vector<glm::dmat4>& jointsOf(int skin) {
    auto& joints = joints_[static_cast<std::size_t>(skin)];
    if (!joints.empty()) return joints;
    const Skin& source = scene_.motion->skins[static_cast<std::size_t>(skin)];
    for (std::size_t i = 0; i < source.joints.size(); ++i) {
      const int node = source.joints[i];
      const glm::dmat4 world = node < 0 ? glm::dmat4(1.0) : scene_.nodes[static_cast<std::size_t>(node)].world;
      joints.push_back(world * glm::dmat4(source.inverseBindMatrices[i]));
    }
    return joints;
  }

  Scene& scene_;
  Warnings& warnings_;
  const CancelToken& cancel_;
  DrawnPoints points_;
  std::vector<std::vector<glm::dmat4>> joints_;  ///< by skin, made when first needed
};

}  // namespace

void place(Scene& scene, Warnings& warnings, const CancelToken& cancel) { Placer(scene, warnings, cancel).run(); }

void needGeometry(const Scene& scene) {
  if (scene.bounds.empty() || scene.bounds.min == scene.bounds.max) {
    throw Error("E_NO_GEOMETRY", "the scene has nothing to draw: no mesh of more than one point is left");
  }
}

}  // namespace telar::asset
