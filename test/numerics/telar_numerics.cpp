// telar_numerics [--full] [--check NAME | --only PART]: runs the check of that name, or those whose name contains PART,
// and prints one JSON object a line for each, as it is done. Exit status 1 where a figure is outside of its bar, 3
// where one at
// --full looked at fewer points than its table names. --list prints the checks without running them.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>

#include "check.h"

namespace {

using telar::numerics::Figure;

/// null where there is no bar; a string where the number is not finite, which JSON has no way to say.
nlohmann::json number(double value) {
  if (std::abs(value) == telar::numerics::NO_BAR) return nullptr;
  return value;
}

nlohmann::ordered_json toJson(const Figure& f) {
  return {{"what", f.what},       {"shading", f.shading},   {"measured", number(f.measured)},
          {"low", number(f.low)}, {"high", number(f.high)}, {"points", f.points},
          {"full", f.full},       {"where", f.where},       {"holds", f.holds()}};
}

struct Options {
  telar::numerics::Scale scale = telar::numerics::Scale::kQuick;
  std::string check, part;
  bool list = false;

  bool wants(const std::string& name) const {
    return check.empty() ? name.find(part) != std::string::npos : name == check;
  }
};

/// False where the arguments are none that it knows.
bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--full") == 0) {
      options.scale = telar::numerics::Scale::kFull;
    } else if (std::strcmp(argv[i], "--list") == 0) {
      options.list = true;
    } else if (std::strcmp(argv[i], "--check") == 0 && i + 1 < argc) {
      options.check = argv[++i];
    } else if (std::strcmp(argv[i], "--only") == 0 && i + 1 < argc) {
      options.part = argv[++i];
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options))
    return std::fputs("usage: telar_numerics [--list] [--full] [--check NAME | --only PART]\n", stderr), 2;
  const bool full = options.scale == telar::numerics::Scale::kFull;
  bool hold = true, complete = true;
  for (const telar::numerics::Check& check : telar::numerics::allChecks()) {
    if (!options.wants(check.name)) continue;
    nlohmann::ordered_json json{{"topic", check.topic}, {"name", check.name}};
    if (!options.list) {
      const auto started = std::chrono::steady_clock::now();
      json["figures"] = nlohmann::json::array();
      for (const Figure& figure : check.run(options.scale)) {
        json["figures"].push_back(toJson(figure));
        hold &= figure.holds();
        complete &= !full || figure.isComplete();
      }
      json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    }
    std::cout << json.dump() << std::endl;
  }
  return !complete ? 3 : hold ? 0 : 1;
}
