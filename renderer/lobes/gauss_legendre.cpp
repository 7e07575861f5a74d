#include "lobes/gauss_legendre.h"

#include <cmath>
#include <numbers>

namespace telar::lobes {
namespace {

struct Value {
  double value, slope;
};

/// Legendre's polynomial of a degree and its derivative, by the recurrence of Bonnet.
Value legendre(int degree, double x) {
  double before = 1, now = x;
  for (int k = 2; k <= degree; ++k) {
    const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
    before = now, now = next;
  }
  return {now, degree * (x * now - before) / (x * x - 1)};
}

}  // namespace

std::vector<Node> gaussLegendre(int count) {
  constexpr int NEWTON_STEPS = 8;  // from Tricomi's first guess; 4 reach the last bit
  std::vector<Node> nodes(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    for (int step = 0; step < NEWTON_STEPS; ++step) {
      const Value p = legendre(count, x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(count, x).slope;
    nodes[static_cast<std::size_t>(i)] = {(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)};
  }
  return nodes;
}

}  // namespace telar::lobes
