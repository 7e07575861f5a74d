#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "brdf/terms.h"

namespace telar::test::float_double_test {
namespace {

constexpr std::size_t ROWS = 4096;
// Beyond what one-ulp changes of the arguments explain, a chain of some ten fp32 steps may lose this much.
constexpr double TOLERANCE = 2e-6;

TEST(FloatAgainstDouble, EveryTermIsFiniteAndWithinRounding) {
  std::printf("%-28s %10s %10s %10s   (C++ float against double, %zu rows)\n", "term", "max", "99 %", "excess", ROWS);
  for (const Term& term : terms()) {
    const std::vector<float> rows = samples(term, ROWS);
    std::vector<double> errors;
    double excess = 0;
    const float* worst = nullptr;
    for (std::size_t i = 0; i < ROWS; ++i) {
      const float* p = &rows[i * MAX_COLUMNS];
      double exact[MAX_COLUMNS];
      std::copy(p, p + MAX_COLUMNS, exact);
      const glm::vec3 actual = term.inFloat(p);
      const glm::dvec3 expected = term.inDouble(exact);
      errors.push_back(relativeError(term, actual, expected));
      const double beyond = excessError(term, p, actual, expected);
      if (!(beyond <= excess)) excess = beyond, worst = p;
      if (term.nonNegative) {
        ASSERT_GE(std::min({actual.x, actual.y, actual.z}), 0.0f) << term.name << " row " << i;
        ASSERT_GE(std::min({expected.x, expected.y, expected.z}), 0.0) << term.name << " row " << i;
      }
    }
    std::sort(errors.begin(), errors.end());
    std::printf("%-28s %10.1e %10.1e %10.1e\n", term.name.c_str(), errors.back(), errors[ROWS * 99 / 100], excess);
    EXPECT_LE(excess, TOLERANCE) << term.name << " at "
                                 << (worst ? testing::PrintToString(std::vector<float>(worst, worst + MAX_COLUMNS))
                                           : "");
  }
}

}  // namespace
}  // namespace telar::test::float_double_test
