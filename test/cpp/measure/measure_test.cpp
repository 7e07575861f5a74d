#include "telar/measure.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "expect_error.h"
#include "measure/shapes.h"
#include "surface/locate.h"

namespace telar::measure::measure_test {
namespace {

using nlohmann::json;

/// A tenth of a millimetre.
constexpr double EXACT = 1e-4;

json list(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

json requestOf(const std::vector<glm::dvec3>& points, const char* along, bool closed = false) {
  json places = json::array();
  for (const glm::dvec3& p : points) places.push_back({{"position", list(p)}});
  return {{"variant", ""},
          {"part", nullptr},
          {"join", 0.0},
          {"ask", {{"kind", "points"}, {"points", places}, {"along", along}, {"closed", closed}}}};
}

double lengthOf(const Scene& scene, const json& request) {
  return json::parse(measureScene(scene, request.dump(), {})).at("length").get<double>();
}

/// A square of one unit, in a node.
Scene squareIn(const glm::dmat4& world) {
  return test::sceneOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3}, world);
}

TEST(MeasureScene, IsInMetresWhateverUnitTheFileIsDrawnIn) {
  // A square of 60 units by 60 whose node takes centimetres, millimetres or inches to metres, turned and moved.
  for (const double unit : {0.01, 0.001, 0.0254, 1.0}) {
    const glm::dmat4 placed =
        glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(2, -1, 0.5)), 0.7, glm::dvec3(1, 2, 3));
    const glm::dmat4 world = glm::scale(placed, glm::dvec3(60 * unit));
    const auto at = [&](double x, double y) { return glm::dvec3(world * glm::dvec4(x, y, 0, 1)); };
    for (const char* along : {"straight", "surface"}) {
      const double length = lengthOf(squareIn(world), requestOf({at(0.1, 0.2), at(0.9, 0.8)}, along));
      EXPECT_NEAR(length, 60 * unit, EXACT * unit) << unit << ", " << along;
    }
  }
}

TEST(MeasureScene, OfANodeThatScalesUnevenlyOrMirrorsItIsTheLengthOfWhatIsDrawn) {
  const Scene scene = squareIn(glm::scale(glm::dmat4(1), glm::dvec3(-0.3, 0.4, 7)));
  for (const char* along : {"straight", "surface"})
    EXPECT_NEAR(lengthOf(scene, requestOf({{0, 0, 0}, {-0.3, 0.4, 0}}, along)), 0.5, EXACT) << along;
}

TEST(MeasureScene, StraightIsFromThePlacesOfTheSurfaceThatAreNearest) {
  const Scene scene = squareIn(glm::dmat4(1));
  EXPECT_NEAR(lengthOf(scene, requestOf({{0.25, 0.5, 0.02}, {0.75, 0.5, -0.03}}, "straight")), 0.5, EXACT);
  EXPECT_NEAR(lengthOf(scene, requestOf({{-1, 0.5, 0}, {0.5, 0.5, 0}}, "straight")), 0.5, EXACT);
}

TEST(MeasureScene, AClosedOneComesBack) {
  const Scene scene = squareIn(glm::dmat4(1));
  const std::vector<glm::dvec3> corner{{0.1, 0.1, 0}, {0.4, 0.1, 0}, {0.4, 0.5, 0}};
  EXPECT_NEAR(lengthOf(scene, requestOf(corner, "straight")), 0.7, EXACT);
  EXPECT_NEAR(lengthOf(scene, requestOf(corner, "straight", true)), 1.2, EXACT);
}

TEST(MeasureScene, PointsOnDifferentPartsAreJoinedStraightAndAlongTheSurfaceWhereTheOptionClosesTheGap) {
  // Two squares of a metre, a gap of 2 mm between them.
  const Scene scene = test::sceneOf(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.002f, 0, 0}, {2.002f, 0, 0}, {2.002f, 1, 0}, {1.002f, 1, 0}},
      {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7});
  const std::vector<glm::dvec3> ends{{0.5, 0.5, 0}, {1.502, 0.5, 0}};
  EXPECT_NEAR(lengthOf(scene, requestOf(ends, "straight")), 1.002, EXACT);
  json along = requestOf(ends, "surface");
  EXPECT_ERROR(measureScene(scene, along.dump(), {}), "E_MEASURE");
  along["join"] = 0.003;
  // The points of the second part that move by the gap take the surface with them.
  EXPECT_NEAR(lengthOf(scene, along), 1.002, 0.0021);
}

/// The faces a second time, wound the other way, as files have it that give each side of a cloth its own.
Scene doubled(const Scene& scene) {
  const Primitive& primitive = scene.meshes[0].primitives[0];
  std::vector<std::uint32_t> indices(primitive.indices.begin(), primitive.indices.end());
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    for (const std::size_t k : {2u, 1u, 0u}) indices.push_back(primitive.indices[i + k]);
  }
  return test::sceneOf({primitive.positions.begin(), primitive.positions.end()}, indices);
}

TEST(MeasureScene, OverASurfaceThatIsThereTwiceIsThatOverOne) {
  // Fine enough that windows which go on into each of two faces at each edge would be more than are allowed.
  const Scene tube = test::sheet(48, 20, 0, [](double u, double v) {
    const double phi = 2 * std::numbers::pi * u, r = (0.2 - 0.06 * v) * (1 + 0.06 * std::sin(5 * phi + 3 * v));
    return glm::dvec3(r * std::cos(phi), 0.6 * v, r * std::sin(phi));
  });
  const json asked = requestOf({{0, 0.02, 0.2}, {0.2, 0.5, 0.05}}, "surface");
  EXPECT_NEAR(lengthOf(doubled(tube), asked), lengthOf(tube, asked), 1e-12);
}

TEST(MeasureScene, ATriangleOfASurfaceThatIsThereTwiceIsWhereItWasNamed) {
  const Scene one = squareIn(glm::dmat4(1)), two = doubled(one);
  // Triangle 2 is triangle 0 wound the other way: its first corner is the other's last.
  json asked = requestOf({{0.5, 0.5, 0}}, "straight");
  asked["ask"]["points"] = {
      {{"node", 0}, {"primitive", 0}, {"triangle", 0}, {"weights", {0.2, 0.7, 0.1}}},
      {{"node", 0}, {"primitive", 0}, {"triangle", 2}, {"weights", {0.1, 0.7, 0.2}}},
  };
  const json told = json::parse(measureScene(two, asked.dump(), {}));
  EXPECT_NEAR(told.at("length").get<double>(), 0, 1e-12);
  EXPECT_EQ(told.at("points").at(1).at("triangle"), 2);
  EXPECT_EQ(told.at("points").at(1).at("weights"), json({0.1, 0.7, 0.2}));
  EXPECT_ERROR(measureScene(one, asked.dump(), {}), "E_MEASURE");
}

TEST(NearestPlace, IsTheNearestOfAllTriangles) {
  const surface::Surface cloth = surface::buildSurface(
      test::sheet(17, 13, 0.49,
                  [](double u, double v) {
                    return glm::dvec3(u, v, 0.06 * std::sin(11 * u + 3 * v) + 0.04 * std::sin(5 * u - 17 * v));
                  }),
      {}, {});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-0.2, 1.2);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p(any(random), any(random), 0.3 * any(random));
    double least = 1e9;
    for (const surface::Face& face : cloth.faces) {
      const glm::dvec3 &a = cloth.corner(face, 0), &b = cloth.corner(face, 1), &c = cloth.corner(face, 2);
      const glm::dvec3 w = surface::nearestWeights(p, a, b, c);
      const glm::dvec3 at = w.x * a + w.y * b + w.z * c;
      EXPECT_GE(std::min({w.x, w.y, w.z}), -1e-12);
      least = std::min(least, glm::distance(p, at));
      // No step within the triangle comes nearer.
      for (const glm::dvec3& corner : {a, b, c})
        EXPECT_GE(glm::distance(p, glm::mix(at, corner, 1e-3)), glm::distance(p, at) - 1e-12);
    }
    EXPECT_NEAR(surface::nearestPlace(cloth, p, {}).distance, least, 1e-12);
  }
}

}  // namespace
}  // namespace telar::measure::measure_test
