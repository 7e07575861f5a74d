#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "renderer/texture_bake.h"

namespace telar::test {
namespace {

/// Round yarns that lie straight: flat along, steep across, each set in its own axis.
TEST_F(TextureBake, LevelsHoldHowFlatWarpAndWeftLieAlongAndAcross) {
  constexpr int SIDE = 32;
  const auto isWarp = [](double u, double) { return std::fmod(u * 4, 1.0) < 0.5; };
  const Image8 normals = imageOf(SIDE, SIDE, [&](double u, double v) {
    const float slope = 0.6f * float(std::sin(glm::two_pi<double>() * 8 * (isWarp(u, v) ? u : v)));
    return glm::vec4(glm::normalize(isWarp(u, v) ? glm::vec3(slope, 0, 1) : glm::vec3(0, slope, 1)) * 0.5f + 0.5f, 1);
  });
  const Image8 yarns = imageOf(SIDE, SIDE, [&](double u, double v) { return glm::vec4(1, 0.5f, 0.5f, isWarp(u, v)); });
  const gl::Texture source = upload(normals, GL_RGBA8), weave = upload(yarns, GL_RGBA8);
  const gl::Texture baked = baker_.yarnRelief({source.get(), {SIDE, SIDE}}, {weave.get(), {SIDE, SIDE}}, CancelToken());
  const auto texel = read<float>(baked, 3, {1, 1});  // of 8 x 8 texels
  const auto squares = [&](int c) { return 0.25 * (0.5 / texel[std::size_t(c)] - 1); };
  std::cout << "mean squares of slopes: warp " << squares(0) << " along, " << squares(1) << " across, weft "
            << squares(2) << ", " << squares(3) << "\n";
  for (const int c : {0, 2}) EXPECT_LT(squares(c), 0.02) << c;  // but where texels of both are blended
  for (const int c : {1, 3}) EXPECT_GT(squares(c), 0.06) << c;
}

/// Warp along x and across it, times its share, then weft.
glm::dvec4 yarnsOf(const glm::dvec4& texel, const glm::dvec4& weave) {
  const auto flat = [](double slope) { return 1 / (1 + 4 * slope * slope); };
  const glm::dvec2 slope = slopeOf(texel), turn = glm::normalize(glm::dvec2(weave) * 2.0 - 1.0);
  const double sine = weave.z * 2 - 1, rise = sine / std::sqrt(1 - sine * sine);
  const double along = glm::dot(slope, turn), aside = slope.y * turn.x - slope.x * turn.y;
  return glm::dvec4(flat(aside - rise) * weave.w, flat(along) * weave.w, flat(along - rise) * (1 - weave.w),
                    flat(aside) * (1 - weave.w));
}

/// Of four points of a texel one is looked at, where sides halve; all four where they do not.
TEST_F(TextureBake, LevelsOfYarnsAreNearTheMeansOverAllPoints) {
  for (const glm::ivec2 size : {glm::ivec2(64, 64), glm::ivec2(44, 31)}) {
    for (const int finer : {1, 2}) {
      const auto at = [](double u, double v) {
        return glm::vec4(0.9, 0.5 + 0.2 * std::sin(glm::two_pi<double>() * 3 * v),
                         0.5 + 0.3 * std::sin(glm::two_pi<double>() * 5 * u), 0.5 + 0.4 * std::cos(u * 19 + v * 7));
      };
      const Image8 normals = weaveNormals(std::uint32_t(size.x), std::uint32_t(size.y), 3.3, 0.9);
      const Image8 fitting = imageOf(normals.width, normals.height, at);
      const Image8 yarns = imageOf(normals.width * std::uint32_t(finer), normals.height * std::uint32_t(finer), at);
      const gl::Texture source = upload(normals, GL_RGBA8), weave = upload(yarns, GL_RGBA8);
      const gl::Texture baked = baker_.yarnRelief({source.get(), size}, {weave.get(), size * finer}, CancelToken());
      const glm::ivec2 levelSize = sizeAt(normals, 2);
      const auto texels = read<float>(baked, 0, levelSize);
      double worst = 0;
      for (int i = 0; i < levelSize.x * levelSize.y; ++i) {
        const glm::dvec4 mean = meanOver(normals, {i % levelSize.x, i / levelSize.x}, levelSize, [&](int x, int y) {
          return meanOverPoints(x, y, [&](const auto& seen) { return yarnsOf(seen(normals), seen(fitting)); });
        });
        for (int c = 0; c < 4; ++c)
          worst = std::max(worst, std::abs(texels[std::size_t(i) * 4 + std::size_t(c)] - mean[c]));
      }
      std::cout << size.x << " x " << size.y << ", weave map " << finer << " times as fine: " << worst << "\n";
      EXPECT_LT(worst, finer == 1 ? 0.035 : 0.05);  // a finer map is blended less between its texels
    }
  }
}

}  // namespace
}  // namespace telar::test
