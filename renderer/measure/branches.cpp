#include "measure/branches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace telar::measure {
namespace {

using surface::Source;

/// Radians of bend that going on into another part costs; half of it where the node or the material stays.
constexpr double OTHER_PART = 1.0;
/// Cuts at one crossing, of which each two are compared. Where there are more, they stay in the order of their faces.
constexpr std::size_t MOST_COMPARED = 12;

double costOfParts(const Source& p, const Source& q) {
  if (p.node == q.node && p.instance == q.instance && p.primitive == q.primitive) return 0;
  return (p.node == q.node && p.instance == q.instance) || p.material == q.material ? OTHER_PART / 2 : OTHER_PART;
}

/// Radians between a way that comes along `p` and goes on along `q`; both lead away from the crossing.
double bend(const glm::dvec3& p, const glm::dvec3& q) {
  const double lengths = glm::length(p) * glm::length(q);
  return lengths > 0 ? std::acos(std::clamp(-glm::dot(p, q) / lengths, -1.0, 1.0)) : std::numbers::pi / 2;
}

/// Sides of cuts, numbered 2 * cut + side, that meet at a crossing: those that go on into one another stand side by side.
std::vector<std::size_t> inPairs(const std::vector<std::size_t>& sides, const std::vector<Cut>& cuts,
                                 const std::vector<Source>& sources) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Cut& one = cuts[sides[i] / 2];
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const Cut& other = cuts[sides[k] / 2];
      const double turn = bend(one.away[sides[i] % 2], other.away[sides[k] % 2]);
      pairs.emplace_back(turn + costOfParts(sources[one.source], sources[other.source]), i, k);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::array<bool, MOST_COMPARED> taken{};
  std::vector<std::size_t> out;
  for (const auto& [cost, i, k] : pairs) {
    if (taken[i] || taken[k]) continue;
    taken[i] = taken[k] = true;
    out.insert(out.end(), {sides[i], sides[k]});
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!taken[i]) out.push_back(sides[i]);
  }
  return out;
}

}  // namespace

void partBranches(std::vector<Cut>& cuts, std::vector<glm::dvec3>& points, const std::vector<Source>& sources,
                  const CancelToken& cancel) {
  std::vector<std::uint32_t> meeting(points.size());
  for (const Cut& cut : cuts) {
    for (const std::uint32_t crossing : cut.crossings) ++meeting[crossing];
  }
  std::map<std::uint32_t, std::vector<std::size_t>> branches;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::uint32_t crossing = cuts[i].crossings[side];
      if (meeting[crossing] > 2 && meeting[crossing] <= MOST_COMPARED) branches[crossing].push_back(2 * i + side);
    }
  }
  for (const auto& [place, sides] : branches) {
    cancel.check();
    const auto ordered = inPairs(sides, cuts, sources);
    for (std::size_t i = 2; i < ordered.size(); ++i) {
      if (i % 2 == 0) points.emplace_back(glm::dvec3(points[place]));
      cuts[ordered[i] / 2].crossings[ordered[i] % 2] = static_cast<std::uint32_t>(points.size() - 1);
    }
  }
}

}  // namespace telar::measure
