#include "reference/geometry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "frame/release_material.h"
#include "frame/variant.h"

namespace telar::reference {
namespace {

std::vector<glm::uvec3> trianglesOf(const Primitive& primitive) {
  const bool indexed = !primitive.indices.empty();
  const std::size_t count = (indexed ? primitive.indices.size() : primitive.positions.size()) / 3;
  std::vector<glm::uvec3> triangles(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = 3 * i + static_cast<std::size_t>(k);
      triangles[i][k] = indexed ? primitive.indices[at] : static_cast<std::uint32_t>(at);
    }
  }
  return triangles;
}

/// Cofactors: the inverse transpose but for its length, and finite where a node is flattened. They are brought to about 1, as squares
/// of scales leave the range of floats; by a power of two, which rounds nothing.
glm::mat3 normalMatrixOf(const glm::dmat3& linear) {
  const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                             glm::cross(linear[0], linear[1]));
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(cofactors[i][k]));
  }
  if (!(largest > 0) || !std::isfinite(largest)) return glm::mat3(cofactors);
  return glm::mat3(cofactors / std::ldexp(1.0, std::ilogb(largest)));
}

PlacedMesh place(const glm::dmat4& world, const Primitive& primitive, const Material& material,
                 const glm::dvec3& centre) {
  PlacedMesh mesh{&primitive, &material};
  const glm::dmat3 linear(world);
  const glm::dvec3 move = glm::dvec3(world[3]) - centre;
  mesh.positions.reserve(primitive.positions.size());
  for (const glm::vec3& p : primitive.positions) mesh.positions.emplace_back(linear * glm::dvec3(p) + move);
  mesh.triangles = trianglesOf(primitive);
  mesh.linear = glm::mat3(linear);
  mesh.mirrored = glm::determinant(linear) < 0;
  mesh.normalMatrix = normalMatrixOf(linear) * (mesh.mirrored ? -1.0f : 1.0f);
  return mesh;
}

/// Once where the node is, or at each of its instances.
void placeInstances(std::vector<PlacedMesh>& meshes, const Node& node, const Primitive& primitive,
                    const Material& material, const glm::dvec3& centre) {
  if (!node.instances) {
    meshes.push_back(place(node.world, primitive, material, centre));
    return;
  }
  const Instances& instances = *node.instances;
  for (std::size_t i = 0; i < instances.matrices.size(); ++i) {
    meshes.push_back(place(node.world * glm::dmat4(instances.matrices[i]), primitive, material, centre));
    if (!instances.colors.empty()) meshes.back().tint = instances.colors[i];
  }
}

/// Whether any ray ends at any triangle of a mesh.
bool blocksAlways(const PlacedMesh& mesh) {
  return mesh.material->doubleSided && mesh.material->alphaMode == AlphaMode::kOpaque;
}

/// What Embree hands to keepBlockers().
struct ShellContext {
  RTCIntersectContext embree{};
  float shells = 0;
};

/// As Embree takes it. @param far  metres that it goes
RTCRay rayOf(const Ray& ray, float far) {
  RTCRay query = {};
  query.org_x = ray.origin.x, query.org_y = ray.origin.y, query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x, query.dir_y = ray.direction.y, query.dir_z = ray.direction.z;
  query.tnear = ray.from;
  query.tfar = far;
  query.mask = ~0u;
  return query;
}

Hit hitOf(const RTCHit& hit, float distance) {
  return {hit.geomID, hit.primID, {hit.u, hit.v}, distance, {hit.Ng_x, hit.Ng_y, hit.Ng_z}};
}

constexpr std::size_t PACKET = 16;  ///< rays at once: as wide as the widest registers

}  // namespace

std::vector<PlacedMesh> placeMeshes(const Scene& scene, int variant, const glm::dvec3& centre,
                                    const CancelToken& cancel, ShadingModel shading, const ThreeTerms& three,
                                    frame::Ghosts ghosts) {
  std::vector<PlacedMesh> meshes;
  frame::ReleaseMaterials materials;
  for (const Node& node : scene.nodes) {
    cancel.check();
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (primitive.topology != Topology::kTriangles || primitive.positions.empty()) continue;
      const std::size_t first = meshes.size();
      const int index = materialIndex(node, primitive, variant);
      const float opacity = ghosts.opacity(node, materialIndex(primitive, variant));
      if (opacity == 0) continue;
      const Material& material = frame::materialAt(scene, index, shading);
      placeInstances(meshes, node, primitive, material, centre);
      for (std::size_t i = first; i < meshes.size(); ++i) meshes[i].node = &node, meshes[i].materialIndex = index;
      auto read = materials.of(material, primitive, three);
      if (opacity < 1) read = ghosts.of(read ? *read : material, opacity);
      if (!read) continue;
      for (std::size_t i = first; i < meshes.size(); ++i) {
        meshes[i].material = read.get();
        meshes[i].read = read;
        if (three.instanceColor == ThreeTerms::THREE_INSTANCE_COLOR_NONE) meshes[i].tint = glm::vec3(1.0f);
      }
    }
  }
  for (PlacedMesh& mesh : meshes) mesh.shading = shading;
  return meshes;
}

Geometry::Geometry(const std::vector<PlacedMesh>& meshes, const CancelToken& cancel, Blocks blocks)
    : blocks_(blocks ? std::make_unique<const Blocks>(std::move(blocks)) : nullptr) {
  // Embree builds with one thread, so that the hierarchy does not depend on the number of threads.
  device_.reset(rtcNewDevice("threads=1"));
  if (!device_) throw Error("X_REFERENCE", "Embree does not start on this machine");
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    cancel.check();
    const PlacedMesh& mesh = meshes[i];
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                              mesh.positions.size());
    void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                                              mesh.triangles.size());
    if (positions && triangles) {
      std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<glm::vec3*>(positions));
      std::copy(mesh.triangles.begin(), mesh.triangles.end(), static_cast<glm::uvec3*>(triangles));
      if (blocks_ && !blocksAlways(mesh)) {
        rtcSetGeometryUserData(geometry, const_cast<Blocks*>(blocks_.get()));
        rtcSetGeometryOccludedFilterFunction(geometry, keepBlockers);
      }
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(scene_.get(), geometry, static_cast<unsigned>(i));
    }
    rtcReleaseGeometry(geometry);
  }
  // Large models take seconds to build: Embree asks meanwhile whether to go on.
  rtcSetSceneProgressMonitorFunction(
      scene_.get(), [](void* user, double) { return !static_cast<const CancelToken*>(user)->isOver(); },
      const_cast<CancelToken*>(&cancel));
  rtcCommitScene(scene_.get());
  rtcSetSceneProgressMonitorFunction(scene_.get(), nullptr, nullptr);
  cancel.check();
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_OUT_OF_MEMORY)
    throw Error("X_MEMORY", "not enough memory for the tracer's hierarchy of triangles");
  if (error != RTC_ERROR_NONE)
    throw Error("X_REFERENCE", "Embree could not build its hierarchy: error " + std::to_string(error));
}

bool Geometry::intersect(const Ray& ray, Hit& hit) const {
  RTCRayHit query = {};
  query.ray = rayOf(ray, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = hitOf(query.hit, query.ray.tfar);
  return true;
}

void Geometry::intersect(std::span<const Ray> rays, std::span<std::optional<Hit>> hits) const {
  assert(rays.size() <= MAX_COHERENT);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit8 packet = {};
  alignas(32) std::array<int, MAX_COHERENT> valid{};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray& ray = rays[i];
    valid[i] = -1;
    packet.ray.org_x[i] = ray.origin.x, packet.ray.org_y[i] = ray.origin.y, packet.ray.org_z[i] = ray.origin.z;
    packet.ray.dir_x[i] = ray.direction.x, packet.ray.dir_y[i] = ray.direction.y, packet.ray.dir_z[i] = ray.direction.z;
    packet.ray.tnear[i] = ray.from;
    packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
    packet.ray.mask[i] = ~0u;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect8(valid.data(), scene_.get(), &context, &packet);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RTCHit hit =
        rtcGetHitFromHitN(reinterpret_cast<RTCHitN*>(&packet.hit), MAX_COHERENT, static_cast<unsigned>(i));
    hits[i].reset();
    if (hit.geomID != RTC_INVALID_GEOMETRY_ID) hits[i] = hitOf(hit, packet.ray.tfar[i]);
  }
}

bool Geometry::occluded(const Ray& ray, float far) const {
  RTCRay query = rayOf(ray, far);
  ShellContext context;
  rtcInitIntersectContext(&context.embree);
  rtcOccluded1(scene_.get(), &context.embree, &query);
  return query.tfar < 0;  // Embree's mark of a ray that met something
}

void Geometry::keepBlockers(const RTCFilterFunctionNArguments* met) {
  const Blocks& blocks = *static_cast<const Blocks*>(met->geometryUserPtr);
  const float shells = reinterpret_cast<const ShellContext*>(met->context)->shells;
  for (unsigned i = 0; i < met->N; ++i) {
    if (met->valid[i] == 0) continue;
    const RTCHit hit = rtcGetHitFromHitN(met->hit, met->N, i);
    const RTCRay ray = rtcGetRayFromRayN(met->ray, met->N, i);
    if (!blocks(hitOf(hit, ray.tfar), {ray.dir_x, ray.dir_y, ray.dir_z}, shells)) met->valid[i] = 0;
  }
}

template <class Found>
void Geometry::castShadows(const Rays& rays, const Found& found) const {
  ShellContext context;
  rtcInitIntersectContext(&context.embree);
  context.shells = rays.shells;
  for (std::size_t first = 0; first < rays.directions.size(); first += PACKET) {
    const std::size_t count = std::min(rays.directions.size() - first, PACKET);
    RTCRay16 packet = {};
    alignas(64) std::array<int, PACKET> valid{};
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec3& direction = rays.directions[first + i];
      valid[i] = -1;
      packet.org_x[i] = rays.origin.x, packet.org_y[i] = rays.origin.y, packet.org_z[i] = rays.origin.z;
      packet.dir_x[i] = direction.x, packet.dir_y[i] = direction.y, packet.dir_z[i] = direction.z;
      packet.tfar[i] = rays.far;
      packet.mask[i] = ~0u;
    }
    rtcOccluded16(valid.data(), scene_.get(), &context.embree, &packet);
    // Embree marks a ray that met something by a length of minus infinity.
    for (std::size_t i = 0; i < count; ++i) found(first + i, packet.tfar[i] < 0);
  }
}

int Geometry::countHidden(const Rays& rays) const {
  int hidden = 0;
  castShadows(rays, [&hidden](std::size_t, bool ended) { hidden += ended; });
  return hidden;
}

void Geometry::findHidden(const Rays& rays, std::span<bool> hidden) const {
  castShadows(rays, [hidden](std::size_t i, bool ended) { hidden[i] = ended; });
}

}  // namespace telar::reference
