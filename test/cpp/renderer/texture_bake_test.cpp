#include "renderer/texture_bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "brdf/brdf.h"

namespace telar::test {
namespace {

/// RGB a texel's normal, A how flat it lies.
glm::dvec4 reliefOf(const glm::dvec4& texel) {
  const glm::dvec2 s = slopeOf(texel);
  return {glm::normalize(glm::dvec3(s, 1)), 1 / (1 + 4 * glm::dot(s, s))};
}

/// The slope and its square, times the share that lies flat.
glm::dvec4 facetOf(const glm::dvec4& texel) {
  const glm::dvec2 s = slopeOf(texel);
  const double slope2 = glm::dot(s, s);
  return glm::dvec4(s, 1, slope2) * std::max(1 / (1 + std::pow(slope2 / 0.09, 2)), 1e-4);
}

/// An image of the means over texels as a sampler shows them: blended with their neighbours, at four points of each, or at
/// its own.
template <typename F>
std::vector<glm::dvec4> blended(const Image8& image, const F& of, bool atOwn = false) {
  std::vector<glm::dvec4> list;
  for (int y = 0; y < int(image.height); ++y) {
    for (int x = 0; x < int(image.width); ++x) {
      const auto ofSeen = [&](const auto& seen) { return of(seen(image)); };
      list.push_back(atOwn ? atOwnPoint(x, y, ofSeen) : meanOverPoints(x, y, ofSeen));
    }
  }
  return list;
}

TEST_F(TextureBake, LevelsHoldTheMeansOfNormalsAndOfHowFlatTheyLie) {
  for (const glm::uvec2 size : {glm::uvec2(64, 64), glm::uvec2(44, 27), glm::uvec2(1, 5)}) {
    const Image8 image = weaveNormals(size.x, size.y, 3.3, 0.9);
    const gl::Texture source = upload(image, GL_RGBA8);
    const gl::Texture baked = baker_.normalVariance({source.get(), glm::ivec2(size)}, {}, 0, 0, CancelToken());
    const bool halves = size.x % 2 == 0 && size.y % 2 == 0;
    const std::vector<glm::dvec4> means = blended(image, reliefOf, halves);
    for (int level = 0; (std::max(size.x, size.y) >> level) > 0; ++level) {
      const glm::ivec2 levelSize = sizeAt(image, level);
      const auto texels = read<float>(baked, level, levelSize);
      for (int i = 0; i < levelSize.x * levelSize.y; ++i) {
        const glm::dvec4 moments = meanOver(image, {i % levelSize.x, i / levelSize.x}, levelSize, [&](int x, int y) {
          return level == 0 ? reliefOf(texelAt(image, x, y)) : means[std::size_t(y) * size.x + std::size_t(x)];
        });
        // Where sides are odd, a texel of a level is in part that of two of the one before: wider averages then.
        const bool exact = size.x == 64 || level < 2;
        for (int c = 0; c < 4; ++c) {
          const double bar = exact ? 1e-4 + 1e-3 * std::abs(moments[c]) : 0.25;
          EXPECT_NEAR(texels[std::size_t(i) * 4 + std::size_t(c)], moments[c], bar) << level << " " << i;
        }
      }
    }
  }
}

TEST_F(TextureBake, LevelsHoldTheSlopesOfFacetsApartFromEdges) {
  constexpr int SIDE = 32;
  const Image8 image = weaveNormals(SIDE, SIDE, 3.3, 0.9);
  const gl::Texture source = upload(image, GL_RGBA8);
  const gl::Texture baked = baker_.normalFacets({source.get(), {SIDE, SIDE}}, CancelToken());
  const std::vector<glm::dvec4> means = blended(image, facetOf);
  std::vector<float> smallest;
  for (int level = 0; (SIDE >> level) > 0; ++level) {
    const glm::ivec2 size = sizeAt(image, level);
    const auto texels = read<float>(baked, level, size);
    for (int i = 0; i < size.x * size.y; ++i) {
      const glm::dvec4 moments = meanOver(image, {i % size.x, i / size.x}, size, [&](int x, int y) {
        const glm::dvec2 slope = slopeOf(texelAt(image, x, y));
        if (level == 0) {  // texels from near are as they are
          const double z = texels[std::size_t(y * SIDE + x) * 4 + 2];
          return z * glm::dvec4(slope, 1, glm::dot(slope, slope));
        }
        return means[std::size_t(y) * SIDE + std::size_t(x)];
      });
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(texels[std::size_t(i) * 4 + std::size_t(c)], moments[c], 1e-4 + 1e-3 * std::abs(moments[c]))
            << level;
      smallest = texels;
    }
  }
  double all = 0;
  for (int i = 0; i < SIDE * SIDE; ++i) {
    const glm::dvec2 slope = slopeOf(texelAt(image, i % SIDE, i / SIDE));
    all += glm::dot(slope, slope) / (SIDE * SIDE);
  }
  EXPECT_LT(2 * smallest[3] / smallest[2], all);  // mean square of slopes: without the edges it is small
}

/// Where all is as steep there are no edges between facets, in whatever a level of half floats keeps of it.
TEST_F(TextureBake, EvenSlopesAreNoEdges) {
  for (const float slope : {0.5f, 2.0f, 4.0f, 7.0f}) {
    const Image8 image = imageOf(
        8, 8, [&](double, double) { return glm::vec4(glm::normalize(glm::vec3(slope, 0, 1)) * 0.5f + 0.5f, 1); });
    const glm::dvec2 stored = slopeOf(texelAt(image, 0, 0));
    const gl::Texture source = upload(image, GL_RGBA8);
    const gl::Texture baked = baker_.normalFacets({source.get(), {8, 8}}, CancelToken());
    for (int level = 0; level < 4; ++level) {
      const auto texel = read<float>(baked, level, glm::ivec2(8 >> level));
      const double share = std::max(double(texel[2]), brdf_d::FACET_SHARE_MIN);  // as material/normal.glsl
      EXPECT_NEAR(texel[0] / share, stored.x, 1e-3 * stored.x) << slope << " " << level;
      if (level == 0) continue;  // all of it counts as facet
      // Relative roundings of half floats are 2^-11 at most: that of the weighted square counts twice, that of the
      // share three times.
      EXPECT_LT(brdf_d::edgeShare(share, texel[3] / share), 2.5e-3) << slope << " " << level;
    }
  }
}

/// Also where the map that tells of holes has other texels than the normals.
TEST_F(TextureBake, HolesOfACutOutMaterialLieFlat) {
  const Image8 normals = weaveNormals(16, 16, 3.3, 0.9);
  const gl::Texture source = upload(normals, GL_RGBA8);
  const gl::Texture whole = baker_.normalVariance({source.get(), {16, 16}}, {}, 0, 0, CancelToken());
  for (const int side : {16, 32}) {
    const Image8 cover = imageOf(std::uint32_t(side), std::uint32_t(side),
                                 [](double u, double) { return glm::vec4(1, 1, 1, u < 0.5 ? 1 : 0.25); });
    const gl::Texture alpha = upload(cover, GL_RGBA8);
    const gl::Texture baked =
        baker_.normalVariance({source.get(), {16, 16}}, {alpha.get(), {side, side}}, 0.5f, 0, CancelToken());
    for (const int level : {0, 1, 2}) {
      const glm::ivec2 size = sizeAt(normals, level);
      const auto texels = read<float>(baked, level, size), plain = read<float>(whole, level, size);
      std::size_t leaning = 0;
      for (int i = 0; i < size.x * size.y; ++i) {
        const bool hole = 2 * (i % size.x) >= size.x;
        for (int c = 0; c < 4; ++c) {
          const std::size_t at = std::size_t(i) * 4 + std::size_t(c);
          EXPECT_EQ(texels[at], hole ? float(c > 1) : plain[at]) << side << " " << level << " " << i;
          leaning += hole && plain[at] != float(c > 1);
        }
      }
      EXPECT_GT(leaning, 0u);  // without a cover they would not be flat
    }
  }
}

TEST_F(TextureBake, SpoiltNormalsGiveFiniteTexels) {
  const Image8 image = imageOf(8, 8, [](double u, double v) {
    return u < 0.5 ? (v < 0.5 ? glm::vec4(0) : glm::vec4(0.5f, 0.5f, 0.5f, 1)) : glm::vec4(1, v, 0, 1);
  });
  const gl::Texture source = upload(image, GL_RGBA8);
  const gl::Texture baked = baker_.normalVariance({source.get(), {8, 8}}, {}, 0, 0, CancelToken());
  const auto first = read<float>(baked, 0, {8, 8});
  EXPECT_EQ(glm::vec4(first[224], first[225], first[226], first[227]), glm::vec4(0, 0, 1, 1));  // no length: no slope
  for (int level = 0; level < 4; ++level) {
    for (const float value : read<float>(baked, level, glm::ivec2(8 >> level))) EXPECT_LE(std::abs(value), 1);
  }
}

/// Share of a highlight's light by tilt of the half vector, and the tilt within which half of it falls.
class Highlight {
 public:
  template <typename Distribution>
  explicit Highlight(const Distribution& d) {
    for (int i = 0; i < STEPS; ++i) {
      const double tilt = (i + 0.5) / STEPS * glm::half_pi<double>();
      sums_.push_back((sums_.empty() ? 0 : sums_.back()) + d(tilt) * std::cos(tilt) * std::sin(tilt));
    }
    const double total = sums_.back();
    for (double& sum : sums_) sum /= total;
  }
  double halfWidth() const {
    const auto half = std::lower_bound(sums_.begin(), sums_.end(), 0.5);
    const auto i = half - sums_.begin();
    const double before = i > 0 ? sums_[std::size_t(i) - 1] : 0;
    return (double(i) + (0.5 - before) / (*half - before)) / STEPS;
  }
  /// Part of the light within a part of the quarter turn.
  double within(double width) const {
    const double at = width * STEPS - 1;
    const auto i = std::size_t(std::max(at, 0.0));
    const double before = at < 0 ? 0 : sums_[i];
    const double after = at < 0 ? sums_[0] : sums_[std::min(i + 1, sums_.size() - 1)];
    return before + (after - before) * (at - std::floor(at));
  }

 private:
  static constexpr int STEPS = 60;
  std::vector<double> sums_;
};

/// D of all texels together, averaged over the directions in which the half vector tilts.
double distributionOf(const Image8& image, double alpha, double tilt) {
  constexpr int AROUND = 8;
  double sum = 0;
  for (int k = 0; k < AROUND; ++k) {
    const double phi = glm::two_pi<double>() * (k + 0.5) / AROUND;
    const glm::dvec3 h(std::sin(tilt) * std::cos(phi), std::sin(tilt) * std::sin(phi), std::cos(tilt));
    const auto facet = [&](int x, int y) {
      const glm::dvec3 n = glm::normalize(glm::dvec3(slopeOf(texelAt(image, x, y)), 1));
      return glm::dvec4(brdf_d::D_GGX(alpha, std::max(glm::dot(n, h), 0.0)) / n.z);
    };
    sum += meanOver(image, {0, 0}, {1, 1}, facet).x;
  }
  return sum / AROUND;
}

TEST_F(TextureBake, WidenedHighlightsAreAsWideAsWhatTheyStandFor) {
  double worst = 0, worstShare = 0, worstWithout = 0;
  for (const double depth : {0.15, 0.4, 0.8}) {
    const Image8 image = weaveNormals(48, 48, 3, depth);
    const gl::Texture source = upload(image, GL_RGBA8);
    const gl::Texture baked = baker_.normalVariance({source.get(), {48, 48}}, {}, 0, 0, CancelToken());
    const auto texel = read<float>(baked, 5, {1, 1});
    for (const double roughness : {0.2, 0.35, 0.5}) {
      const double alpha = roughness * roughness;
      const double mean2 = (texel[0] * texel[0] + texel[1] * texel[1]) / (texel[2] * texel[2]);
      const double variance = 0.25 * (1 / texel[3] - 1) - mean2;
      const double widened = std::pow(brdf_d::roughnessWithSlopes(roughness, variance), 2);
      const Highlight truth([&](double tilt) { return distributionOf(image, alpha, tilt); });
      const Highlight one([&](double tilt) { return brdf_d::D_GGX(widened, std::cos(tilt)); });
      const Highlight plain([&](double tilt) { return brdf_d::D_GGX(alpha, std::cos(tilt)); });
      const double width = one.halfWidth() / truth.halfWidth(), without = plain.halfWidth() / truth.halfWidth();
      const double share = one.within(truth.halfWidth());
      worst = std::max(worst, std::abs(std::log(width)));
      worstWithout = std::max(worstWithout, std::abs(std::log(without)));
      worstShare = std::max(worstShare, std::abs(share - 0.5));
      std::cout << "depth " << depth << " roughness " << roughness << ": half of the light within x" << width
                << " of its true width, without the bake x" << without << "; " << 100 * share
                << " % of the light where half of it should be, without " << 100 * plain.within(truth.halfWidth())
                << " %\n";
    }
  }
  EXPECT_LT(worst, std::log(1.2));
  EXPECT_LT(worstShare, 0.1);
  EXPECT_GT(worstWithout, std::log(5));
}

TEST_F(TextureBake, LevelsHoldTheShareThatIsThereAndItsColourAlone) {
  // Threads are green, holes red.
  const Image8 image = imageOf(48, 48, [](double u, double v) {
    const bool thread = std::fmod(u * 8, 1.0) < 0.3 || std::fmod(v * 6, 1.0) < 0.2;
    return thread ? glm::vec4(0.1f, 0.8f, 0.2f, 0.9f) : glm::vec4(1, 0, 0, 0.3f);
  });
  for (const bool srgb : {false, true}) {
    const gl::Texture source = upload(image, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8);
    const gl::Texture baked = baker_.coverage({source.get(), {48, 48}}, srgb, 0.5f, CancelToken());
    const auto first = read<std::uint8_t>(baked, 0, {48, 48});
    EXPECT_TRUE(std::ranges::equal(first, image.pixels));
    for (int level = 1; level < 6; ++level) {
      const glm::ivec2 size = sizeAt(image, level);
      const auto pixels = read<std::uint8_t>(baked, level, size);
      for (int i = 0; i < size.x * size.y; ++i) {
        const glm::dvec4 share = meanOver(image, {i % size.x, i / size.x}, size, [&](int x, int y) {
          return glm::dvec4(texelAt(image, x, y).w >= 0.5 ? 1.0 : 0.0);
        });
        const std::uint8_t* got = &pixels[std::size_t(i) * 4];
        EXPECT_NEAR(got[3], share.x * 255, 0.6) << level;
        if (share.x < 0.05) continue;
        EXPECT_NEAR(got[0], 0.1 * 255, 6) << level << " " << share.x;
        EXPECT_NEAR(got[1], 0.8 * 255, 3) << level;
      }
    }
  }
}

/// Gold yarns on red ones, which are the warp: means of colour and metalness alone would make half of the red metal.
TEST_F(TextureBake, LevelsHoldWhatOfTheColourIsMetals) {
  constexpr int SIDE = 32;
  const auto isGold = [](double u, double v) { return std::fmod(u * 8, 1.0) < 0.4 && v > 0.3; };
  const Image8 color = imageOf(SIDE, SIDE, [&](double u, double v) {
    return isGold(u, v) ? glm::vec4(0.9f, 0.7f, 0.3f, 1) : glm::vec4(0.5f, 0.05f, 0.1f, 1);
  });
  const Image8 metalness =
      imageOf(SIDE, SIDE, [&](double u, double v) { return glm::vec4(1, 1, isGold(u, v) ? 0.8f : 0, 1); });
  const Image8 yarns =
      imageOf(SIDE, SIDE, [&](double u, double v) { return glm::vec4(1, 0.5f, 0.5f, u < 0.5 || !isGold(u, v)); });
  const gl::Texture metallic = upload(metalness, GL_RGBA8), weave = upload(yarns, GL_RGBA8);
  for (const bool woven : {false, true}) {
    const gl::Texture source = upload(color, GL_RGBA8);
    const gl::Texture baked =
        baker_.metal({source.get(), {SIDE, SIDE}}, false, {metallic.get(), {SIDE, SIDE}},
                     woven ? pass::BakeSource{weave.get(), {SIDE, SIDE}} : pass::BakeSource{}, 0, CancelToken());
    for (int level = 0; (SIDE >> level) > 0; ++level) {
      const glm::ivec2 size = sizeAt(color, level);
      const auto pixels = read<std::uint8_t>(baked, level, size);
      for (int i = 0; i < size.x * size.y; ++i) {
        const glm::dvec4 mean = meanOver(color, {i % size.x, i / size.x}, size, [&](int x, int y) {
          const double m = texelAt(metalness, x, y).z;
          return m * glm::dvec4(glm::dvec3(texelAt(color, x, y)), woven ? texelAt(yarns, x, y).w : 1.0);
        });
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(pixels[std::size_t(i * 4 + c)], 255 * mean[c], 0.6) << level;
      }
    }
  }
}

TEST_F(TextureBake, MetalOfAnSrgbColourIsAveragedLinearly) {
  const Image8 color = imageOf(8, 8, [](double u, double) { return glm::vec4(u < 0.5 ? 1.0f : 0.2f, 0, 0, 1); });
  const Image8 metalness = imageOf(8, 8, [](double u, double) { return glm::vec4(0, 0, u < 0.5, 1); });
  const gl::Texture source = upload(color, GL_SRGB8_ALPHA8), metallic = upload(metalness, GL_RGBA8);
  const gl::Texture baked = baker_.metal({source.get(), {8, 8}}, true, {metallic.get(), {8, 8}}, {}, 0, CancelToken());
  const auto last = read<std::uint8_t>(baked, 3, {1, 1});
  EXPECT_NEAR(last[0], 188, 1);  // a half, encoded
  EXPECT_NEAR(last[3], 127.5, 1);
}

/// Normals whose slopes are those of a function of the place, [0, 1)^2, +Y up.
template <typename F>
Image8 normalsOf(const F& slopeAt) {
  return imageOf(64, 64, [&](double u, double v) { return normalTexel(slopeAt(glm::dvec2(u, 1 - v))); });
}

double wave(double at) { return std::cos(6 * glm::two_pi<double>() * at); }

TEST_F(TextureBake, TheAxisOfAReliefLiesAcrossItsLines) {
  const auto axisOf = [&](const Image8& image) {
    const gl::Texture source = upload(image, GL_RGBA8);
    return glm::dvec2(baker_.reliefAxis({source.get(), {image.width, image.height}}, CancelToken()));
  };
  for (const double angle : {0.0, 0.4, 0.8, 1.2, -0.9}) {
    const glm::dvec2 across(std::cos(angle), std::sin(angle));
    const glm::dvec2 axis =
        axisOf(normalsOf([&](const glm::dvec2& at) { return across * wave(glm::dot(at, across)); }));
    EXPECT_NEAR(glm::length(axis), 1, 0.02) << angle;
    EXPECT_GT(std::abs(glm::dot(axis, across)), 0.98) << angle;
  }
  const auto allAround = [](const glm::dvec2& at) { return glm::dvec2(wave(at.x), wave(at.y)); };
  EXPECT_LT(glm::length(axisOf(normalsOf(allAround))), 0.06);
  EXPECT_LT(glm::length(axisOf(normalsOf([](const glm::dvec2&) { return glm::dvec2(0); }))), 0.05) << "flat";
}

TEST_F(TextureBake, LevelsThatAreNotReadAreNotMadeAndTheOthersAreAsBefore) {
  const Image8 normals = unevenNormals(32, 4, 0.5), colors = weaveNormals(32, 32, 4, 1);
  const gl::Texture source = upload(normals, GL_RGBA8), other = upload(colors, GL_RGBA8);
  const pass::BakeSource normalMap{source.get(), {32, 32}}, metalness{other.get(), {32, 32}};
  const gl::Texture relief = baker_.normalVariance(normalMap, {}, 0, 0, CancelToken());
  const gl::Texture metal = baker_.metal(metalness, false, normalMap, {}, 0, CancelToken());
  for (const int unread : {1, 3, 5, 255}) {
    const int first = std::min(unread, 5);
    const gl::Texture less = baker_.normalVariance(normalMap, {}, 0, unread, CancelToken());
    const gl::Texture lessMetal = baker_.metal(metalness, false, normalMap, {}, unread, CancelToken());
    for (int level = first; level <= 5; ++level) {
      const glm::ivec2 size(32 >> level);
      EXPECT_EQ(read<float>(less, level - first, size), read<float>(relief, level, size)) << unread << ", " << level;
      EXPECT_EQ(read<std::uint8_t>(lessMetal, level - first, size), read<std::uint8_t>(metal, level, size)) << level;
    }
  }
}

}  // namespace
}  // namespace telar::test
