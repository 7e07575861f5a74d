#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// One table of every shading term, for all sides that evaluate it: C++ float, C++ double, the GPU.
namespace telar::test {

/// Values that one argument takes: the extremes, and anything between low and high.
struct Column {
  double low, high;
  std::vector<double> extremes;
};

constexpr std::size_t MAX_COLUMNS = 12;

/// A term as a function of plain numbers, giving 3 of them (a scalar is repeated).
struct Term {
  std::string name;
  std::string expression;       ///< in `p`, an array of MAX_COLUMNS floats; the same text in GLSL and in C++
  std::vector<Column> columns;  ///< what p[0], p[1], ... may be
  double scale;                 ///< size of the result below which an error counts as absolute
  bool nonNegative;
  glm::vec3 (*inFloat)(const float* p);
  glm::dvec3 (*inDouble)(const double* p);
};

const std::vector<Term>& terms();

/// Arguments of a term: `count` rows of MAX_COLUMNS numbers, unused ones 0. All combinations of the extremes come first
/// when they fit in half of the rows; the other rows take an extreme or any value between, each half of the time.
/// The same numbers on every machine.
std::vector<float> samples(const Term& term, std::size_t count);

/// How far rounding alone may move the result: the change, per component, when each argument moves by one fp32 ulp.
glm::dvec3 roundingReach(const Term& term, const float* p);

/// Error of `actual` against `expected` beyond 4 times roundingReach, relative to the larger of |expected| and the
/// term's scale; the largest of the 3 components. Not finite when `actual` is not.
double excessError(const Term& term, const float* p, const glm::vec3& actual, const glm::dvec3& expected);

/// Plain error, relative to the larger of |expected| and the term's scale.
double relativeError(const Term& term, const glm::vec3& actual, const glm::dvec3& expected);

/// Text of shaders/brdf in order of need, as renderer/brdf includes it.
std::string sharedText();

/// Files of that text, in order.
std::vector<std::string> sharedFiles();

/// @throws std::runtime_error when the file cannot be read.
std::string readFile(const std::string& path);

}  // namespace telar::test
