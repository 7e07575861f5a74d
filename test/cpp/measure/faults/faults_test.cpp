// The tests' own test: with a fault planted, each test that is to find it fails; without one, all hold. And every test
// of a bar finds some fault.
#include "faults.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

namespace telar::measure {
namespace {

using numerics::Fault;

/// googletest's code for tests that failed.
constexpr int FAILED = 1;

/// Seconds after which a program with a fault hangs.
const std::string HANGS_AFTER = "60";

int exitOf(int fault, const std::string& tests) {
  const std::string command = "timeout " + HANGS_AFTER + " " + TELAR_FAULTY + " " + std::to_string(fault) +
                              " --gtest_brief=1 --gtest_filter=" + tests + " > /dev/null 2>&1";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(MeasureFaults, WithoutOneEveryTestHolds) { EXPECT_EQ(exitOf(0, "*"), 0); }

TEST(MeasureFaults, EachIsFoundByItsTests) {
  const std::vector<Fault> faults = numerics::readFaults(TELAR_FAULTS);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    EXPECT_FALSE(faults[i].finders.empty());
    for (const auto& finder : faults[i].finders)
      EXPECT_EQ(exitOf(static_cast<int>(i) + 1, finder.check), FAILED)
          << "\"" << faults[i].name << "\" is not found by " << finder.check;
  }
}

}  // namespace
}  // namespace telar::measure
