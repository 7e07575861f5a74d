#include "reference/sampling.h"

#include <algorithm>
#include <cmath>

namespace telar::reference {
namespace {

constexpr float PI = 3.14159265f;

}  // namespace

glm::mat3 basisAbout(const glm::vec3& n) {
  const float side = std::copysign(1.0f, n.z), a = -1.0f / (side + n.z), b = n.x * n.y * a;
  return {glm::vec3(1.0f + side * n.x * n.x * a, side * b, -side * n.x), glm::vec3(b, side + n.y * n.y * a, -n.y), n};
}

glm::vec3 sampleCosine(const glm::vec2& u) {
  const float radius = std::sqrt(u.x), phi = 2 * PI * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(std::max(0.0f, 1.0f - u.x))};
}

float pdfCosine(float cosine) { return std::max(cosine, 0.0f) / PI; }

glm::vec3 sampleSphere(const glm::vec2& u) {
  const float z = 1.0f - 2.0f * u.x, radius = std::sqrt(std::max(0.0f, 1.0f - z * z)), phi = 2 * PI * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

glm::vec3 sampleVisibleNormal(const glm::vec3& v, const glm::vec2& alpha, const glm::vec2& u) {
  const glm::vec3 stretched = glm::normalize(glm::vec3(alpha.x * v.x, alpha.y * v.y, v.z));
  // A point of the cap of the sphere that is seen from `stretched`.
  const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
  const float radius = std::sqrt(std::clamp(1.0f - z * z, 0.0f, 1.0f)), phi = 2 * PI * u.x;
  const glm::vec3 h = glm::vec3(radius * std::cos(phi), radius * std::sin(phi), z) + stretched;
  return glm::normalize(glm::vec3(alpha.x * h.x, alpha.y * h.y, std::max(h.z, 1e-9f)));
}

float pdfReflection(const glm::vec3& v, const glm::vec3& l, const glm::vec2& alpha) {
  const glm::vec3 sum = v + l;
  const float length2 = glm::dot(sum, sum);
  if (v.z <= 0 || length2 < 1e-12f) return 0;
  const glm::vec3 h = sum / std::sqrt(length2);
  if (h.z <= 0) return 0;
  const glm::vec3 wide(h.x / alpha.x, h.y / alpha.y, h.z);
  const float k = glm::dot(wide, wide);
  const float distribution = 1.0f / (PI * alpha.x * alpha.y * k * k);
  const glm::vec3 seen(alpha.x * v.x, alpha.y * v.y, v.z);
  return distribution / (2.0f * (v.z + glm::length(seen)));
}

}  // namespace telar::reference
