#pragma once
#include <cmath>
#include <type_traits>

#include "visibility/lanes.h"
#include "visibility/window_vertices.h"

#if defined(__x86_64__)
#include <immintrin.h>
#define TELAR_FUSED __attribute__((target("fma")))
#else
#define TELAR_FUSED
#endif

namespace telar::visibility {

// What llvmpipe (Mesa 22.3, lp_state_setup.c and lp_bld_interp.c) computes of a triangle, with its operations in their
// order: where a triangle is a hundredth of a pixel high, what another order rounds is seen.

// LLVM fuses a product and a sum where the processor can, and so do these: a * b + c.
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

/// Whether LLVM fuses a product and a sum here.
bool fusesProducts();

/// What is linear over the window. @tparam Number  float or Lanes
template <class Number>
struct LinearPlane {
  Number atOrigin, dx, dy;
};

/// Its value, of floats in four lanes. @param x, y  px
template <class Rounding, class Number>
[[gnu::always_inline]] inline Lanes valueAt(const LinearPlane<Number>& plane, Lanes x, Lanes y) {
  if constexpr (std::is_same_v<Number, float>) {
    return Rounding::sum(lanesOf(plane.dy), y, Rounding::sum(lanesOf(plane.dx), x, lanesOf(plane.atOrigin)));
  } else {
    return Rounding::sum(plane.dy, y, Rounding::sum(plane.dx, x, plane.atOrigin));
  }
}

/// A triangle in the window. llvmpipe turns one round whose corners run counter-clockwise: (1, 0, 2).
/// @param offset  of the grid: planes are over places less that
struct TriangleSetup {
  float dy20, dy01, dx20, dx01;  ///< divided by the area
  float x0, y0;

  TriangleSetup(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c, float offset)
      : x0(a.x - offset), y0(a.y - offset) {
    const float x01 = a.x - b.x, y01 = a.y - b.y, x20 = c.x - a.x, y20 = c.y - a.y;
    const float overArea = 1 / (x01 * y20 - y01 * x20);
    dy20 = y20 * overArea;
    dy01 = y01 * overArea;
    dx20 = x20 * overArea;
    dx01 = x01 * overArea;
  }

  /// @param a, b, c  values at the corners
  template <class Number>
  LinearPlane<Number> plane(Number a, Number b, Number c) const {
    const Number d01 = a - b, d20 = c - a;
    const Number dx = d01 * dy20 - d20 * dy01, dy = d20 * dx01 - d01 * dx20;
    return {a - (dx * x0 + dy * y0), dx, dy};
  }
};

}  // namespace telar::visibility
