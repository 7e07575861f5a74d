#include "reference/tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "ibl/dfg_lookup.h"
#include "pass/camera.h"
#include "pass/linear_output.h"
#include "pass/variant.h"

namespace telar::reference {
namespace {

/// Rays through the picture, in the tracer's world.
class Eye {
 public:
  Eye(const Shot& shot, const glm::dvec3& centre) : width_(shot.width), height_(shot.height) {
    const pass::Camera camera = pass::cameraOf(shot);
    glm::dmat4 view = camera.view;
    view[3] += camera.view * glm::dvec4(centre, 0.0);  // the tracer's world starts at the centre
    toWorld_ = glm::inverse(camera.projection * view);
    toView_ = glm::mat3(glm::dmat3(view));
  }
  /// @param x, y  pixels from the top-left corner, y down
  Ray ray(double x, double y) const {
    const glm::dvec2 ndc(2 * x / width_ - 1, 1 - 2 * y / height_);
    const glm::dvec3 near = point(ndc, -1), far = point(ndc, 1);
    return {glm::vec3(near), glm::vec3(glm::normalize(far - near))};
  }
  const glm::mat3& toView() const { return toView_; }

 private:
  glm::dvec3 point(const glm::dvec2& ndc, double depth) const {
    const glm::dvec4 p = toWorld_ * glm::dvec4(ndc, depth, 1);
    return glm::dvec3(p) / p.w;
  }
  int width_, height_;
  glm::dmat4 toWorld_{1.0};
  glm::mat3 toView_{1.0f};
};

/// Runs rows on several threads until all are done or one fails.
void forEachRow(int rows, int threads, const std::function<void(int)>& job) {
  std::atomic<int> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (int row = next++; row < rows; row = next++) job(row);
    } catch (...) {
      next = rows;  // the others stop after their row
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::jthread> pool;
  for (int i = 1; i < threads; ++i) pool.emplace_back(work);
  work();
  pool.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

std::vector<glm::vec4> traceRadiance(const Scene& scene, const Shot& shot, const ImageF* environment,
                                     const TraceOptions& options, const Limits& limits, const CancelToken& cancel,
                                     const std::function<void(double)>& progress) {
  const glm::dvec3 centre = scene.bounds.empty() ? glm::dvec3(0) : (scene.bounds.min + scene.bounds.max) * 0.5;
  const auto radius = scene.bounds.empty() ? 1.0f : static_cast<float>(glm::distance(scene.bounds.max, centre));
  const std::vector<PlacedMesh> meshes = placeMeshes(scene, pass::variantIndex(scene, shot.variant), centre);
  const Geometry geometry(meshes);
  const Lights lights = lightsOf(scene, shot, centre, limits);
  std::optional<EnvironmentLight> around;
  if (environment && shot.environment.intensity > 0) {
    around.emplace(*environment, shot.environment.rotation, shot.environment.intensity);
  }
  const bool skyShown = around && shot.background.type == Shot::Background::Type::kEnvironment;
  const Integrator integrator(scene, meshes, geometry, lights, around ? &*around : nullptr, radius, options.transport,
                              shot.shading, ibl::dfgLookup);
  const Eye eye(shot, centre);
  const int width = shot.width, height = shot.height;
  std::vector<glm::vec4> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::atomic<int> done = 0;
  forEachRow(height, std::max(options.threads, 1), [&](int y) {
    for (int x = 0; x < width; ++x) {
      cancel.check();
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      glm::dvec4 sum(0);
      for (int i = 0; i < options.samples; ++i) {
        Random random(options.seed, static_cast<std::uint32_t>(pixel), static_cast<std::uint32_t>(i));
        const glm::dvec2 at = glm::dvec2(x, y) + glm::dvec2(random.uniform2());
        const Ray ray = eye.ray(at.x, at.y);
        const Footprint footprint{eye.ray(at.x + 1, at.y), eye.ray(at.x, at.y - 1), eye.toView()};
        glm::vec4 light = integrator.radiance(ray, footprint, random);
        if (skyShown && light.a == 0) light = glm::vec4(around->radiance(ray.direction), 1.0f);
        sum += glm::dvec4(light);
      }
      pixels[pixel] = glm::vec4(sum / static_cast<double>(options.samples));
    }
    if (progress) progress(static_cast<double>(++done) / height);
  });
  return pixels;
}

Frame trace(const Scene& scene, const Shot& shot, const ImageF* environment, const TraceOptions& options,
            const Limits& limits, const CancelToken& cancel, const std::function<void(double)>& progress) {
  return pass::toFrame(traceRadiance(scene, shot, environment, options, limits, cancel, progress), shot);
}

}  // namespace telar::reference
