#include "reference/ray_camera.h"

#include <cmath>

#include "frame/camera.h"

namespace telar::reference {

RayCamera::RayCamera(const Shot& shot, const glm::dvec3& centre) : width_(shot.width), height_(shot.height) {
  const frame::Camera camera = frame::cameraOf(shot);
  glm::dmat4 view = camera.view;
  view[3] += camera.view * glm::dvec4(centre, 0.0);  // the tracer's world starts at the centre
  const glm::dmat4 toWorld = glm::inverse(camera.projection * view);
  const auto planeAt = [&](double depth) {
    const auto point = [&](double x, double y) {
      const glm::dvec4 p = toWorld * glm::dvec4(x, y, depth, 1);
      return glm::dvec3(p) / p.w;
    };
    const glm::dvec3 middle = point(0, 0);
    return Plane{middle, point(1, 0) - middle, point(0, 1) - middle};
  };
  near_ = planeAt(-1);
  far_ = planeAt(1);
  toView_ = glm::mat3(glm::dmat3(view));
  if (!shot.lens || !shot.lens->focusDistance || shot.camera.projection != Projection::kPerspective) return;
  const double focalLength = SENSOR_HEIGHT_M / 2 / std::tan(glm::radians(shot.camera.fovY) / 2);
  lens_ = Lens{focalLength / shot.lens->aperture / 2, *shot.lens->focusDistance, shot.camera.near,
               shot.camera.position - centre, glm::transpose(glm::dmat3(view))};
}

Ray RayCamera::generateRay(const glm::dvec2& pixel, const glm::dvec2& u) const {
  const glm::dvec2 ndc(2 * pixel.x / width_ - 1, 1 - 2 * pixel.y / height_);
  const glm::dvec3 near = near_.at(ndc), straight = glm::normalize(far_.at(ndc) - near);
  if (!lens_) return {glm::vec3(near), glm::vec3(straight)};
  const glm::dvec3 forward = -lens_->axes[2];
  const glm::dvec3 sharp = lens_->centre + straight * (lens_->focusDistance / glm::dot(straight, forward));
  const double radius = lens_->radius * std::sqrt(u.x), phi = 2 * 3.14159265358979323846 * u.y;
  const glm::dvec3 origin =
      lens_->centre + lens_->axes[0] * (radius * std::cos(phi)) + lens_->axes[1] * (radius * std::sin(phi));
  const glm::dvec3 direction = glm::normalize(sharp - origin);
  const double from = lens_->near / glm::dot(direction, forward);
  return {glm::vec3(origin + direction * from), glm::vec3(direction)};
}

Footprint RayCamera::footprint(const glm::dvec2& pixel, const glm::dvec2& u) const {
  return {generateRay(pixel + glm::dvec2(1, 0), u), generateRay(pixel - glm::dvec2(0, 1), u), toView_};
}

}  // namespace telar::reference
