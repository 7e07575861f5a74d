#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "expect_error.h"
#include "ibl/atlas_prefilter.h"
#include "ibl/environment_cache.h"
#include "ibl/pmrem_file.h"

namespace telar::ibl::atlas_test {
namespace {

namespace fs = std::filesystem;

const std::string KEY(64, 'a');

ThreeTerms termsOf(int prefilter) {
  ThreeTerms three;
  three.prefilter = prefilter;
  return three;
}

const std::vector<int> PREFILTERS{ThreeTerms::THREE_PREFILTER_GGX_CHAIN_INTERPOLATED,
                                  ThreeTerms::THREE_PREFILTER_GGX_CHAIN, ThreeTerms::THREE_PREFILTER_GGX_CHAIN_FLOOR,
                                  ThreeTerms::THREE_PREFILTER_BLUR_FROM_END, ThreeTerms::THREE_PREFILTER_BLUR};

/// Stripes between two radiances.
ImageF stripes(std::uint32_t width, float dark, float bright) {
  ImageF map{width, width / 2, std::vector<float>(static_cast<std::size_t>(width) * width / 2 * 4, dark)};
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    if (i / 4 % 8 < 4) map.pixels[i] = bright;
  }
  return map;
}

float half(std::uint16_t bits) { return std::ldexp(static_cast<float>((bits & 0x3ff) | 0x400), (bits >> 10) - 25); }

/// Calls visit(level, red half) for every texel of a level.
template <class Visit>
void eachTexel(const Atlas& atlas, const std::vector<std::uint16_t>& rgba, Visit visit) {
  for (int level = 0; level < atlas.levels(); ++level) {
    const gl::Pacer::Rectangle tiles = atlas.tilesOf(level);
    for (int y = tiles.y; y < tiles.y + tiles.height; ++y) {
      for (int x = tiles.x; x < tiles.x + tiles.width; ++x)
        visit(level, rgba[static_cast<std::size_t>(y * atlas.width() + x) * 4]);
    }
  }
}

TEST(Atlas, LevelsStandBesideEachOther) {
  const auto context = gl::Context::create(Backend::kAuto);
  const Atlas atlas = createAtlas(*context, 64);
  EXPECT_EQ(atlas.width(), 336);
  EXPECT_EQ(atlas.height(), 256);
  ASSERT_EQ(atlas.levels(), 9);
  std::vector<int> owners(static_cast<std::size_t>(atlas.width()) * static_cast<std::size_t>(atlas.height()), -1);
  int texels = 0;
  for (int level = 0; level < atlas.levels(); ++level) {
    const gl::Pacer::Rectangle tiles = atlas.tilesOf(level);
    ASSERT_TRUE(tiles.x >= 0 && tiles.x + tiles.width <= atlas.width() && tiles.y + tiles.height <= atlas.height());
    for (int y = tiles.y; y < tiles.y + tiles.height; ++y) {
      for (int x = tiles.x; x < tiles.x + tiles.width; ++x) {
        int& owner = owners[static_cast<std::size_t>(y * atlas.width() + x)];
        ASSERT_EQ(owner, -1) << "levels " << owner << " and " << level;
        owner = level;
        ++texels;
      }
    }
  }
  EXPECT_EQ(texels, 6 * (64 * 64 + 32 * 32 + 7 * 16 * 16));
  EXPECT_EQ(atlas.mipOf(atlas.levels() - 1), -2);
}

TEST(Atlas, OfEvenLightIsEvenLight) {
  const auto context = gl::Context::create(Backend::kAuto);
  for (const int prefilter : PREFILTERS) {
    const Atlas atlas = prefilterAtlas(*context, stripes(256, 1, 1), termsOf(prefilter), CancelToken());
    EXPECT_EQ(atlas.faceSize, 64);
    // Weights of the blur are halves, 39 of them in each of 16 passes.
    eachTexel(atlas, readAtlas(*context, atlas), [&](int level, std::uint16_t red) {
      ASSERT_NEAR(half(red), 1, 0.01) << "term " << prefilter << ", level " << level;
    });
  }
}

TEST(Atlas, TheRoughestLevelHasNoStripes) {
  const auto context = gl::Context::create(Backend::kAuto);
  for (const int prefilter : PREFILTERS) {
    const Atlas atlas = prefilterAtlas(*context, stripes(256, 0, 2), termsOf(prefilter), CancelToken());
    float least = 9, most = 0;
    eachTexel(atlas, readAtlas(*context, atlas), [&](int level, std::uint16_t red) {
      if (level != atlas.levels() - 1) return;
      least = std::min(least, half(red));
      most = std::max(most, half(red));
    });
    // Only at the poles, where stripes meet, more than their mean is left of them.
    EXPECT_TRUE(least > 0.8 && most < 1.2) << "term " << prefilter << ": " << least << " to " << most;
  }
}

TEST(Atlas, SlicesChangeNoByteAndCanBeStopped) {
  const auto context = gl::Context::create(Backend::kAuto);
  const ImageF map = stripes(128, 0, 2);
  for (const int prefilter : {ThreeTerms::THREE_PREFILTER_GGX_CHAIN, ThreeTerms::THREE_PREFILTER_BLUR}) {
    const auto texels = [&](double sliceMs) {
      context->pacer().begin(CancelToken(), sliceMs);
      return readAtlas(*context, prefilterAtlas(*context, map, termsOf(prefilter), CancelToken()));
    };
    EXPECT_EQ(texels(1e-9), texels(std::numeric_limits<double>::infinity()));
    const CancelToken cancelled;
    cancelled.cancel();
    context->pacer().begin(cancelled, 50);
    EXPECT_ERROR(prefilterAtlas(*context, map, termsOf(prefilter), CancelToken()), "X_CANCELLED");
    context->pacer().begin(CancelToken(), 50);
    EXPECT_ERROR(prefilterAtlas(*context, map, termsOf(prefilter), cancelled), "X_CANCELLED");
  }
}

TEST(Atlas, IsTheSameWithoutEgl) {
  const auto texels = [](Backend backend, int prefilter) {
    const auto context = gl::Context::create(backend);
    return readAtlas(*context, prefilterAtlas(*context, stripes(128, 0.3f, 2), termsOf(prefilter), CancelToken()));
  };
  for (const int prefilter : {ThreeTerms::THREE_PREFILTER_GGX_CHAIN, ThreeTerms::THREE_PREFILTER_BLUR})
    EXPECT_EQ(texels(Backend::kEglSurfaceless, prefilter), texels(Backend::kOsmesa, prefilter)) << prefilter;
}

TEST(PmremFile, AnAtlasComesBackBitForBit) {
  const auto context = gl::Context::create(Backend::kAuto);
  const Atlas atlas = prefilterAtlas(*context, stripes(128, 0, 2), termsOf(ThreeTerms::THREE_PREFILTER_BLUR), {});
  const auto packed = packPmrem(*context, atlas, KEY);
  const auto back = unpackAtlas(*context, packed, KEY);
  ASSERT_TRUE(back);
  EXPECT_EQ(readAtlas(*context, atlas), readAtlas(*context, *back));
  EXPECT_FALSE(unpackAtlas(*context, packed, "studio"));
  EXPECT_FALSE(unpackPmrem(*context, packed, KEY)) << "an atlas is no cube";
  for (const std::size_t at : {std::size_t{0}, std::size_t{5}, std::size_t{9}, std::size_t{13}, packed.size() - 1}) {
    auto damaged = packed;
    damaged[at] ^= std::byte{0x55};
    EXPECT_FALSE(unpackAtlas(*context, damaged, KEY)) << at;
  }
  EXPECT_FALSE(unpackAtlas(*context, std::span(packed).first(packed.size() / 2), KEY));
}

TEST(AtlasCache, EachReleaseHasItsOwn) {
  const fs::path folder = fs::path(testing::TempDir()) / ("telar-atlas-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto context = gl::Context::create(Backend::kAuto);
  std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 64\n";
  for (int i = 0; i < 4 * 64; ++i) file += {'\x40', '\x40', '\x40', '\x80'};
  Shot::Environment wanted;
  wanted.source = Shot::Environment::Source::kBytes;
  const auto uses = [](const ThreeTerms& three) { return EnvironmentUses{.prefiltered = true, .three = three}; };
  ThreeTerms lowp = termsOf(ThreeTerms::THREE_PREFILTER_BLUR);
  lowp.samplerPrecision = ThreeTerms::THREE_SAMPLER_PRECISION_LOWP;
  const std::vector<ThreeTerms> releases{ThreeTerms(), termsOf(ThreeTerms::THREE_PREFILTER_BLUR), lowp,
                                         termsOf(ThreeTerms::THREE_PREFILTER_GGX_CHAIN)};
  for (const char* expected : {"prefiltered", "disk"}) {
    EnvironmentCache cache(*context, "", {folder, 64u << 20}, Limits{});
    for (const ThreeTerms& three : releases) {
      const auto get = [&]() -> const Environment& {
        return cache.get(wanted, std::as_bytes(std::span(file)), uses(three), CancelToken());
      };
      EXPECT_EQ(get().source, expected) << atlasName(three);
      EXPECT_EQ(get().source, "gpu") << atlasName(three);
      EXPECT_EQ(get().atlas.faceSize, hasAtlas(three) ? 16 : 0);
      EXPECT_EQ(get().prefiltered.faceSize, hasAtlas(three) ? 0 : 256);
      EXPECT_EQ(get().sha256.size(), 64u);
    }
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace telar::ibl::atlas_test
