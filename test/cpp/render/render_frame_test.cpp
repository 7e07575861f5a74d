#include "telar/render_frame.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expect_error.h"
#include "telar/reference.h"

namespace telar {
namespace {

Frame frameNamed(std::uint32_t width) { return {width, 1, PixelType::kRgba8, {}}; }

constexpr std::uint32_t RASTER = 1, TRACER = 2;

/// What the double of the path tracer throws: the code of an error, or nothing.
std::string failure;

class RasterDouble : public Renderer {
 public:
  Frame draw(const std::shared_ptr<const Scene>&, const Shot&, std::span<const std::byte> environment,
             const CancelToken& cancel, FrameInfo& info, const Progress&) override {
    cancel.check();
    info.json = R"({"environment": )" + std::to_string(environment.size()) + warnings_ + "}";
    return frameNamed(RASTER);
  }
  void release(const Scene&) override {}
  std::string describe() const override { return {}; }
  int liveObjects() const override { return 0; }
  void warn() { warnings_ = R"(, "warnings": [{"code": "W_ENVIRONMENT_RANGE"}])"; }

 private:
  std::string warnings_;
};

/// It covers the picture, as far as anyone knows.
Primitive aroundTheCamera() {
  Primitive primitive;
  primitive.positions = {{-9, -9, -9}, {9, -9, -9}, {0, 9, 9}};
  return primitive;
}

class RenderFrame : public testing::Test {
 protected:
  Frame render(const Shot& shot, std::uint64_t triangles = 0) {
    auto scene = std::make_shared<Scene>();
    scene->triangleCount = triangles;
    scene->meshes.push_back({"mesh", {aroundTheCamera()}});
    scene->nodes.emplace_back().mesh = 0;
    return renderFrame(raster_, scene, shot, environment_, {}, cancel_, progress_, info_);
  }

  RasterDouble raster_;
  std::array<std::byte, 3> environment_{};
  CancelToken cancel_;
  Progress progress_;
  FrameInfo info_;
};

TEST_F(RenderFrame, TheRasterDrawsAShotWithoutReference) {
  EXPECT_EQ(render(Shot()).width, RASTER);
  EXPECT_EQ(info_.json, R"({"environment": 3})");
  EXPECT_EQ(progress_.part(), 0);
}

TEST_F(RenderFrame, ThePathTracerDrawsAShotWithReference) {
  Shot shot;
  shot.reference = Shot::Reference{};
  EXPECT_EQ(render(shot).width, TRACER);
  EXPECT_EQ(info_.json, "tracer 3");
  EXPECT_EQ(progress_.part(), 1);
}

/// tracedInstead() takes it for so many triangles.
Shot highShot() {
  Shot shot;
  shot.width = shot.height = 64;
  shot.samples = 1024;
  shot.isHigh = true;
  shot.shading = ShadingModel::kFabric;
  return shot;
}
constexpr std::uint64_t MANY = 1'000'000;

TEST_F(RenderFrame, ThePathTracerDrawsHighWhereItCostsLess) {
  EXPECT_EQ(render(highShot(), MANY).width, TRACER);
  EXPECT_EQ(render(highShot(), 0).width, RASTER);
}

TEST_F(RenderFrame, TheRasterDrawsHighWhereThereIsNoPathTracer) {
  failure = "X_LIBRARY_MISSING";
  EXPECT_EQ(render(highShot(), MANY).width, RASTER);
  const auto codes = [&] {
    std::vector<std::string> found;
    const auto info = nlohmann::json::parse(info_.json);
    EXPECT_EQ(info.at("environment"), 3) << "what the raster says of the frame stays";
    for (const auto& warning : info.value("warnings", nlohmann::json::array())) found.push_back(warning.at("code"));
    return found;
  };
  using Codes = std::vector<std::string>;
  EXPECT_EQ(codes(), Codes{"W_LIBRARY_MISSING"});
  EXPECT_NE(info_.json.find("the double fails"), std::string::npos) << "the cure is in the error's message";
  raster_.warn();
  render(highShot(), MANY);
  EXPECT_EQ(codes(), (Codes{"W_ENVIRONMENT_RANGE", "W_LIBRARY_MISSING"}));
  render(highShot(), 0);
  EXPECT_EQ(codes(), Codes{"W_ENVIRONMENT_RANGE"}) << "the raster's anyway";
  failure = "X_MEMORY";
  EXPECT_ERROR(render(highShot(), MANY), "X_MEMORY");
  failure.clear();
}

}  // namespace

Frame drawReference(const Scene&, const Shot&, std::span<const std::byte> environment, const RendererOptions&,
                    const CancelToken&, const Progress& progress, FrameInfo& info) {
  if (!failure.empty()) throw Error(failure, "the double fails");
  info.json = "tracer " + std::to_string(environment.size());
  progress.reach(1);
  return frameNamed(TRACER);
}

}  // namespace telar
