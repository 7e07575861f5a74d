#include "measure/branches.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace telar::measure {
namespace {

using surface::Source;

/// Radians of bend that going on into another part costs; half of it where the node or the material stays.
constexpr double OTHER_PART = 1.0;
/// Cuts at one crossing, of which each two are compared. Where there are more, they stay in the order of their faces.
constexpr std::size_t MOST_COMPARED = 32;

double costOfParts(const Source& p, const Source& q) {
  if (p.node == q.node && p.instance == q.instance && p.primitive == q.primitive) return 0;
  return (p.node == q.node && p.instance == q.instance) || p.material == q.material ? OTHER_PART / 2 : OTHER_PART;
}

/// Radians between a way that comes along `p` and goes on along `q`; both lead away from the crossing.
double bend(const glm::dvec3& p, const glm::dvec3& q) {
  const double lengths = glm::length(p) * glm::length(q);
  return lengths > 0 ? std::acos(std::clamp(-glm::dot(p, q) / lengths, -1.0, 1.0)) : 0;
}

/// Sides of cuts that meet at a crossing, numbered 2 * cut + side: those that go on into one another stand side by side.
std::vector<std::size_t> inPairs(const std::vector<std::size_t>& sides, const std::vector<Cut>& cuts,
                                 const std::vector<glm::dvec3>& points, const std::vector<Source>& sources) {
  const auto away = [&](std::size_t side) {
    const auto& [from, to] = cuts[side / 2].crossings;
    return side % 2 == 0 ? points[to] - points[from] : points[from] - points[to];
  };
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      pairs.emplace_back(bend(away(sides[i]), away(sides[k])) +
                             costOfParts(sources[cuts[sides[i] / 2].source], sources[cuts[sides[k] / 2].source]),
                         sides[i], sides[k]);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::size_t> out;
  const auto isLeft = [&out](std::size_t side) { return std::find(out.begin(), out.end(), side) == out.end(); };
  for (const auto& [cost, p, q] : pairs) {
    if (isLeft(p) && isLeft(q)) out.insert(out.end(), {p, q});
  }
  for (const std::size_t side : sides) {
    if (isLeft(side)) out.push_back(side);
  }
  return out;
}

}  // namespace

void partBranches(std::vector<Cut>& cuts, std::vector<glm::dvec3>& points, const std::vector<Source>& sources,
                  const CancelToken& cancel) {
  std::vector<std::vector<std::size_t>> at(points.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    for (std::size_t side = 0; side < 2; ++side) at[cuts[i].crossings[side]].push_back(2 * i + side);
  }
  for (const auto& sides : at) {
    if (sides.size() <= 2 || sides.size() > MOST_COMPARED) continue;
    cancel.check();
    const auto ordered = inPairs(sides, cuts, points, sources);
    for (std::size_t i = 2; i < ordered.size(); ++i) {
      std::uint32_t& crossing = cuts[ordered[i] / 2].crossings[ordered[i] % 2];
      if (i % 2 == 0) points.emplace_back(glm::dvec3(points[crossing]));
      crossing = static_cast<std::uint32_t>(points.size() - 1);
    }
  }
}

}  // namespace telar::measure
