#include "frame/guided_denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include "core/random.h"
#include "frame/pixel_mean.h"

/// A noisy picture joined with one that has no noise and errs.
namespace telar::frame {
namespace {

constexpr float COVERED = 1;

/// Pixels of a picture, each from its place.
using Pixels = std::function<glm::vec4(int x, int y)>;

/// Normal to the second decimal, by the place and a seed: of mean 0 and deviation 1.
float noiseAt(int x, int y, std::uint32_t seed) {
  Random random(seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
  float sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

struct Case {
  int width = 96, height = 64;
  Pixels truth, guide;
  float noise = 0;          ///< standard error of the mean's colour
  float coverageNoise = 0;  ///< of its coverage, where a pixel is covered in part
  std::uint32_t passes = 16;

  std::vector<glm::vec4> of(const Pixels& pixels) const {
    std::vector<glm::vec4> list;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) list.push_back(pixels(x, y));
    return list;
  }
  std::vector<glm::vec4> mean() const {
    return of([this](int x, int y) {
      glm::vec4 pixel = truth(x, y);
      if (pixel.a == 0) return pixel;
      const glm::vec3 color = glm::vec3(pixel) / pixel.a + noise * noiseAt(x, y, 1);
      if (pixel.a < 1) pixel.a = glm::clamp(pixel.a + coverageNoise * noiseAt(x, y, 2), 0.0f, 1.0f);
      return glm::vec4(color * pixel.a, pixel.a);
    });
  }
  std::vector<glm::vec4> apart() const {
    return of([this](int x, int y) {
      const float coverage = truth(x, y).a;
      if (coverage == 0) return glm::vec4(0);
      const float ofCoverage = coverage < 1 ? coverageNoise * noiseAt(x, y, 4) : 0;
      return glm::vec4(glm::vec3(noise * noiseAt(x, y, 3)), ofCoverage);
    });
  }
  Denoised denoised() const {
    const auto all = mean(), halves = apart(), guess = of(guide);
    const std::vector<std::uint32_t> counts(all.size(), passes);
    return denoise({width, height, all, halves, guess, counts});
  }
};

/// Root of the mean square by which a channel is off.
double rmsOf(const std::vector<glm::vec4>& picture, const std::vector<glm::vec4>& truth, int channel = 1) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const double off = picture[i][channel] - truth[i][channel];
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(picture.size()));
}

glm::vec4 grey(float value) { return {value, value, value, COVERED}; }

/// Detail of a texture, which both have.
float detail(int x, int y) { return 0.2f + 0.1f * static_cast<float>((x * 7 + y * 3) % 5) / 4; }
/// Light that the guide lacks: smooth.
float light(int x) { return 1 + 0.3f * std::sin(static_cast<float>(x) / 25); }

TEST(GuidedDenoise, TakesLightFromTheMeanAndDetailFromTheGuide) {
  const Case smooth{.truth = [](int x, int y) { return grey(detail(x, y) * light(x)); },
                    .guide = [](int x, int y) { return grey(detail(x, y)); },
                    .noise = 0.05f};
  const auto truth = smooth.of(smooth.truth);
  const Denoised now = smooth.denoised();
  const double before = rmsOf(smooth.mean(), truth), guess = rmsOf(smooth.of(smooth.guide), truth);
  EXPECT_NEAR(before, 0.05, 0.004);
  EXPECT_GT(guess, 0.04);
  EXPECT_LT(rmsOf(now.picture, truth), 0.3 * std::min(before, guess));
}

/// In physical units white is some thousands.
TEST(GuidedDenoise, AsWellInLightOfAnyUnit) {
  constexpr float UNIT = 3000;
  const Case nits{.truth = [](int x, int y) { return grey(UNIT * detail(x, y) * light(x)); },
                  .guide = [](int x, int y) { return grey(UNIT * detail(x, y)); },
                  .noise = 0.05f * UNIT};
  EXPECT_LT(rmsOf(nits.denoised().picture, nits.of(nits.truth)), 0.3 * 0.05 * UNIT);
}

TEST(GuidedDenoise, SaysHowFarItIsOff) {
  const Case smooth{.truth = [](int x, int y) { return grey(detail(x, y) * light(x)); },
                    .guide = [](int x, int y) { return grey(detail(x, y)); },
                    .noise = 0.05f};
  const Denoised now = smooth.denoised();
  double squares = 0;
  for (const glm::vec2& error : now.error) squares += static_cast<double>(error.x * error.x);
  const double said = std::sqrt(squares / static_cast<double>(now.error.size()));
  const double is = rmsOf(now.picture, smooth.of(smooth.truth));
  EXPECT_GT(said, 0.5 * is);
  EXPECT_LT(said, 2.0 * is);
}

TEST(GuidedDenoise, WithoutNoiseThePictureIsTheMean) {
  const Case sure{.truth = [](int x, int y) { return grey(detail(x, y) * light(x)); },
                  .guide = [](int x, int y) { return grey(detail(y, x)); }};
  EXPECT_LT(rmsOf(sure.denoised().picture, sure.of(sure.truth)), 1e-6);
}

TEST(GuidedDenoise, WhereBothAgreeThePictureIsTheGuide) {
  const Case same{.truth = [](int x, int y) { return grey(detail(x, y)); },
                  .guide = [](int x, int y) { return grey(detail(x, y)); },
                  .noise = 0.05f};
  EXPECT_LT(rmsOf(same.denoised().picture, same.of(same.truth)), 0.2 * 0.05);
}

TEST(GuidedDenoise, AnEdgeThatTheGuideLacksStaysSharp) {
  const Case edge{.truth = [](int x, int) { return grey(x < 48 ? 0.1f : 0.8f); },
                  .guide = [](int, int) { return grey(0.4f); },
                  .noise = 0.01f};
  const Denoised now = edge.denoised();
  for (int y = 8; y < 56; ++y) {
    EXPECT_NEAR(now.picture[static_cast<std::size_t>(y * 96 + 47)].g, 0.1f, 0.05f);
    EXPECT_NEAR(now.picture[static_cast<std::size_t>(y * 96 + 48)].g, 0.8f, 0.05f);
  }
}

TEST(GuidedDenoise, ABrightPixelAndOneThatIsNoNumberStayAlone) {
  constexpr float NOTHING = std::numeric_limits<float>::quiet_NaN();
  const auto at = [](float sun, float hole) {
    return Case{.truth =
                    [=](int x, int y) {
                      if (x == 40 && y == 30) return grey(sun);
                      return grey(x == 60 && y == 30 ? hole : 0.2f);
                    },
                .guide = [](int, int) { return grey(0.3f); },
                .noise = 0.01f};
  };
  const Case harsh = at(1e30f, NOTHING);
  const auto now = harsh.denoised().picture, plain = at(0.2f, 0.2f).denoised().picture;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const bool harshHere = i == 30 * 96 + 40 || i == 30 * 96 + 60;
    if (harshHere) continue;
    EXPECT_NEAR(now[i].g, plain[i].g, 0.02f) << i;
  }
  EXPECT_EQ(now[30 * 96 + 40].g, harsh.mean()[30 * 96 + 40].g);
  EXPECT_TRUE(std::isnan(now[30 * 96 + 60].g));
}

TEST(GuidedDenoise, WhatEitherLacksIsTheMeans) {
  const Case rim{.truth = [](int x, int) { return x < 50 ? grey(0.5f) : glm::vec4(0); },
                 .guide = [](int x, int) { return x < 40 ? grey(0.5f) : glm::vec4(0); },
                 .noise = 0.1f};
  const auto now = rim.denoised().picture, mean = rim.mean();
  for (std::size_t x = 40; x < 96; ++x) EXPECT_EQ(now[30 * 96 + x], mean[30 * 96 + x]) << x;
}

TEST(GuidedDenoise, CoverageOfANetIsNearerAndThatOfAnEdgeStays) {
  const auto net = [](int x, int y) {
    const float coverage = 0.5f + 0.1f * std::sin(static_cast<float>(x + y) / 30);
    return glm::vec4(0.4f * coverage, 0.4f * coverage, 0.4f * coverage, coverage);
  };
  const auto rim = [](int x, int) {
    const float coverage = x < 48 ? 1.0f : x == 48 ? 0.5f : 0.0f;
    return glm::vec4(glm::vec3(0.4f * coverage), coverage);
  };
  // What one pass errs by, of a point that is covered or not, or behind several layers of sheer cloth.
  constexpr float OF_NET = 0.48f, OF_LAYERS = 0.14f, OF_EDGE = 0.2f;
  for (const std::uint32_t passes : {16u, 64u, 256u}) {
    const float part = 1 / std::sqrt(static_cast<float>(passes));
    for (const float ofPass : {OF_NET, OF_LAYERS}) {
      const Case knit{.truth = net,
                      .guide = [](int, int) { return glm::vec4(0.2f, 0.2f, 0.2f, 0.5f); },
                      .coverageNoise = ofPass * part,
                      .passes = passes};
      const auto truth = knit.of(knit.truth);
      EXPECT_LT(rmsOf(knit.denoised().picture, truth, 3), 0.6 * rmsOf(knit.mean(), truth, 3))
          << ofPass << ", " << passes;
    }

    const Case edge{.truth = rim,
                    .guide = [](int x, int) { return x < 48 ? grey(0.4f) : glm::vec4(0); },
                    .coverageNoise = OF_EDGE * part,
                    .passes = passes};
    const auto now = edge.denoised().picture, mean = edge.mean();
    EXPECT_EQ(now, mean) << passes;
  }
}

TEST(GuidedDenoise, ALoneEdgeBesideANetStays) {
  const auto covered = [](int x, int) {
    const float coverage = x < 32 || x == 72 ? 0.5f : x < 48 || x > 72 ? 0.0f : 1.0f;
    return glm::vec4(glm::vec3(0.4f * coverage), coverage);
  };
  Case both{.truth = covered, .guide = covered, .noise = 0, .coverageNoise = 0.12f};
  const auto isNet = [](std::size_t i) { return i % 96 < 40; };
  auto mean = both.mean(), apart = both.apart();
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (isNet(i) || mean[i].a == 1 || mean[i].a == 0) continue;
    mean[i].a = 0.5f + (mean[i].a - 0.5f) / 6;  // of an edge the passes tell more
    apart[i].a /= 6;
  }
  const auto guide = both.of(both.guide);
  const std::vector<std::uint32_t> counts(mean.size(), both.passes);
  const auto now = denoise({both.width, both.height, mean, apart, guide, counts}).picture;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (isNet(i)) continue;
    EXPECT_EQ(now[i].a, mean[i].a) << i;
  }
}

TEST(GuidedDenoise, TilesDoNotShow) {
  const auto wide = [](int from, int width) {
    return Case{.width = width,
                .height = 24,
                .truth = [from](int x, int y) { return grey(detail(x + from, y) * light(x + from)); },
                .guide = [from](int x, int y) { return grey(detail(x + from, y)); },
                .noise = 0};
  };
  // Wider than a tile, and a part of it about the tile's end that lies within one: the noise is told apart.
  const int from = 1024 - 320, width = 640;
  Case all = wide(0, 2048), part = wide(from, width);
  const auto noisy = [](const Case& picture, int first) {
    auto mean = picture.of(picture.truth), apart = mean;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const auto i = static_cast<std::size_t>(y * picture.width + x);
        mean[i] += glm::vec4(glm::vec3(0.05f * noiseAt(x + first, y, 1)), 0);
        apart[i] = glm::vec4(glm::vec3(0.05f * noiseAt(x + first, y, 3)), 0);
      }
    }
    const auto guide = picture.of(picture.guide);
    const std::vector<std::uint32_t> counts(mean.size(), picture.passes);
    return denoise({picture.width, picture.height, mean, apart, guide, counts}).picture;
  };
  const auto whole = noisy(all, 0), cut = noisy(part, from);
  for (int y = 0; y < 24; ++y) {
    for (int x = 1024 - 160; x < 1024 + 160; ++x) {
      EXPECT_EQ(whole[static_cast<std::size_t>(y * 2048 + x)], cut[static_cast<std::size_t>(y * width + x - from)])
          << x << ", " << y;
    }
  }
}

TEST(GuidedDenoise, AMeanOfPassesIsJoinedAndSettlesByWhatIsLeft) {
  constexpr int SIDE = 48;
  Shot shot;
  shot.width = shot.height = SIDE;
  shot.toneMapping = ToneMapping::kNone;
  shot.noise = 10;
  const auto truth = [](int x) { return 0.25f * light(x); };
  PixelMean joined(shot), plain(shot);
  std::vector<glm::vec4> guide(SIDE * SIDE, grey(0.25f));
  joined.setGuide(guide);
  for (int pass = 0; pass < 16; ++pass) {
    Frame frame{SIDE, SIDE, PixelType::kRgbaF32, std::vector<std::byte>(SIDE * SIDE * sizeof(glm::vec4))};
    auto* pixels = reinterpret_cast<glm::vec4*>(frame.pixels.data());
    for (int y = 0; y < SIDE; ++y)
      for (int x = 0; x < SIDE; ++x)
        pixels[y * SIDE + x] = grey(truth(x) + 0.3f * noiseAt(x, y, static_cast<std::uint32_t>(10 + pass)));
    joined.add(frame);
    plain.add(frame);
  }
  std::vector<glm::vec4> picture;
  for (int i = 0; i < SIDE * SIDE; ++i) picture.push_back(grey(truth(i % SIDE)));
  EXPECT_LT(rmsOf(joined.mean(), picture), 0.4 * rmsOf(plain.mean(), picture));
  EXPECT_TRUE(joined.allSettled());
  EXPECT_FALSE(plain.allSettled());
  EXPECT_LT(joined.standardError(), 0.6 * plain.standardError());
}

}  // namespace
}  // namespace telar::frame
