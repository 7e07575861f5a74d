// The tests of lengths on what has the faults in it: test_measure_faulty NUMBER [options of googletest]
#include <gtest/gtest.h>

#include <cstdlib>

#include "planted.h"

namespace telar {
int plantedFault = 0;
}  // namespace telar

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  telar::plantedFault = std::atoi(argv[1]);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
