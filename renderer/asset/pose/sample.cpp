#include "asset/pose/sample.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace telar::asset {
namespace {

constexpr double NEARLY_PARALLEL = 0.9995;  // three.js's: a smaller arc is interpolated as a line

/// Spherical interpolation; quaternions are used as they are, of whatever length.
/// src: Shoemake 1985, "Animating Rotation with Quaternion Curves"; cases and order of three r187
/// (Quaternion.slerpFlat)
glm::dvec4 slerp(const glm::dvec4& from, glm::dvec4 to, double t) {
  if (from == to) return from;
  double cosine = glm::dot(from, to);
  if (cosine < 0) to = -to, cosine = -cosine;
  if (cosine >= NEARLY_PARALLEL) return glm::normalize(from * (1 - t) + to * t);
  const double angle = std::acos(cosine), sine = std::sin(angle);
  return from * (std::sin((1 - t) * angle) / sine) + to * (std::sin(t * angle) / sine);
}

/// Numbers of the keyframe itself; with a spline, those between its tangents.
const float* keyOf(const AnimationSampler& sampler, std::size_t key) {
  const bool spline = sampler.interpolation == Interpolation::kCubicSpline;
  return sampler.values.data() + (spline ? key * 3 + 1 : key) * sampler.width;
}

/// src: glTF 2.0 specification, appendix C "Animation Sampler Interpolation Modes"
std::vector<double> cubicSpline(const AnimationSampler& sampler, std::size_t key, double time) {
  const std::size_t width = sampler.width;
  const double start = sampler.times[key], length = sampler.times[key + 1] - start;
  const double p = (time - start) / length, pp = p * p, ppp = pp * p;
  const double toEnd = -2 * ppp + 3 * pp, inTangent = ppp - pp, toStart = 1 - toEnd, outTangent = inTangent - pp + p;
  const float* before = keyOf(sampler, key);
  const float* after = keyOf(sampler, key + 1);
  std::vector<double> out(width);
  for (std::size_t i = 0; i < width; ++i) {
    out[i] = toStart * before[i] + outTangent * (before[i + width] * length) + toEnd * after[i] +
             inTangent * (*(after + i - width) * length);
  }
  return out;
}

std::vector<double> linear(const AnimationSampler& sampler, std::size_t key, double time) {
  const double start = sampler.times[key], t = (time - start) / (sampler.times[key + 1] - start);
  const float* before = keyOf(sampler, key);
  const float* after = keyOf(sampler, key + 1);
  std::vector<double> out(sampler.width);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = before[i] * (1 - t) + after[i] * t;
  return out;
}

glm::dvec4 quaternionAt(const float* values) { return {values[0], values[1], values[2], values[3]}; }
std::vector<double> listOf(const glm::dvec4& q) { return {q.x, q.y, q.z, q.w}; }

std::vector<double> turned(const AnimationSampler& sampler, std::size_t key, double time) {
  if (sampler.interpolation == Interpolation::kCubicSpline) {
    const auto raw = cubicSpline(sampler, key, time);
    const glm::dvec4 q(raw[0], raw[1], raw[2], raw[3]);
    const double length = glm::length(q);
    return length == 0 ? std::vector<double>{0, 0, 0, 1} : listOf(q * (1 / length));
  }
  const double start = sampler.times[key], t = (time - start) / (sampler.times[key + 1] - start);
  return listOf(slerp(quaternionAt(keyOf(sampler, key)), quaternionAt(keyOf(sampler, key + 1)), t));
}

}  // namespace

std::vector<double> sample(const AnimationSampler& sampler, AnimationPath path, double time) {
  const auto next = std::upper_bound(sampler.times.begin(), sampler.times.end(), time);
  const auto after = static_cast<std::size_t>(next - sampler.times.begin());
  const std::size_t key = after == 0 ? 0 : after - 1;
  if (after == 0 || after == sampler.times.size() || sampler.interpolation == Interpolation::kStep) {
    const float* held = keyOf(sampler, key);
    return std::vector<double>(held, held + sampler.width);
  }
  if (path == AnimationPath::kRotation) return turned(sampler, key, time);
  return sampler.interpolation == Interpolation::kCubicSpline ? cubicSpline(sampler, key, time)
                                                              : linear(sampler, key, time);
}

}  // namespace telar::asset
