#pragma once
#include "brdf/brdf.h"
#include "brdf/terms.h"

/// What the tables of terms are written with: ranges of arguments, scales of results, one row.
namespace telar::test {

inline const Column COSINE{0, 1, {0, 1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.6, 0.9, 1}};
inline const Column SIGNED_COSINE{-1, 1, {-1, -1e-6, 0, 1e-6, 0.5, 1}};
inline const Column ROUGHNESS{0, 1, {0, 0.01, 0.045, 0.089, 0.2, 0.5, 0.8, 1}};
inline const Column ALPHA{0.002025, 1, {0.002025, 0.008, 0.04, 0.25, 0.64, 1}};
inline const Column UNIT{0, 1, {0, 0.02, 0.04, 0.5, 1}};
inline const Column DIELECTRIC{0, 0.5, {0, 0.02, 0.04, 0.16}};
inline const Column GRAZING{0.5, 1, {0.5, 1}};
inline const Column DFG_A{0.3, 0.95, {0.3, 0.6, 0.95}};  // A + B of the table stays within [0.34, 1.0002]
inline const Column DFG_B{0.04, 0.05, {0.04, 0.05}};
inline const Column DERIVATIVE{-0.5, 0.5, {-2, 0, 1e-6, 2}};
inline const Column DIRECTION{-1, 1, {-1, -0.25, 1e-3, 0.5, 1}};
inline const Column UPWARD{0.2, 1, {0.2, 1}};  // both directions on one side: no cancellation in their sum
inline const Column DISTANCE{0, 20, {0, 1e-6, 0.05, 0.1, 1, 8.4, 10, 1e4}};
inline const Column RANGE{0, 20, {0, 1e-3, 10, 1e6}};
inline const Column OUTER_CONE{0, 0.99, {0, 0.5, 0.9}};
inline const Column INNER_CONE{0.9901, 1, {0.995, 1}};
// Below this the rounding of sin^2 is raised to 1 / (2 alpha) > 12: fp32 itself has no more digits there.
inline const Column SHEEN_ALPHA{0.04, 1, {0.04, 0.09, 0.25, 1}};
inline const Column SHEEN_ROUGHNESS{0.2, 1, {0.2, 0.3, 0.5, 1}};
inline const Column SLANT{-0.7, 0.7, {-0.7, 0, 0.7}};  // cosines with tangent and bitangent
inline const Column OFF_GRAZING{0.05, 1, {0.05, 0.5, 1}};
inline const Column FILM_IOR{1, 2.5, {1, 1.3, 2.5}};
inline const Column THICKNESS{0, 1200, {0, 0.01, 100, 400, 1200}};
inline const Column BASE_F0{0, 0.95, {0, 0.02, 0.04, 0.5, 0.95}};
inline const Column PHASE{0, 6.28, {0, 3.14159265}};
inline const Column MAX_LOD{5, 7, {5, 6, 7}};
inline const Column RADIANCE{0, 3, {0, 1e-6, 0.01, 0.08, 0.18, 0.76, 1, 4, 100, 65504, 1e30}};
inline const Column EXPOSURE{0, 4, {0, 1e-3, 1, 16}};
inline const Column DISPLAY{0, 1, {0, 1e-6, 0.0031308, 0.04045, 0.5, 1}};

// Scale of a result that is at most about 1 and a sum of parts of that size: fp32 holds it to some 1e-7, absolute.
inline constexpr double OF_ONE = 0.1;
// Scale of a result that is a product: its error is relative all the way down.
inline constexpr double PRODUCT = 1e-6;

// Scale of the Charlie distribution, whose peak is (2 + 1 / alpha) / (2 PI).
inline constexpr double OF_CHARLIE = 5;

// Scale of AgX's polynomial: its parts are up to 40 and cancel. The GPU tolerance is then a twelfth of an 8-bit code.
inline constexpr double CANCELLING = 16;

#define TERM(name, columns, scale, nonNegative, ...)                     \
  Term {                                                                 \
    name, #__VA_ARGS__, std::vector<Column> columns, scale, nonNegative, \
        +[]([[maybe_unused]] const float*p) {                            \
          using namespace brdf_f;                                        \
          return __VA_ARGS__;                                            \
        },                                                               \
        +[]([[maybe_unused]] const double*p) {                           \
          using namespace brdf_d;                                        \
          return __VA_ARGS__;                                            \
        }                                                                \
  }

}  // namespace telar::test
