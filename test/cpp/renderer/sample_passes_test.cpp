#include "frame/sample_passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <set>

#include "frame/camera.h"

/// The passes of one picture fill its pixels evenly.
namespace telar::frame {
namespace {

Shot shotOf(int samples) {
  Shot shot;
  shot.width = 300, shot.height = 200;
  shot.samples = samples;
  shot.camera.position = {1, 2, 4};
  shot.camera.fovY = 35, shot.camera.near = 0.5, shot.camera.far = 20;
  return shot;
}

TEST(SamplePasses, OnePassTakesWhatMultisamplingGives) {
  for (const int samples : {1, Shot::SAMPLES_OF_A_PASS}) {
    const SamplePasses passes = samplePassesOf(shotOf(samples));
    EXPECT_EQ(passes.count, 1);
    EXPECT_EQ(passes.samples, samples);
    EXPECT_EQ(passes.shift(0), glm::dvec2(0)) << "a picture of one pass is not moved";
  }
}

TEST(SamplePasses, TheFirstOfThemFillThePixelEvenly) {
  const SamplePasses passes = samplePassesOf(shotOf(256));
  EXPECT_EQ(passes.count * passes.samples, 256);
  EXPECT_FALSE(passes.haveCells());
  for (int count = 16; count <= 256; count *= 2) {
    // Any division into `count` equal cells has one point in each.
    for (int columns = 1; columns <= count; columns *= 2) {
      const int rows = count / columns;
      std::set<std::pair<int, int>> cells;
      for (int i = 0; i < count; ++i) {
        const glm::dvec2 point = passes.shift(i) + 0.5;
        ASSERT_TRUE(point.x >= 0 && point.x < 1 && point.y >= 0 && point.y < 1) << "beside the pixel";
        cells.emplace(static_cast<int>(point.x * columns), static_cast<int>(point.y * rows));
      }
      EXPECT_EQ(cells.size(), static_cast<std::size_t>(count)) << columns << " x " << rows;
    }
    glm::dvec2 sum(0);
    for (int i = 0; i < count; ++i) sum += passes.shift(i);
    EXPECT_LT(glm::length(sum) / count, 0.25 / count) << "a picture of " << count << " passes is moved";
  }
}

TEST(SamplePasses, FewHaveACellOfAGridEach) {
  constexpr int COUNT = 16;
  const SamplePasses passes = samplePassesOf(shotOf(COUNT));
  EXPECT_TRUE(passes.haveCells());
  EXPECT_EQ(passes.cellsAcross(), 4);
  for (int some = 4; some <= COUNT; some *= 4) {
    const int edge = static_cast<int>(std::sqrt(some));
    std::set<std::pair<int, int>> cells;
    glm::dvec2 sum(0);
    for (int i = 0; i < some; ++i) {
      const glm::dvec2 place = static_cast<double>(edge) * (passes.shift(i) + 0.5);
      cells.emplace(static_cast<int>(place.x), static_cast<int>(place.y));
      sum += passes.shift(i);
      const glm::dvec2 middle = passes.shift(i) - passes.shiftInCell(i) + 0.5;
      EXPECT_EQ(passes.cell(i), glm::ivec2(middle * double(passes.cellsAcross())));
    }
    EXPECT_EQ(cells.size(), static_cast<std::size_t>(some));
    if (some < COUNT) continue;
    EXPECT_LT(glm::length(sum), 1e-12) << "a picture of " << COUNT << " passes is moved";
  }
}

/// The 16 that follow lie between the first 16: so 16 alone are never looked at.
TEST(SamplePasses, UpTo64AreLookedAtAfter32) {
  for (const int count : {16, 64}) {
    Shot shot = shotOf(count);
    for (const bool denoised : {false, true}) {
      shot.denoise = denoised;
      EXPECT_EQ(samplePassesOf(shot).fewest(), 32u);
    }
  }
}

TEST(SamplePasses, DenoisedPixelsAreLookedAtLater) {
  Shot shot = shotOf(1024);
  EXPECT_EQ(samplePassesOf(shot).fewest(), 16u);
  shot.denoise = true;
  EXPECT_EQ(samplePassesOf(shot).fewest(), 256u);
}

/// A pattern of threads as fine as the cells is grey to the mean of all passes: points of a grid would all see the same phase of it, and it would
/// beat with the pixels.
TEST(SamplePasses, DoNotBeatWithFineThreads) {
  for (const int count : {16, 64}) {
    const SamplePasses passes = samplePassesOf(shotOf(count));
    const double threads = std::sqrt(count);  // a pixel
    for (const glm::dvec2& way : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
      std::complex<double> seen = 0;
      for (int i = 0; i < count; ++i)
        seen += std::polar(1.0, 2 * glm::pi<double>() * threads * glm::dot(way, passes.shift(i)));
      EXPECT_LT(std::abs(seen) / count, 0.4) << count << " passes";
    }
  }
}

TEST(SamplePasses, MoveEveryPointByTheSamePartOfAPixel) {
  for (const bool perspective : {true, false}) {
    Shot shot = shotOf(16);
    shot.camera.projection = perspective ? Projection::kPerspective : Projection::kOrthographic;
    shot.camera.height = 3;
    const Camera camera = cameraOf(shot);
    const glm::dvec2 shift(0.3125, -0.4375);
    Camera moved = camera;
    moved.projection = shifted(camera.projection, shift, shot.width, shot.height);
    for (const glm::dvec3 point : {glm::dvec3(0), {0.5, -0.3, 1}, {-2, 1, -9}}) {
      const auto pixelOf = [&](const Camera& from) {
        const glm::dvec4 p = worldToPixel(from, shot.width, shot.height) * glm::dvec4(point, 1);
        return glm::dvec3(p) / p.w;
      };
      const glm::dvec3 change = pixelOf(moved) - pixelOf(camera);
      EXPECT_NEAR(change.x, shift.x, 1e-10);
      EXPECT_NEAR(change.y, -shift.y, 1e-10) << "pixels count downwards";
      EXPECT_NEAR(change.z, 0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace telar::frame
