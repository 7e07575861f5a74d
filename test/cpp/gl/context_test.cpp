#include "gl/context.h"

#include <gtest/gtest.h>

#include <thread>

#include "expect_error.h"
#include "gl/program.h"
#include "telar/renderer.h"

namespace telar::gl::context_test {
namespace {

class EachBackend : public testing::TestWithParam<Backend> {};

TEST_P(EachBackend, GivesOpenGlEs3AndCompilesEs300Shaders) {
  const auto context = Context::create(GetParam());
  EXPECT_EQ(context->backend(), GetParam());
  EXPECT_GE(context->capabilities().maxTextureSize, 8192);
  EXPECT_GE(context->capabilities().maxSamples, 4);
  const std::string vertex = "#version 300 es\nvoid main() { gl_Position = vec4(0.0); }\n";
  const std::string fragment =
      "#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n";
  const Program program(*context, "test", vertex, fragment);
  context->check("test");
}

TEST_P(EachBackend, LeavesNothingCurrentAndCanBeMadeAgain) {
  for (int i = 0; i < 3; ++i) {
    const auto context = Context::create(GetParam());
    EXPECT_FALSE(context->renderer().empty());
  }
}

TEST_P(EachBackend, TwoThreadsHaveTheirOwnContexts) {
  std::thread other([] { EXPECT_NO_THROW(Context::create(GetParam())->check("thread")); });
  EXPECT_NO_THROW(Context::create(GetParam())->check("main"));
  other.join();
}

INSTANTIATE_TEST_SUITE_P(All, EachBackend,
                         testing::Values(Backend::kEglDevice, Backend::kEglSurfaceless, Backend::kOsmesa),
                         [](const auto& tested) {
                           std::string name = backendName(tested.param);
                           std::erase(name, '-');
                           return name;
                         });

TEST(Program, ErrorNamesTheProgramAndShowsTheSourceLine) {
  const auto context = Context::create(Backend::kAuto);
  const std::string vertex = "#version 300 es\nvoid main() { gl_Position = vec4(0.0); }\n";
  try {
    const Program program(*context, "broken", vertex,
                          "#version 300 es\nprecision highp float;\nvoid main() { nonsense(); }\n");
    FAIL() << "compiled";
  } catch (const Error& error) {
    EXPECT_EQ(error.code, "X_SHADER");
    EXPECT_NE(std::string(error.what()).find("broken.frag"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("nonsense"), std::string::npos) << error.what();
  }
}

TEST(Context, CheckReportsAnError) {
  const auto context = Context::create(Backend::kAuto);
  context->gl().Enable(0xFFFF);
  EXPECT_ERROR(context->check("a wrong enum"), "X_GL");
  EXPECT_NO_THROW(context->check("after it was taken"));
}

TEST(Probe, SaysWhichBackendsExist) {
  const std::string json = probeBackends();
  EXPECT_NE(json.find("\"egl-surfaceless\""), std::string::npos);
  EXPECT_NE(json.find("\"chosen\""), std::string::npos);
}

}  // namespace
}  // namespace telar::gl::context_test
