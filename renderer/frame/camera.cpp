#include "frame/camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace telar::frame {

glm::dmat3 lookAtAxes(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up) {
  glm::dvec3 z = position - target;
  z = glm::dot(z, z) > 0 ? glm::normalize(z) : glm::dvec3(0, 0, 1);
  glm::dvec3 x = glm::cross(up, z);
  if (glm::dot(x, x) == 0) {
    if (std::abs(up.z) == 1) {
      z.x += 0.0001;
    } else {
      z.z += 0.0001;
    }
    z = glm::normalize(z);
    x = glm::cross(up, z);
  }
  x = glm::normalize(x);
  return {x, glm::cross(z, x), z};
}

glm::dmat4 lookAtView(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up) {
  return glm::translate(glm::dmat4(glm::transpose(lookAtAxes(position, target, up))), -position);
}

Camera cameraOf(const Shot& shot) {
  const double aspect = static_cast<double>(shot.width) / shot.height;
  const Shot::Camera& c = shot.camera;
  Camera camera;
  camera.view = lookAtView(c.position, c.target, c.up);
  camera.orthographic = c.projection == Projection::kOrthographic;
  if (!camera.orthographic) {
    camera.projection = glm::perspective(glm::radians(c.fovY), aspect, c.near, c.far);
  } else {
    const double top = c.height / 2, right = top * aspect;
    camera.projection = glm::ortho(-right, right, -top, top, c.near, c.far);
  }
  return camera;
}

glm::dmat4 worldToPixel(const Camera& camera, int width, int height) {
  const glm::dmat4 toPixels(width / 2.0, 0, 0, 0, 0, -height / 2.0, 0, 0, 0, 0, 0.5, 0, width / 2.0, height / 2.0, 0.5,
                            1);
  return toPixels * camera.projection * camera.view;
}

glm::mat3 environmentRotation(double degrees) {
  return glm::transpose(
      glm::mat3(glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::dvec3(0, 1, 0)))));
}

}  // namespace telar::frame
