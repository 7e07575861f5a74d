#include <gtest/gtest.h>

#include <filesystem>

#include "flat/truth.h"
#include "telar/load.h"

namespace telar::flat::garments_test {
namespace {

/// A garment of the examples of sheets, seen from one side.
struct Side {
  std::string garment;
  std::string name;
  glm::dvec3 right, back;  ///< unit vectors: of the picture, and to the camera
};

std::ostream& operator<<(std::ostream& out, const Side& side) { return out << side.garment << ' ' << side.name; }

std::vector<Side> allSides() {
  std::vector<Side> sides;
  for (const std::string garment : {"tshirt", "skirt", "jacket"}) {
    sides.push_back({garment, "front", {1, 0, 0}, {0, 0, 1}});
    sides.push_back({garment, "back", {-1, 0, 0}, {0, 0, -1}});
    sides.push_back({garment, "right", {0, 0, -1}, {1, 0, 0}});
    sides.push_back({garment, "left", {0, 0, 1}, {-1, 0, 0}});
  }
  return sides;
}

std::filesystem::path fileOf(const std::string& garment) {
  return garment == "tshirt" ? std::filesystem::path(TELAR_SOURCE_DIR) / "js/assets/tshirt.glb"
                             : std::filesystem::path(TELAR_GARMENTS) / (garment + ".glb");
}

/// Lines against the edges of a z-buffer of the same view.
class Garment : public testing::TestWithParam<Side> {
 protected:
  static constexpr int SIZE = 1200;
  static constexpr double FOLD = 0.008, AHEAD = 10;

  void SetUp() override {
    const auto scene = loadPath(fileOf(GetParam().garment), {}, {});
    surface_ = surface::buildSurface(*scene, {}, {});
    const glm::dvec3 extent = surface_.bounds.max - surface_.bounds.min;
    height_ = 1.1 * std::max({extent.x, extent.y, extent.z});
    middle_ = (surface_.bounds.min + surface_.bounds.max) / 2.0;
    shot_.width = shot_.height = SIZE;
    shot_.camera.projection = Projection::kOrthographic;
    shot_.camera.target = middle_;
    shot_.camera.position = middle_ + AHEAD * GetParam().back;
    shot_.camera.height = height_;
    shot_.camera.near = 1;
    shot_.camera.far = 2 * AHEAD;
    options_.foldDepth = FOLD;
    options_.foldLength = 0.02 * SIZE;
  }

  /// Written anew, so that a fault of View or of its camera shows.
  glm::dvec3 project(const glm::dvec3& p) const {
    const glm::dvec3 from = p - middle_;
    const double pixels = SIZE / height_;
    return {SIZE / 2.0 + glm::dot(from, GetParam().right) * pixels, SIZE / 2.0 - from.y * pixels,
            AHEAD - glm::dot(from, GetParam().back)};
  }

  surface::Surface surface_;
  glm::dvec3 middle_{0};
  double height_ = 0;
  Shot shot_;
  FlatOptions options_;
};

test::Mask moved(const test::Mask& mask, int pixels) {
  test::Mask out(mask.width, mask.height);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = pixels; x < mask.width; ++x) out.at(x, y) = mask.at(x - pixels, y);
  }
  return out;
}

/// Without the pixels of a square about one in the middle of a line.
test::Mask wiped(test::Mask mask, const test::Mask& line, int pixels) {
  std::vector<std::size_t> on;
  for (std::size_t i = 0; i < line.on.size(); ++i) {
    if (line.on[i]) on.push_back(i);
  }
  const int i = static_cast<int>(on.at(on.size() / 2)), x0 = i % mask.width, y0 = i / mask.width;
  for (int y = y0 - pixels / 2; y < y0 + pixels / 2; ++y) {
    for (int x = x0 - pixels / 2; x < x0 + pixels / 2; ++x) {
      if (mask.inside(x, y)) mask.at(x, y) = 0;
    }
  }
  return mask;
}

TEST_P(Garment, LinesAreTheEdgesOfPartsAndDepths) {
  const CancelToken cancel;
  const View view(surface_, shot_, cancel);
  const auto strokes = strokesOf(visiblePieces(surface_, view, options_, cancel), options_, cancel);
  const test::Picture picture(surface_, SIZE, SIZE, [this](const glm::dvec3& p) { return project(p); });
  const auto isSeam = [&](std::size_t i, std::size_t k) { return picture.part[i] != picture.part[k]; };
  const auto isEdge = [&](std::size_t i, std::size_t k) {
    if (isSeam(i, k)) return true;
    if (picture.part[i] < 0) return false;
    // Lines are found by the depths 1.2 pixels apart, and these pixels are one apart. A pressed fold is a line however
    // thin its cloth is: half a millimetre is clear of the meshes' rounding.
    return std::abs(picture.depth[i] - picture.depth[k]) > 0.8 * FOLD || picture.step(i, k) > 5e-4 ||
           glm::dot(picture.normal[i], picture.normal[k]) < std::cos(glm::radians(options_.creaseAngle));
  };
  const test::Mask lines = test::drawn(strokes, SIZE, SIZE, [](Kind) { return true; });
  const test::Mask silhouettes = test::drawn(strokes, SIZE, SIZE, [](Kind kind) { return kind == Kind::kSilhouette; });
  const test::Mask outline = test::rimOf(picture), seams = picture.edges(isSeam), edges = picture.edges(isEdge);
  const double lie = lines.near(edges, 1.5), outlined = outline.near(silhouettes, 1.5), sewn = seams.near(lines, 1.5);
  EXPECT_GE(lie, 0.99);
  EXPECT_GE(outlined, 0.97);
  EXPECT_GE(sewn, 0.97);
  EXPECT_LE(test::widestGap(outline, silhouettes, 1.5), 3);
  RecordProperty("lines", std::to_string(lie));
  RecordProperty("silhouettes", std::to_string(outlined));
  RecordProperty("seams", std::to_string(sewn));
  // Planted: a picture moved by three pixels has its lines beside these, one without seams lacks them, and eight pixels
  // that are wiped out of an outline are a gap.
  EXPECT_LT(moved(lines, 3).near(edges, 1.5), 0.9);
  EXPECT_LT(seams.near(silhouettes, 1.5), 0.97);
  EXPECT_GT(test::widestGap(outline, wiped(silhouettes, outline, 8), 1.5), 3);
}

INSTANTIATE_TEST_SUITE_P(Sides, Garment, testing::ValuesIn(allSides()),
                         [](const auto& of) { return of.param.garment + "_" + of.param.name; });

}  // namespace
}  // namespace telar::flat::garments_test
