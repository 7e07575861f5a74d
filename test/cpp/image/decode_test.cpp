#include <gtest/gtest.h>

#include "telar/codec.h"

TEST(Decode, RefusesWhatIsNoImage) {
  EXPECT_THROW(telar::decodeImage({}, {}, {}), telar::Error);
}
