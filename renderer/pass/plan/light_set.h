#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "frame/camera.h"
#include "pass/plan/light_choice.h"
#include "shader/variant_key.h"
#include "telar/scene.h"

namespace telar::gl {
class Program;
}

namespace telar::pass {

/// The lights of a frame as the shader takes them: view space, colour times intensity, linear Rec.709.
struct LightSet {
  glm::vec3 ambient{0};
  bool hasAmbient = false;
  std::vector<glm::vec3> hemisphereUp, hemisphereSky, hemisphereGround;
  std::vector<glm::vec3> pointPosition, pointColor;
  std::vector<float> pointRange;
  std::vector<glm::vec3> spotPosition, spotDirection, spotColor;
  std::vector<float> spotRange, spotOuterCos, spotInnerCos;
  std::vector<glm::vec3> directionalDirection, directionalColor;
  std::size_t suns = 0;  ///< of the directional ones, the last: small lights of the environment
  std::vector<glm::vec3> rectPosition, rectHalfWidth, rectHalfHeight, rectColor;
  std::vector<glm::vec3> diskPosition, diskX, diskY, diskColor;

  std::size_t given = 0;    ///< lights of shot and model
  std::size_t leftOut = 0;  ///< of them: black ones, and those that reach nothing

  /// Writes the light counts into a key.
  void describe(shader::VariantKey& key) const;
  /// Adds black lights up to `count` of each kind (all-features benchmark).
  void pad(std::size_t count);
  void upload(const gl::Program& program) const;
};

/// The shot's lights, then the model's (KHR_lights_punctual), those that are chosen and light surfaces.
LightSet collectLights(const Scene& scene, const Shot& shot, const LightChoice& chosen, const frame::Camera& camera);

}  // namespace telar::pass
