#include "visibility/quad_varyings.h"

#include <algorithm>
#include <cmath>

namespace telar::visibility {

bool fusesProducts() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

glm::vec3 windowPlace(const float* clip, float overW, const glm::vec2& size, bool fused) {
  const auto place = [fused](float v, float scale) { return fused ? std::fma(v, scale, scale) : v * scale + scale; };
  return {place(clip[0] * overW, size.x * 0.5f), place(clip[1] * overW, size.y * 0.5f), place(clip[2] * overW, 0.5f)};
}

void VaryingMixer::setUp(Owner owner) {
  setUp_ = owner;
  const Corners corners = cornersOf(mesh_, numberOf(owner));
  // llvmpipe turns a triangle round whose corners run counter-clockwise.
  const Corners at = (owner & COUNTER_CLOCKWISE) != 0 ? Corners{corners[1], corners[0], corners[2]} : corners;
  const TriangleSetup setup(vertices_.vertices[at[0]], vertices_.vertices[at[1]], vertices_.vertices[at[2]], offset_);
  Lanes w[3];
  for (std::size_t i = 0; i < 3; ++i) w[i] = lanesOf(vertices_.overW[at[i]]);
  overW_ = setup.plane(w[0], w[1], w[2]);
  count_ = std::min((mesh_.outputs.varyings + 3) / 4 - layers_.first, layers_.count);
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t from = 4 + (layers_.first + i) * 4;
    const auto of = [&](std::size_t corner) { return load(mesh_.outputs.of(at[corner]) + from) * w[corner]; };
    planes_[i] = setup.plane(of(0), of(1), of(2));
  }
}

template <class Rounding>
[[gnu::always_inline]] inline void VaryingMixer::mixPixels(const ShadingQuad& quad, unsigned from, unsigned to,
                                                           const FragmentTexels& out, const glm::uvec2& at) const {
  for (unsigned pixel = from; pixel < to; ++pixel) {
    const unsigned right = pixel & 1, up = pixel >> 1;
    const Lanes x = lanesOf(static_cast<float>(quad.x + right) + centre_);
    const Lanes y = lanesOf(static_cast<float>(quad.y + up) + centre_);
    const Lanes w = lanesOf(1) / valueAt<Rounding>(overW_, x, y);
    for (std::size_t i = 0; i < count_; ++i)
      store(out.of({at.x + right, at.y + up}, i), valueAt<Rounding>(planes_[i], x, y) * w);
  }
}

TELAR_FUSED void VaryingMixer::mixFused(const ShadingQuad& quad, unsigned from, unsigned to, const FragmentTexels& out,
                                        const glm::uvec2& at) const {
  mixPixels<Fused>(quad, from, to, out, at);
}

void VaryingMixer::mix(const ShadingQuad& quad, const FragmentTexels& out, const glm::uvec2& at) {
  // The pixels of one triangle at once.
  for (unsigned from = 0, to = 0; from < 4; from = to) {
    while (to < 4 && quad.owners[to] == quad.owners[from]) ++to;
    if (setUp_ != quad.owners[from]) setUp(quad.owners[from]);
    fused_ ? mixFused(quad, from, to, out, at) : mixPixels<Apart>(quad, from, to, out, at);
  }
}

glm::vec2 VaryingSteps::of(const ShadingQuad& quad) {
  const FragmentTexels out{texels_.data(), WIDTH, LAYERS};
  mixer_.mix(quad, out, {0, 0});
  glm::vec2 steps{};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t component = first_ + i;
    const auto at = [&](unsigned x, unsigned y) { return out.of({x, y}, component / 4)[component % 4]; };
    const float across = std::min(std::abs(at(1, 0) - at(0, 0)), std::abs(at(1, 1) - at(0, 1)));
    const float up = std::min(std::abs(at(0, 1) - at(0, 0)), std::abs(at(1, 1) - at(1, 0)));
    steps[static_cast<int>(i)] = std::max(across, up);
  }
  return steps;
}

}  // namespace telar::visibility
