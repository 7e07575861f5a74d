#pragma once
#include <cmath>
#include <cstddef>

/// Angles in float, off by less than 3e-7. The compiler puts them into their callers: libm takes a call for each.
namespace telar::reference {

/// @param coefficients  from that of the highest power down
template <std::size_t N>
float polynomial(const float (&coefficients)[N], float x) {
  float sum = coefficients[0];
  for (std::size_t i = 1; i < N; ++i) sum = sum * x + coefficients[i];
  return sum;
}

/// src: Abramowitz & Stegun 1964, "Handbook of Mathematical Functions", 4.4.46
/// @param x  [-1, 1]    @return [-PI / 2, PI / 2]
inline float arcSine(float x) {
  constexpr float A[] = {-0.0012624911f, 0.0066700901f, -0.0170881256f, 0.0308918810f,
                         -0.0501743046f, 0.0889789874f, -0.2145988016f, 1.5707963050f};
  const float a = std::abs(x);
  return std::copysign(1.5707963268f - std::sqrt(1 - a) * polynomial(A, a), x);
}

/// src: the same, 4.4.49
/// @return angle of the point from +x, [-PI, PI]; 0 at the origin
inline float arcTangent(float y, float x) {
  constexpr float A[] = {0.0028662257f, -0.0161657367f, 0.0429096138f, -0.0752896400f,
                         0.1065626393f, -0.1420889944f, 0.1999355085f, -0.3333314528f};
  const float ax = std::abs(x), ay = std::abs(y);
  const float low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
  const float t = high > 0 ? low / high : 0, t2 = t * t;
  float angle = t + t * t2 * polynomial(A, t2);
  if (ay > ax) angle = 1.5707963268f - angle;
  if (x < 0) angle = 3.1415926536f - angle;
  return std::copysign(angle, y);
}

struct SineCosine {
  float sine, cosine;
};

/// Taylor's series within an eighth of a turn, which ends where a float does.
/// @param turns  [-0.5, 0.5]
inline SineCosine sineCosine(float turns) {
  const float quarters = turns * 4;
  const int nearest = static_cast<int>(quarters + (quarters < 0 ? -0.5f : 0.5f));
  const float x = (quarters - static_cast<float>(nearest)) * 1.5707963268f, x2 = x * x;
  const float sine = x + x * x2 * (-0.16666667f + x2 * (8.3333333e-3f + x2 * (-1.9841270e-4f + x2 * 2.7557319e-6f)));
  const float cosine = 1 - x2 * (0.5f + x2 * (-4.1666667e-2f + x2 * (1.3888889e-3f - x2 * 2.4801587e-5f)));
  const bool odd = (nearest & 1) != 0;
  const float s = odd ? cosine : sine, c = odd ? sine : cosine;
  return {(nearest & 2) != 0 ? -s : s, ((nearest + 1) & 2) != 0 ? -c : c};
}

}  // namespace telar::reference
