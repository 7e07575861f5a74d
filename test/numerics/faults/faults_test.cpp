// The suite's own test: with a fault planted in the text of the shadings, or in the suite, the check that is to find it
// fails; without it, it holds. And every bar of every check is missed by some fault.
#include "faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "check.h"
#include "planted.h"

namespace telar::numerics {
namespace {

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = readFaults(TELAR_FAULTS);
  return all;
}

const Check& checkOf(const std::string& name) {
  static const std::vector<Check> all = allChecks();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Check& check) { return check.name == name; });
  if (found == all.end()) throw std::runtime_error("there is no check " + name);
  return *found;
}

class Planted {
 public:
  explicit Planted(int fault) { plantedFault = fault; }
  ~Planted() { plantedFault = 0; }
  Planted(const Planted&) = delete;
  Planted& operator=(const Planted&) = delete;
};

/// What a check says of the text without a fault, measured once.
const std::vector<Figure>& soundFigures(const std::string& check) {
  static std::map<std::string, std::vector<Figure>> measured;
  const auto found = measured.find(check);
  return found != measured.end() ? found->second
                                 : measured.emplace(check, checkOf(check).run(Scale::kLeast)).first->second;
}

/// A figure's name without the scene that it is of: rows of one kind differ by that alone.
std::string kindOf(const Check& check, const Figure& figure) {
  return check.topic == "Extremes, drawn" ? figure.what.substr(figure.what.find(": ") + 2) : figure.what;
}

std::string said(const Figure& f) {
  return f.what + ": " + std::to_string(f.measured) + ", bar " + std::to_string(f.low) + " .. " +
         std::to_string(f.high);
}

/// A fault, and one of the checks that find it.
struct Case {
  int number;
  const Fault* fault;
  const Finder* finder;

  friend void PrintTo(const Case& one, std::ostream* out) { *out << one.fault->name; }
};

std::vector<Case> cases() {
  std::vector<Case> list;
  for (std::size_t i = 0; i < faults().size(); ++i)
    for (const Finder& finder : faults()[i].finders) list.push_back({static_cast<int>(i) + 1, &faults()[i], &finder});
  return list;
}

std::string nameOf(const testing::TestParamInfo<Case>& tested) {
  std::string name = tested.param.fault->name + " " + tested.param.finder->check;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

class NumericsFaults : public testing::TestWithParam<Case> {};

TEST_P(NumericsFaults, IsFound) {
  const auto& [number, fault, finder] = GetParam();
  const Check& check = checkOf(finder->check);
  for (const Figure& figure : soundFigures(check.name)) EXPECT_TRUE(figure.holds()) << "without it, " << said(figure);
  const Planted planted(number);
  std::set<std::string> off;
  for (const Figure& figure : check.run(Scale::kLeast))
    if (!figure.holds() && off.insert(kindOf(check, figure)).second) std::printf("%s\n", said(figure).c_str());
  EXPECT_FALSE(finder->fails.empty());
  for (const std::string& what : finder->fails) EXPECT_TRUE(off.count(what)) << what << " holds with the fault";
}

INSTANTIATE_TEST_SUITE_P(All, NumericsFaults, testing::ValuesIn(cases()), nameOf);

/// First word of a check's name; the second is the shading, and each shading goes through the same code.
std::string kindOf(const std::string& check) { return check.substr(0, check.find(' ')); }

TEST(NumericsFaultsOfAll, EveryBarIsMissedBySomeFault) {
  std::map<std::string, std::set<std::string>> found, checksOf;
  for (const Case& one : cases()) {
    found[kindOf(one.finder->check)].insert(one.finder->fails.begin(), one.finder->fails.end());
    checksOf[kindOf(one.finder->check)].insert(one.finder->check);
  }
  for (const Check& check : allChecks())
    EXPECT_TRUE(checksOf.count(kindOf(check.name))) << "no fault is planted for " << check.name;
  for (const auto& [kind, checks] : checksOf) {
    for (const std::string& check : checks) {
      for (const Figure& figure : soundFigures(check)) {
        if (figure.high == NO_BAR && figure.low == -NO_BAR) continue;
        EXPECT_TRUE(found[kind].count(kindOf(checkOf(check), figure)))
            << "no fault that is planted for " << kind << " moves \"" << figure.what << "\" off its bar";
      }
    }
  }
}

}  // namespace
}  // namespace telar::numerics
