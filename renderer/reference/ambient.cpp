#include "reference/ambient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "brdf/shading.h"
#include "core/on_threads.h"

namespace telar::reference {
namespace {

constexpr int BATCH = 64;               ///< rays that are drawn at once
constexpr std::size_t ROW = 256;        ///< points that a thread takes at once
constexpr std::uint64_t SEED = 0x616f;  ///< of points that no shot of the reference gives one

/// By the cosine: even over the disk beneath the hemisphere (Malley's method).
glm::vec3 cosineDirection(const glm::vec2& u) {
  const float r = std::sqrt(u.x), phi = glm::two_pi<float>() * u.y;
  return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1 - u.x, 0.0f))};
}

}  // namespace

float openPart(const Geometry& geometry, Rays from, const glm::vec3& normal, const Random& sample, int count) {
  const glm::mat3 frame = brdf_f::basisAbout(normal);
  std::array<glm::vec3, BATCH> directions;
  int hidden = 0;
  for (int first = 0; first < count; first += BATCH) {
    const int now = std::min(count - first, BATCH);
    for (int i = 0; i < now; ++i) {
      Random random = sample.after(first + i);
      directions[static_cast<std::size_t>(i)] = frame * cosineDirection(random.uniform2());
    }
    from.directions = std::span(directions).first(static_cast<std::size_t>(now));
    hidden += geometry.countHidden(from);
  }
  return 1 - static_cast<float>(hidden) / static_cast<float>(count);
}

void findAmbient(AmbientJob& job) {
  const PlacedScene placed(job.scene, job.shot, job.cancel);
  job.open.resize(job.points.size());
  const std::size_t rows = (job.points.size() + ROW - 1) / ROW;
  onThreads(rows, static_cast<std::size_t>(std::max(job.threads, 1)), [&](std::size_t row) {
    job.cancel.check();
    const std::size_t first = row * ROW;
    for (std::size_t i = first; i < std::min(first + ROW, job.points.size()); ++i) {
      const SurfacePoint& point = job.points[i];
      const Rays from = placed.raysFrom(glm::vec3(point.position - placed.centre), point.normal, point.toViewer);
      job.open[i] =
          openPart(placed.geometry, from, point.normal, Random(SEED, 0, point.firstRay), static_cast<int>(point.rays));
    }
  });
}

}  // namespace telar::reference
