// Every figure at the reduced count.
#include <gtest/gtest.h>

#include <algorithm>

#include "check.h"

namespace telar::numerics {
namespace {

class Numerics : public testing::TestWithParam<Check> {};

TEST_P(Numerics, EveryFigureHolds) {
  for (const Figure& figure : GetParam().run(Scale::kQuick)) {
    std::printf("%-62s %-12s %10.3g\n", figure.what.c_str(), figure.shading.c_str(), figure.measured);
    EXPECT_TRUE(figure.holds()) << figure.what << " " << figure.shading << ": " << figure.measured << " is not within "
                                << figure.low << " .. " << figure.high << "; " << figure.where;
    EXPECT_GT(figure.full, 0u) << figure.what;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Numerics, testing::ValuesIn(allChecks()), [](const auto& tested) {
  std::string name = tested.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

}  // namespace
}  // namespace telar::numerics
