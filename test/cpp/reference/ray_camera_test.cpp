#include "reference/ray_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace telar::reference {
namespace {

Shot shotOf(double aperture, double focusDistance) {
  Shot shot;
  shot.width = 300, shot.height = 200;
  shot.camera.position = {101, 2, 4}, shot.camera.target = {100, 1, 0};
  shot.camera.fovY = 40, shot.camera.near = 0.2, shot.camera.far = 50;
  shot.lens = Shot::Lens{aperture, {}, {}, focusDistance};
  return shot;
}

TEST(RayCamera, RaysOfALensMeetWhereItFocuses) {
  const glm::dvec3 centre(100, 0, 0);
  const Shot shot = shotOf(1.4, 3);
  const RayCamera camera(shot, centre);
  const double focalLength = 0.012 / std::tan(glm::radians(20.0)), lensRadius = focalLength / 1.4 / 2;
  const glm::vec3 lens(shot.camera.position - centre);
  const glm::vec3 forward(glm::normalize(shot.camera.target - shot.camera.position));
  Random random(1, 0, 0);
  float widest = 0;
  for (int pixel = 0; pixel < 20; ++pixel) {
    const glm::dvec2 at = glm::dvec2(random.uniform2()) * glm::dvec2(shot.width, shot.height);
    const auto meets = [&](const Ray& ray, float along) {
      return ray.origin +
             ray.direction * ((along - glm::dot(ray.origin - lens, forward)) / glm::dot(ray.direction, forward));
    };
    const glm::vec3 sharp = meets(camera.generateRay(at, glm::dvec2(0)), 3);
    for (int i = 0; i < 50; ++i) {
      const Ray ray = camera.generateRay(at, glm::dvec2(random.uniform2()));
      EXPECT_NEAR(glm::length(ray.direction), 1, 1e-6);
      EXPECT_LT(glm::distance(meets(ray, 3), sharp), 1e-5);
      EXPECT_NEAR(glm::dot(ray.origin - lens, forward), 0.2, 1e-5) << "rays begin at the near plane";
      const float off = glm::distance(meets(ray, 0), lens);
      EXPECT_LT(off, lensRadius + 1e-5);
      widest = std::max(widest, off);
    }
  }
  EXPECT_GT(widest, 0.95 * lensRadius);
}

TEST(RayCamera, WithoutALensAllRaysOfAPointAreOne) {
  Shot shot = shotOf(1.4, 3);
  shot.lens.reset();
  const RayCamera camera(shot, glm::dvec3(0));
  EXPECT_EQ(camera.generateRay({3, 4}, {0.1, 0.2}).direction, camera.generateRay({3, 4}, {0.7, 0.9}).direction);
  EXPECT_FALSE(camera.hasLens());
}

}  // namespace
}  // namespace telar::reference
