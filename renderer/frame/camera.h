#pragma once
#include <glm/glm.hpp>

#include "telar/shot.h"

namespace telar::frame {

/// Matrices of one view, in double; uploaded as float after they are multiplied with a node's.
struct Camera {
  glm::dmat4 view{1.0};        ///< world to view
  glm::dmat4 projection{1.0};  ///< view to clip, OpenGL depth -1..1
  bool orthographic = false;
};

/// Unit axes (columns x, y, z) of something at `position` whose -z looks at `target`, as three.js's Matrix4.lookAt
/// chooses them: also where `up` and the direction are parallel, or both points are one.
glm::dmat3 lookAtAxes(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up);

/// World to the space of a camera that stands so.
glm::dmat4 lookAtView(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up);

Camera cameraOf(const Shot& shot);

/// World (homogeneous) to pixels: x right and y down from the top-left corner, z 0..1 from near to far, after / w.
glm::dmat4 worldToPixel(const Camera& camera, int width, int height);

/// Reading matrix of an environment turned by `degrees` about +Y: scene.environmentRotation.y of three.js, transposed.
glm::mat3 environmentRotation(double degrees);

}  // namespace telar::frame
