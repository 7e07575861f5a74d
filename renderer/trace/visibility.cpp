#include "telar/visibility.h"

#include <algorithm>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "core/disk_cache.h"
#include "telar/shot.h"
#include "trace/library.h"
#include "trace/visibility_cache.h"

namespace telar {
namespace {

using trace::FoundVisibility;
using Sides = VisibilityJob::Sides;

/// Before any ray and any byte.
/// @return bytes that the streams add, here and on the GPU
std::uint64_t checkWork(const Scene& scene, int rays, const Limits& limits) {
  std::map<const Primitive*, std::size_t> places;
  double cast = 0;
  std::uint64_t bytes = 0;
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    const std::size_t drawn = node.places();
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      if (primitive.topology != Topology::kTriangles) continue;
      std::size_t& known = places[&primitive];
      const std::size_t more = std::min<std::size_t>(drawn, VISIBILITY_PLACES - known);
      cast += 2.0 * rays * static_cast<double>(primitive.positions.size()) * static_cast<double>(more);
      // The file's mesh and a deformed copy of it each have both sides, here and on the GPU.
      if (known == 0) bytes += 2 * 2 * 2 * sizeof(glm::vec4) * primitive.positions.size();
      known += more;
    }
  }
  checkLimit("L_VISIBILITY_RAYS", static_cast<double>(limits.visibilityRays), cast);
  checkSum("L_MEMORY_BYTES", static_cast<double>(limits.memoryBytes),
           static_cast<double>(scene.memoryBytes) + static_cast<double>(bytes));
  return bytes;
}

/// Means over what stands for one primitive of the file: its deformed copies.
FoundVisibility byFile(const Scene& scene, const std::map<const Primitive*, Sides>& found) {
  FoundVisibility out;
  std::map<FoundVisibility::key_type, float> counts;
  std::vector<bool> met(scene.meshes.size(), false);
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0 || met[static_cast<std::size_t>(node.mesh)]) continue;
    met[static_cast<std::size_t>(node.mesh)] = true;
    const auto& primitives = scene.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto at = found.find(&primitives[i]);
      if (at == found.end()) continue;
      const FoundVisibility::key_type place(node.file.mesh, i);
      const float before = counts[place]++;
      Sides& sides = out[place];
      for (std::size_t side = 0; side < sides.size(); ++side) {
        sides[side].resize(at->second[side].size(), glm::vec4(0));
        for (std::size_t v = 0; v < sides[side].size(); ++v)
          sides[side][v] = (sides[side][v] * before + at->second[side][v]) / (before + 1);
      }
    }
  }
  return out;
}

FoundVisibility byRays(const Scene& model, int rays, const CancelToken& cancel) {
  const trace::Library library;
  Shot shot;
  shot.shading = ShadingModel::kFabric;
  const int threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  VisibilityJob job{model, shot, rays, threads, cancel};
  library.function<TelarReferenceVisibilityFunction>("telar_reference_visibility")(&job);
  if (job.failure) trace::throwFailure(*job.failure);
  return byFile(model, job.sides);
}

/// What another job has found of the same file, or else by rays.
FoundVisibility find(const Scene& model, int rays, const VisibilityCache& cache, const CancelToken& cancel) {
  const DiskCache disk(cache.directory, cache.bytes);
  if (!disk.enabled()) return byRays(model, rays, cancel);
  constexpr auto KIND = DiskCache::Kind::kVisibility;
  const std::string key = trace::visibilityKey(model, rays, cache.version);
  if (const auto file = disk.read(KIND, key)) {
    if (auto kept = trace::unpackVisibility(*file, key)) return std::move(*kept);
  }
  FoundVisibility found = byRays(model, rays, cancel);
  disk.write(KIND, key, trace::packVisibility(found, key));
  return found;
}

}  // namespace

std::shared_ptr<const Scene> withAmbientVisibility(const std::shared_ptr<const Scene>& model, int rays,
                                                   const VisibilityCache& cache, const Limits& limits,
                                                   const CancelToken& cancel) {
  try {
    const std::uint64_t bytes = checkWork(*model, rays, limits);
    const FoundVisibility found = find(*model, rays, cache, cancel);

    auto out = std::make_shared<Scene>(*model);
    out->memoryBytes += bytes;
    std::vector<int> fileMeshes(out->meshes.size());  // by mesh of the scene
    for (std::size_t i = 0; i < fileMeshes.size(); ++i) fileMeshes[i] = static_cast<int>(i);
    for (const Node& node : out->nodes) {
      if (node.mesh >= 0) fileMeshes[static_cast<std::size_t>(node.mesh)] = node.file.mesh;
    }
    for (std::size_t mesh = 0; mesh < out->meshes.size(); ++mesh) {
      cancel.check();
      std::vector<Primitive> primitives(out->meshes[mesh].primitives.begin(), out->meshes[mesh].primitives.end());
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        const auto sides = found.find({fileMeshes[mesh], i});
        if (sides == found.end() || sides->second[0].size() != primitives[i].positions.size()) continue;
        primitives[i].visibility = sides->second;
      }
      out->meshes[mesh].primitives = std::move(primitives);
    }
    return out;
  } catch (const std::bad_alloc&) {
    throw Error("X_MEMORY", "there is not enough memory for the ambient visibility of the model");
  }
}

}  // namespace telar
