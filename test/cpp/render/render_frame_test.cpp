#include "telar/render_frame.h"

#include <gtest/gtest.h>

#include <array>

#include "telar/reference.h"

namespace telar {
namespace {

Frame frameNamed(std::uint32_t width) { return {width, 1, PixelType::kRgba8, {}}; }

constexpr std::uint32_t RASTER = 1, TRACER = 2;

class RasterDouble : public Renderer {
 public:
  Frame draw(const std::shared_ptr<const Scene>&, const Shot&, std::span<const std::byte> environment,
             const CancelToken& cancel, FrameInfo& info) override {
    cancel.check();
    info.json = "raster " + std::to_string(environment.size());
    return frameNamed(RASTER);
  }
  void release(const Scene&) override {}
  std::string describe() const override { return {}; }
  int liveObjects() const override { return 0; }
};

class RenderFrame : public testing::Test {
 protected:
  Frame render(const Shot& shot) {
    return renderFrame(raster_, std::make_shared<const Scene>(), shot, environment_, {}, cancel_, progress_, info_);
  }

  RasterDouble raster_;
  std::array<std::byte, 3> environment_{};
  CancelToken cancel_;
  Progress progress_;
  FrameInfo info_;
};

TEST_F(RenderFrame, TheRasterDrawsAShotWithoutReference) {
  EXPECT_EQ(render(Shot()).width, RASTER);
  EXPECT_EQ(info_.json, "raster 3");
  EXPECT_EQ(progress_.part(), 0);
}

TEST_F(RenderFrame, ThePathTracerDrawsAShotWithReference) {
  Shot shot;
  shot.reference = Shot::Reference{};
  EXPECT_EQ(render(shot).width, TRACER);
  EXPECT_EQ(info_.json, "tracer 3");
  EXPECT_EQ(progress_.part(), 1);
}

}  // namespace

Frame drawReference(const Scene&, const Shot&, std::span<const std::byte> environment, const RendererOptions&,
                    const CancelToken&, const Progress& progress, FrameInfo& info) {
  info.json = "tracer " + std::to_string(environment.size());
  progress.reach(1);
  return frameNamed(TRACER);
}

}  // namespace telar
