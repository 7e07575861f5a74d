#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>

#include "brdf/terms.h"

namespace telar::test {
namespace {

// std::uniform_real_distribution differs between libraries; the engine itself does not.
double unit(std::mt19937& engine) { return engine() / 4294967296.0; }

double pick(const Column& column, std::mt19937& engine) {
  if (engine() & 1) return column.extremes[engine() % column.extremes.size()];
  return column.low + (column.high - column.low) * unit(engine);
}

}  // namespace

std::vector<float> samples(const Term& term, std::size_t count) {
  std::vector<float> rows(count * MAX_COLUMNS, 0.0f);
  std::size_t combinations = 1;
  for (const Column& column : term.columns) combinations = std::min(combinations * column.extremes.size(), count + 1);
  if (combinations > count / 2) combinations = 0;
  std::mt19937 engine(20081);
  for (std::size_t row = 0; row < count; ++row) {
    std::size_t code = row;
    for (std::size_t i = 0; i < term.columns.size(); ++i) {
      const Column& column = term.columns[i];
      const double value = row < combinations ? column.extremes[code % column.extremes.size()] : pick(column, engine);
      code /= column.extremes.size();
      rows[row * MAX_COLUMNS + i] = static_cast<float>(value);
    }
  }
  return rows;
}

glm::dvec3 roundingReach(const Term& term, const float* p) {
  double at[MAX_COLUMNS];
  std::copy(p, p + MAX_COLUMNS, at);
  const glm::dvec3 centre = term.inDouble(at);
  glm::dvec3 reach(0);
  for (std::size_t i = 0; i < term.columns.size(); ++i) {
    glm::dvec3 moved(0);
    for (const double step : {-std::ldexp(1.0, -23), std::ldexp(1.0, -23)}) {
      at[i] = p[i] * (1 + step);
      moved = glm::max(moved, glm::abs(term.inDouble(at) - centre));
    }
    at[i] = p[i];
    reach += moved;
  }
  return reach;
}

double excessError(const Term& term, const float* p, const glm::vec3& actual, const glm::dvec3& expected) {
  const glm::dvec3 reach = roundingReach(term, p);
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(actual[i])) return INFINITY;
    const double error = std::max(std::abs(actual[i] - expected[i]) - 4 * reach[i], 0.0);
    worst = std::max(worst, error / std::max(std::abs(expected[i]), term.scale));
  }
  return worst;
}

double relativeError(const Term& term, const glm::vec3& actual, const glm::dvec3& expected) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(actual[i])) return INFINITY;
    worst = std::max(worst, std::abs(actual[i] - expected[i]) / std::max(std::abs(expected[i]), term.scale));
  }
  return worst;
}

std::string readFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<std::string> sharedFiles() {
  std::vector<std::string> files;
  for (const char* list : {"declarations.inl", "definitions.inl"}) {
    std::istringstream in(readFile(std::string(TELAR_SOURCE_DIR "/renderer/brdf/") + list));
    const std::string prefix = "#include \"";
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with(prefix)) files.push_back(line.substr(prefix.size(), line.rfind('"') - prefix.size()));
    }
  }
  return files;
}

std::string sharedText() {
  std::string text;
  for (const std::string& file : sharedFiles()) text += readFile(TELAR_SOURCE_DIR "/shaders/brdf/" + file);
  return text;
}

}  // namespace telar::test
