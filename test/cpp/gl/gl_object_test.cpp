#include "gl/gl_object.h"

#include <gtest/gtest.h>

#include "gl/context.h"

namespace telar::gl::gl_object_test {
namespace {

TEST(GlObject, CountsMovesAndReleases) {
  const auto context = Context::create(Backend::kAuto);
  const Functions& gl = context->gl();
  {
    Buffer a(gl);
    EXPECT_EQ(gl.liveObjects, 1);
    Buffer b(std::move(a));
    EXPECT_FALSE(a);  // NOLINT: the moved-from state is the subject
    EXPECT_TRUE(b);
    EXPECT_EQ(gl.liveObjects, 1);
    Buffer c(gl);
    c = std::move(b);
    EXPECT_EQ(gl.liveObjects, 1);
    Buffer& self = c;
    c = std::move(self);
    EXPECT_TRUE(c);
    Buffer empty;
    empty = std::move(c);
    EXPECT_EQ(gl.liveObjects, 1);
  }
  EXPECT_EQ(gl.liveObjects, 0);
}

}  // namespace
}  // namespace telar::gl::gl_object_test
