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

constexpr std::array WIDTHS{Width::kSmooth, Width::kRough, Width::kThinFuzz};

/// Direct light at the points of one width.
struct Precision {
  Worst plain, unexplained;  ///< the second: of the points over the bar
  std::uint64_t over = 0;    ///< points over the bar

  void merge(const Precision& other) {
    plain.see(other.plain);
    unexplained.see(other.unexplained);
    over += other.over;
  }
};

/// What one thread found.
struct Found {
  Worst notFinite, negative;        // counts; the last point
  std::array<Precision, 3> direct;  // by Width
  Worst dome, environment;
  std::uint64_t bad = 0, below = 0, woven = 0, seen = 0;

  void merge(const Found& other) {
    for (std::size_t i = 0; i < direct.size(); ++i) direct[i].merge(other.direct[i]);
    dome.see(other.dome);
    environment.see(other.environment);
    if (other.bad) notFinite.point = other.notFinite.point;
    if (other.below) negative.point = other.negative.point;
    bad += other.bad;
    below += other.below;
    woven += other.woven;
    seen += other.seen;
  }
};

constexpr float ROUNDING = -1e-7f;  // of 1 - F where F is 1: nothing that a picture could show

/// A thin film takes more from one channel than there is, as in its source: such a colour may be negative.
bool mayBeNegative(const SurfacePoint& p) { return p.info.iridescence > 0; }

void lookAtDirect(const ShadingPromise& shading, const SurfacePoint& point, std::uint64_t at, const glm::vec3& direct,
                  const glm::dvec3& expected, Found& found) {
  const Width width = widthOf(shading, point);
  Precision& precision = found.direct[static_cast<std::size_t>(width)];
  const double plain = relativeError(direct, expected);
  precision.plain.see(plain, at);
  if (plain <= errorBar(shading, width)) return;
  ++precision.over;
  precision.unexplained.see(unexplainedError(shading.model, point, direct, expected), at);
}

void look(const ShadingPromise& shading, const SurfacePoint& point, std::uint64_t at, Found& found) {
  const Shaded<float> single(shading.model, point.info);
  const brdf_d::SurfaceInfo wide = inDouble(point.info);
  const Shaded<double> exact(shading.model, wide);
  const glm::vec3 direct = single.direct(point.l), dome = single.dome(), environment = single.environment();
  const glm::dvec3 l(point.l), trueDirect = exact.direct(l);
  ++found.seen;
  found.woven += hasYarns(point);
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
  lookAtDirect(shading, point, at, direct, trueDirect, found);
  found.dome.see(relativeError(dome, exact.dome()), at);
  found.environment.see(relativeError(environment, exact.environment()), at);
}

template <class PointAt>
Found lookedAt(const ShadingPromise& shading, std::uint64_t count, PointAt pointAt) {
  std::vector<Found> parts(partCount());
  inParallel(count, [&](std::uint64_t from, std::uint64_t to, unsigned part) {
    for (std::uint64_t i = from; i < to; ++i) look(shading, pointAt(i), i, parts[part]);
  });
  Found all;
  for (const Found& part : parts) all.merge(part);
  return all;
}

/// The rows of one set of points.
template <class PointAt>
class Rows {
 public:
  Rows(const ShadingPromise& shading, std::string set, std::string numbered, std::uint64_t full, const Found& found,
       PointAt pointAt)
      : shading_(shading),
        set_(std::move(set)),
        numbered_(std::move(numbered)),
        full_(full),
        found_(found),
        pointAt_(pointAt) {}

  void add(const std::string& what, const Worst& worst, double bar) {
    const std::string where =
        worst.value > 0 ? numbered_ + " " + std::to_string(worst.point) + ": " + describe(pointAt_(worst.point)) : "";
    list.push_back({what + set_, shading_.name, worst.value, bar, -NO_BAR, found_.seen, where, full_});
  }
  void addCount(const std::string& what, std::uint64_t count, double high, double low = -NO_BAR,
                std::uint64_t last = 0) {
    add(what, {static_cast<double>(count), last}, high);
    list.back().low = low;
    if (high == NO_BAR) list.back().where.clear();
  }
  void addCounts() {
    addCount("points not finite", found_.bad, 0, -NO_BAR, found_.notFinite.point);
    addCount("points below -1e-7", found_.below, 0, -NO_BAR, found_.negative.point);
    // A fourth is less than any of the sets has, and more than a reader that forgets them leaves.
    if (shading_.weaves) addCount("points that show yarns", found_.woven, NO_BAR, static_cast<double>(found_.seen / 4));
  }
  void addIndirect() {
    add("single against double, ambient light", found_.dome, shading_.roughError);
    add("single against double, environment", found_.environment, shading_.roughError);
  }
  std::vector<Figure> list;

 private:
  const ShadingPromise& shading_;
  std::string set_, numbered_;
  std::uint64_t full_;
  const Found& found_;
  PointAt pointAt_;
};

bool isOf(const ShadingPromise& shading, Width width) { return width != Width::kThinFuzz || !shading.robust; }

}  // namespace

std::vector<Figure> checkGrid(const ShadingPromise& shading, Scale scale) {
  // Prime: all digits of the grid's numbers change.
  const std::uint64_t step = scale == Scale::kFull ? 1 : scale == Scale::kQuick ? 37 : 307;
  const auto pointAt = [&](std::uint64_t i) { return gridPoint(shading.model, i * step); };
  const Found found = lookedAt(shading, gridSize() / step, pointAt);
  Rows rows(shading, " on the grid",
            step == 1 ? "grid point" : "of every " + std::to_string(step) + "th grid point, number", gridSize(), found,
            pointAt);
  rows.addCounts();
  for (const Width width : WIDTHS) {
    if (!isOf(shading, width)) continue;
    rows.add(std::string("single against double, direct light, ") + nameOf(width),
             found.direct[static_cast<std::size_t>(width)].plain, errorBar(shading, width));
  }
  rows.addIndirect();
  return rows.list;
}

std::vector<Figure> checkRandom(const ShadingPromise& shading, Scale scale) {
  constexpr std::uint64_t FULL = 10'000'000;
  const auto pointAt = [&](std::uint64_t seed) { return randomPoint(shading.model, seed); };
  const Found found = lookedAt(shading, countOf(scale, 100'000, FULL), pointAt);
  Rows rows(shading, " at random", "seed", FULL, found, pointAt);
  rows.addCounts();
  for (const Width width : WIDTHS) {
    if (!isOf(shading, width)) continue;
    const Precision& precision = found.direct[static_cast<std::size_t>(width)];
    const double bar = errorBar(shading, width);
    rows.add(std::string("single against double, direct light, ") + nameOf(width), precision.plain, NO_BAR);
    if (width == Width::kThinFuzz) continue;
    rows.addCount(std::string("points over the bar of the row below, ") + nameOf(width), precision.over, NO_BAR);
    rows.add(std::string("of their error, what rounded directions do not explain, ") + nameOf(width),
             precision.unexplained, bar);
  }
  rows.addIndirect();
  return rows.list;
}

}  // namespace telar::numerics
