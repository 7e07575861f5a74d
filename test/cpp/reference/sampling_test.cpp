#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/brdf.h"
#include "core/random.h"
#include "reference/sphere.h"

/// Directions come as often as their pdf says, and the pdf is one whole.
namespace telar::reference {
namespace {

constexpr float TWO_PI = 6.2831853f;
constexpr int HEIGHTS = 16, SECTORS = 24;  // bins of the sphere of equal solid angle

int binOf(const glm::vec3& l) {
  const int height = std::min(static_cast<int>((l.z + 1) / 2 * HEIGHTS), HEIGHTS - 1);
  const float turn = std::atan2(l.y, l.x) / TWO_PI + 0.5f;
  return height * SECTORS + std::min(static_cast<int>(turn * SECTORS), SECTORS - 1);
}

/// Integral of the pdf over each bin.
template <class Pdf>
std::vector<double> expectedShares(Pdf pdf) {
  constexpr int FINE = 24;  // a side, a bin
  std::vector<double> shares(HEIGHTS * SECTORS);
  for (int h = 0; h < HEIGHTS * FINE; ++h) {
    for (int s = 0; s < SECTORS * FINE; ++s) {
      const double z = -1 + 2 * (h + 0.5) / (HEIGHTS * FINE), phi = TWO_PI * ((s + 0.5) / (SECTORS * FINE) - 0.5);
      const double radius = std::sqrt(1 - z * z);
      const glm::vec3 l(glm::dvec3(radius * std::cos(phi), radius * std::sin(phi), z));
      shares[static_cast<std::size_t>(h / FINE * SECTORS + s / FINE)] +=
          static_cast<double>(pdf(l)) * 2 * TWO_PI / (HEIGHTS * FINE * SECTORS * FINE);
    }
  }
  return shares;
}

template <class Draw, class Pdf>
void expectDrawnAsOftenAsThePdfSays(Draw draw, Pdf pdf, const std::string& what) {
  constexpr int COUNT = 400000;
  std::vector<double> drawn(HEIGHTS * SECTORS);
  Random random(1, 2, 3);
  for (int i = 0; i < COUNT; ++i) drawn[static_cast<std::size_t>(binOf(draw(random.uniform2())))] += 1;
  const std::vector<double> expected = expectedShares(pdf);
  double whole = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    whole += expected[i];
    const double sigma = std::sqrt(std::max(expected[i], 1e-6) / COUNT);
    // Five sigma over a few hundred bins, and half a percent of the bin for the quadrature of the pdf.
    EXPECT_NEAR(drawn[i] / COUNT, expected[i], 5 * sigma + 0.005 * expected[i] + 1e-5) << what << " bin " << i;
  }
  EXPECT_NEAR(whole, 1, 2e-3) << what;
}

TEST(Sampling, CosineDirectionsFollowTheirPdf) {
  expectDrawnAsOftenAsThePdfSays([](glm::vec2 u) { return brdf_f::sampleCosine(u); },
                                 [](const glm::vec3& l) { return brdf_f::pdfCosine(l.z); }, "cosine");
}

TEST(Sampling, EvenDirectionsFollowTheirPdf) {
  expectDrawnAsOftenAsThePdfSays([](glm::vec2 u) { return brdf_f::sampleHemisphere(u); },
                                 [](const glm::vec3& l) { return brdf_f::pdfHemisphere(l.z); }, "hemisphere");
}

TEST(Sampling, ReflectionsAboutVisibleNormalsFollowTheirPdf) {
  for (const glm::vec2 alpha : {glm::vec2(0.3f), glm::vec2(1.0f), glm::vec2(0.9f, 0.3f), glm::vec2(0.25f, 0.8f)}) {
    for (const float cosine : {0.15f, 0.6f, 1.0f}) {
      const glm::vec3 v(std::sqrt(1 - cosine * cosine) * 0.8f, std::sqrt(1 - cosine * cosine) * 0.6f, cosine);
      expectDrawnAsOftenAsThePdfSays(
          [&](glm::vec2 u) { return brdf_f::sampleReflection(v, alpha, u); },
          [&](const glm::vec3& l) { return brdf_f::pdfReflection(v, l, alpha); },
          "alpha " + std::to_string(alpha.x) + " " + std::to_string(alpha.y) + " NoV " + std::to_string(cosine));
    }
  }
}

TEST(Sampling, BasisIsSquareForEveryNormal) {
  Random random(5, 0, 0);
  for (int i = 0; i < 10000; ++i) {
    const glm::vec3 n = i == 0 ? glm::vec3(0, 0, -1) : sampleSphere(random.uniform2());
    const glm::mat3 m = brdf_f::basisAbout(n), product = glm::transpose(m) * m;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) EXPECT_NEAR(product[a][b], a == b ? 1 : 0, 2e-6f);
    }
    EXPECT_GT(glm::determinant(m), 0.99f);
  }
}

TEST(Random, StreamsAreTheSameEachTimeAndApartFromEachOther) {
  Random a(7, 11, 0), again(7, 11, 0), other(7, 12, 0), later(7, 11, 1);
  int same = 0;
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const float x = a.uniform();
    EXPECT_EQ(x, again.uniform());
    same += (x == other.uniform()) + (x == later.uniform());
    sum += x;
  }
  EXPECT_LT(same, 5);
  EXPECT_NEAR(sum / 10000, 0.5, 0.01);
}

// Sobol's points are a net: of 2^k each rectangle of area 2^-k, however long and narrow, holds one. A wrong bit of
// either dimension puts two into one.
TEST(Random, PointsOfSobolAreThoseOfTheSequence) {
  EXPECT_EQ(Random::sobolPoint(0), glm::vec2(0, 0));
  EXPECT_EQ(Random::sobolPoint(1), glm::vec2(0.5, 0.5));
  EXPECT_EQ(Random::sobolPoint(2), glm::vec2(0.25, 0.75));
  EXPECT_EQ(Random::sobolPoint(3), glm::vec2(0.75, 0.25));
  EXPECT_EQ(Random::sobolPoint(4), glm::vec2(0.125, 0.625));
}

TEST(Random, PairsOfAPixelFillEveryRectangleEvenly) {
  constexpr int BITS = 8, COUNT = 1 << BITS;
  std::vector<glm::vec2> points;
  for (std::uint32_t i = 0; i < COUNT; ++i) points.push_back(Random(5, 3, i).uniform2());
  for (int across = 0; across <= BITS; ++across) {
    const int columns = 1 << across, rows = COUNT / columns;
    std::vector<int> held(COUNT, 0);
    for (const glm::vec2& p : points) {
      ++held[static_cast<std::size_t>(static_cast<int>(p.y * static_cast<float>(rows)) * columns +
                                      static_cast<int>(p.x * static_cast<float>(columns)))];
    }
    EXPECT_EQ(std::count(held.begin(), held.end(), 1), COUNT) << columns << " columns";
  }
}

}  // namespace
}  // namespace telar::reference
