#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace telar::frame {

/// The difference of two pictures, and noise that is as large as the error of the difference. Row by row.
struct NoisyField {
  NoisyField(int columns, int rows);
  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  int width, height;
  std::vector<float> weight;             ///< of each value, 0..1; 0 = there is none
  std::vector<glm::vec4> excess, noise;  ///< linear Rec.709, and 1 where there is a value
};

struct Shrunk {
  std::vector<glm::vec3> excess;  ///< that stands out of the noise
  std::vector<float> left;        ///< square of the error of its luminance
};

/// Splits the excess into bands (taps 1, 2, 4 ... apart, and the rest) and multiplies each by its gain: 1 less the ratio of
/// the energy of the noise to that of the band, both as means about a value, and 0 at least.
/// @param field  is taken apart: its weights stay
/// @param bands  1 to MOST_BANDS
/// src: Holschneider et al. 1989, "A Real-Time Algorithm for Signal Analysis with the Help of the Wavelet Transform"
///      (a trous, with a cubic B-spline); Mihcak, Kozintsev & Ramchandran 1999, "Spatially Adaptive Statistical
///      Modeling of Wavelet Image Coefficients"
Shrunk shrink(NoisyField& field, int bands);

/// Mean energy of the noise about each value, some pixels wide.
std::vector<float> noiseEnergies(const NoisyField& field);

/// With MOST_BANDS bands, values farther away than this have no part in a result. A field may be cut anywhere at multiples of FIELD_GRID.
constexpr int MOST_BANDS = 4, FIELD_REACH = 144, FIELD_GRID = 16;

}  // namespace telar::frame
