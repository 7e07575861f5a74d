#include "visibility/quad_varyings.h"

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

void VaryingMixer::begin(const VertexOutputs& outputs, const WindowVertices& vertices, const Corners& corners,
                         bool counterClockwise) {
  // llvmpipe turns a triangle round whose corners run counter-clockwise.
  const Corners at = counterClockwise ? Corners{corners[1], corners[0], corners[2]} : corners;
  const TriangleSetup setup(vertices.vertices[at[0]], vertices.vertices[at[1]], vertices.vertices[at[2]]);
  Lanes w[3];
  for (std::size_t i = 0; i < 3; ++i) w[i] = lanesOf(vertices.overW[at[i]]);
  overW_ = setup.plane(w[0], w[1], w[2]);
  count_ = (outputs.varyings + 3) / 4;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto of = [&](std::size_t corner) { return load(outputs.of(at[corner]) + 4 + i * 4) * w[corner]; };
    planes_[i] = setup.plane(of(0), of(1), of(2));
  }
}

template <class Rounding>
[[gnu::always_inline]] inline void VaryingMixer::mixAs(const ShadingQuad& quad, const FragmentTexels& out,
                                                       const glm::uvec2& at) const {
  for (unsigned pixel = 0; pixel < 4; ++pixel) {
    const unsigned right = pixel & 1, up = pixel >> 1;
    const Lanes x = lanesOf(static_cast<float>(quad.x + right) + 0.5f);
    const Lanes y = lanesOf(static_cast<float>(quad.y + up) + 0.5f);
    const Lanes w = lanesOf(1) / valueAt<Rounding>(overW_, x, y);
    for (std::size_t i = 0; i < count_; ++i)
      store(out.of({at.x + right, at.y + up}, i), valueAt<Rounding>(planes_[i], x, y) * w);
  }
}

TELAR_FUSED void VaryingMixer::mixFused(const ShadingQuad& quad, const FragmentTexels& out,
                                        const glm::uvec2& at) const {
  mixAs<Fused>(quad, out, at);
}

void VaryingMixer::mix(const ShadingQuad& quad, const FragmentTexels& out, const glm::uvec2& at) const {
  fused_ ? mixFused(quad, out, at) : mixAs<Apart>(quad, out, at);
}

}  // namespace telar::visibility
