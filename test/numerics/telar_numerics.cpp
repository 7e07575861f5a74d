// telar_numerics [--full] [--only NAME]: runs the checks whose name contains NAME and prints one JSON object a line for
// each, as it is done. Exit status 1 where a figure is outside of its bar.
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
          {"where", f.where},     {"holds", f.holds()}};
}

}  // namespace

int main(int argc, char** argv) {
  auto scale = telar::numerics::Scale::kQuick;
  std::string only;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--full") == 0) {
      scale = telar::numerics::Scale::kFull;
    } else if (std::strcmp(argv[i], "--only") == 0 && i + 1 < argc) {
      only = argv[++i];
    } else {
      return std::fputs("usage: telar_numerics [--full] [--only NAME]\n", stderr), 2;
    }
  }
  bool hold = true;
  for (const telar::numerics::Check& check : telar::numerics::allChecks()) {
    if (check.name.find(only) == std::string::npos) continue;
    const auto started = std::chrono::steady_clock::now();
    nlohmann::ordered_json json{{"topic", check.topic}, {"name", check.name}, {"figures", nlohmann::json::array()}};
    for (const Figure& figure : check.run(scale)) {
      json["figures"].push_back(toJson(figure));
      hold &= figure.holds();
    }
    json["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    std::cout << json.dump() << std::endl;
  }
  return hold ? 0 : 1;
}
