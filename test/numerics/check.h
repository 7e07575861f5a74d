#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// The invariants of the shadings as measured figures: asserted by the tests at a reduced count, and tabled by
/// `npm run numerics` at the full one.
namespace telar::numerics {

/// How much a check looks at.
enum class Scale { kLeast, kQuick, kFull };

/// `quick` in the tests, `full` for the tables; an eighth of `quick`, and 1 at least, where a fault is to be found.
constexpr std::uint64_t countOf(Scale scale, std::uint64_t quick, std::uint64_t full) {
  return scale == Scale::kFull ? full : scale == Scale::kQuick || quick < 8 ? quick : quick / 8;
}

constexpr double NO_BAR = std::numeric_limits<double>::infinity();

/// One measured number.
struct Figure {
  std::string what;     ///< quantity, with its unit where it has one
  std::string shading;  ///< empty where it is not of one shading
  double measured = 0;  ///< the worst of all points
  double high = NO_BAR;
  double low = -NO_BAR;
  std::uint64_t points = 0;  ///< looked at, counted
  std::string where;         ///< of the worst: enough to find it again
  /// Points that the table names, at Scale::kFull; 0: any run looks at all of them.
  std::uint64_t full = 0;

  bool isComplete() const { return points >= full; }
  bool holds() const { return measured <= high && measured >= low; }
};

struct Check {
  std::string topic;  ///< heading of its table
  std::string name;   ///< unique, for --only and the names of the tests
  std::function<std::vector<Figure>(Scale)> run;
};

/// Every check, by topic.
std::vector<Check> allChecks();

}  // namespace telar::numerics
