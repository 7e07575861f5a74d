#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "brdf/gpu_probe.h"
#include "brdf/terms.h"

namespace telar::test::gpu_test {
namespace {

constexpr std::size_t ROWS = GpuProbe::ROWS;
// Relative, beyond what one-ulp changes of the arguments explain. Measured on llvmpipe: see the printed table.
constexpr double TOLERANCE = 2e-5;

class OnGpu : public testing::TestWithParam<Backend> {};

TEST_P(OnGpu, EveryTermAgreesWithDouble) {
  GpuProbe probe(GetParam());
  ASSERT_TRUE(probe.context().capabilities().colorBufferFloat) << "RGBA32F is not renderable here";
  std::printf("%-28s %10s %10s %10s %10s   (%s)\n", "term", "max", "99 %", "excess", "to float",
              probe.context().renderer().c_str());
  const std::string text = sharedText();
  for (const Term& term : terms()) {
    const std::vector<float> rows = samples(term, ROWS);
    const std::vector<float> result = probe.evaluate(text, term.expression, rows);
    std::vector<double> errors;
    double excess = 0, toFloat = 0;
    const float* worst = nullptr;
    for (std::size_t i = 0; i < ROWS; ++i) {
      const float* p = &rows[i * MAX_COLUMNS];
      double exact[MAX_COLUMNS];
      std::copy(p, p + MAX_COLUMNS, exact);
      const glm::vec3 actual(result[i * 4], result[i * 4 + 1], result[i * 4 + 2]);
      const glm::dvec3 expected = term.inDouble(exact);
      errors.push_back(relativeError(term, actual, expected));
      toFloat = std::max(toFloat, relativeError(term, actual, glm::dvec3(term.inFloat(p))));
      const double beyond = excessError(term, p, actual, expected);
      if (!(beyond <= excess)) excess = beyond, worst = p;
      if (term.nonNegative) {
        ASSERT_GE(std::min({actual.x, actual.y, actual.z}), 0.0f) << term.name << " row " << i;
      }
    }
    std::sort(errors.begin(), errors.end());
    std::printf("%-28s %10.1e %10.1e %10.1e %10.1e\n", term.name.c_str(), errors.back(), errors[ROWS * 99 / 100],
                excess, toFloat);
    EXPECT_LE(excess, TOLERANCE) << term.name << " at "
                                 << (worst ? testing::PrintToString(std::vector<float>(worst, worst + MAX_COLUMNS))
                                           : "");
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, OnGpu, testing::Values(Backend::kEglSurfaceless, Backend::kOsmesa),
                         [](const auto& tested) { return tested.param == Backend::kOsmesa ? "osmesa" : "egl"; });

}  // namespace
}  // namespace telar::test::gpu_test
