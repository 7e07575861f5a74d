#include "visibility/quad_varyings.h"

#include <cmath>

#if defined(__x86_64__)
#include <immintrin.h>
#define TELAR_FUSED __attribute__((target("fma")))
#else
#define TELAR_FUSED
#endif

namespace telar::visibility {
namespace {

// LLVM fuses a product and a sum where the processor can, and so does this.
struct Apart {
  static Lanes sum(Lanes a, Lanes b, Lanes c) { return a * b + c; }
};
struct Fused {
  TELAR_FUSED static Lanes sum(Lanes a, Lanes b, Lanes c) {
#if defined(__x86_64__)
    return _mm_fmadd_ps(a, b, c);
#else
    Lanes out{};
    for (int i = 0; i < 4; ++i) out[i] = std::fma(a[i], b[i], c[i]);
    return out;
#endif
  }
};

/// A triangle in the window.
struct TriangleSetup {
  Lanes dy20, dy01, dx20, dx01;  ///< divided by the area
  Lanes x0, y0;

  TriangleSetup(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c) {
    const float x01 = a.x - b.x, y01 = a.y - b.y, x20 = c.x - a.x, y20 = c.y - a.y;
    const float overArea = 1 / (x01 * y20 - y01 * x20);
    dy20 = lanesOf(y20 * overArea);
    dy01 = lanesOf(y01 * overArea);
    dx20 = lanesOf(x20 * overArea);
    dx01 = lanesOf(x01 * overArea);
    x0 = lanesOf(a.x);
    y0 = lanesOf(a.y);
  }

  template <class Plane>
  void plane(Lanes a, Lanes b, Lanes c, Plane& out) const {
    const Lanes d01 = a - b, d20 = c - a;
    out.dx = d01 * dy20 - d20 * dy01;
    out.dy = d20 * dx01 - d01 * dx20;
    out.atOrigin = a - (out.dx * x0 + out.dy * y0);
  }
};

}  // namespace

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
  setup.plane(w[0], w[1], w[2], overW_);
  count_ = (outputs.varyings + 3) / 4;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto of = [&](std::size_t corner) { return load(outputs.of(at[corner]) + 4 + i * 4) * w[corner]; };
    setup.plane(of(0), of(1), of(2), planes_[i]);
  }
}

template <class Rounding>
[[gnu::always_inline]] inline void VaryingMixer::mixAs(const ShadingQuad& quad, const FragmentTexels& out,
                                                       const glm::uvec2& at) const {
  const auto valueOf = [](const Plane4& plane, Lanes x, Lanes y) {
    return Rounding::sum(plane.dy, y, Rounding::sum(plane.dx, x, plane.atOrigin));
  };
  for (unsigned pixel = 0; pixel < 4; ++pixel) {
    const unsigned right = pixel & 1, up = pixel >> 1;
    const Lanes x = lanesOf(static_cast<float>(quad.x + right) + 0.5f);
    const Lanes y = lanesOf(static_cast<float>(quad.y + up) + 0.5f);
    const Lanes w = lanesOf(1) / valueOf(overW_, x, y);
    for (std::size_t i = 0; i < count_; ++i) store(out.of({at.x + right, at.y + up}, i), valueOf(planes_[i], x, y) * w);
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
