// Every shading at very many points: finite, not negative, and the same in single and in double precision.
#include <array>

#include "checks.h"
#include "evaluate.h"
#include "precision.h"
#include "shadings.h"
#include "surface_point.h"
#include "worst.h"

namespace telar::numerics {
namespace {

/// What one thread found.
struct Found {
  Worst notFinite, negative;    // counts; the last point
  std::array<Worst, 3> direct;  // by Width
  Worst dome, environment;
  std::uint64_t bad = 0, below = 0;

  void merge(const Found& other) {
    for (std::size_t i = 0; i < direct.size(); ++i) direct[i].see(other.direct[i]);
    dome.see(other.dome);
    environment.see(other.environment);
    if (other.bad) notFinite.point = other.notFinite.point;
    if (other.below) negative.point = other.negative.point;
    bad += other.bad;
    below += other.below;
  }
};

constexpr float ROUNDING = -1e-7f;  // of 1 - F where F is 1: nothing that a picture could show

/// A thin film takes more from one channel than there is, as in its source: such a colour may be negative.
bool mayBeNegative(const SurfacePoint& p) { return p.info.iridescence > 0; }

void look(const ShadingPromise& shading, const SurfacePoint& point, std::uint64_t at, bool grid, Found& found) {
  const Shaded<float> single(shading.model, point.info);
  const brdf_d::SurfaceInfo wide = inDouble(point.info);
  const Shaded<double> exact(shading.model, wide);
  const glm::vec3 direct = single.direct(point.l), dome = single.dome(), environment = single.environment();
  const glm::dvec3 l(point.l), trueDirect = exact.direct(l);
  const bool finite = isFinite(direct) && isFinite(dome) && isFinite(environment) && isFinite(trueDirect) &&
                      isFinite(exact.dome()) && isFinite(exact.environment());
  if (!finite) {
    ++found.bad;
    found.notFinite.point = at;
    return;
  }
  if (!mayBeNegative(point) && (least(direct) < ROUNDING || least(dome) < ROUNDING || least(environment) < ROUNDING ||
                                least(trueDirect) < ROUNDING)) {
    ++found.below;
    found.negative.point = at;
  }
  const double error =
      grid && shading.robust ? relativeError(direct, trueDirect) : directError(shading, point, direct, trueDirect);
  found.direct[static_cast<std::size_t>(widthOf(shading, point))].see(error, at);
  found.dome.see(relativeError(dome, exact.dome()), at);
  found.environment.see(relativeError(environment, exact.environment()), at);
}

template <class PointAt>
std::vector<Figure> figuresOf(const ShadingPromise& shading, std::uint64_t count, bool grid, PointAt pointAt) {
  std::vector<Found> parts(partCount());
  inParallel(count, [&](std::uint64_t from, std::uint64_t to, unsigned part) {
    for (std::uint64_t i = from; i < to; ++i) look(shading, pointAt(i), i, grid, parts[part]);
  });
  Found all;
  for (const Found& part : parts) all.merge(part);
  const auto where = [&](std::uint64_t i) {
    return std::string(grid ? "grid point " : "seed ") + std::to_string(i) + ": " + describe(pointAt(i));
  };
  const std::string of = grid ? " on the grid" : " at random";
  std::vector<Figure> out;
  const auto add = [&](const std::string& what, double measured, double bar, std::uint64_t at) {
    out.push_back({what + of, shading.name, measured, bar, -NO_BAR, count, measured > 0 ? where(at) : ""});
  };
  add("points not finite", static_cast<double>(all.bad), 0, all.notFinite.point);
  add("points below -1e-7", static_cast<double>(all.below), 0, all.negative.point);
  for (const Width width : {Width::kSmooth, Width::kRough, Width::kThinFuzz}) {
    const Worst& worst = all.direct[static_cast<std::size_t>(width)];
    if (width == Width::kThinFuzz && shading.robust) continue;
    add(std::string("single against double, direct light, ") + nameOf(width), worst.value, errorBar(shading, width),
        worst.point);
  }
  add("single against double, ambient light", all.dome.value, shading.roughError, all.dome.point);
  add("single against double, environment", all.environment.value, shading.roughError, all.environment.point);
  return out;
}

}  // namespace

std::vector<Figure> checkGrid(const ShadingPromise& shading, Scale scale) {
  const std::uint64_t step = countOf(scale, 37, 1);  // prime: all digits of the grid's numbers change
  return figuresOf(shading, gridSize() / step, true,
                   [&](std::uint64_t i) { return gridPoint(shading.model, i * step); });
}

std::vector<Figure> checkRandom(const ShadingPromise& shading, Scale scale) {
  return figuresOf(shading, countOf(scale, 100'000, 10'000'000), false,
                   [&](std::uint64_t seed) { return randomPoint(shading.model, seed); });
}

}  // namespace telar::numerics
