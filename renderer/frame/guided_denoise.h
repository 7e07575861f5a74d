#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace telar::frame {

/// A picture of few passes, its noise, and a guide: the same picture without noise, whose light is an approximation.
/// Row 0 on top; linear Rec.709, premultiplied with coverage, and coverage; 1 = white.
struct GuidedPicture {
  int width = 0, height = 0;
  std::vector<glm::vec4> mean;
  /// Half of the difference between the means of the two halves of the passes, which is as large as the error of `mean`:
  /// of the colour, not premultiplied; of the coverage.
  std::span<const glm::vec4> apart;
  std::span<const glm::vec4> guide;
  std::span<const std::uint32_t> passes;  ///< that each pixel has
  bool asksError = true;
};

struct Denoised {
  std::vector<glm::vec4> picture;  ///< as the mean; its coverage is the mean's, but of nets
  /// Standard error that is left: of the luminance, not premultiplied; of the coverage. Empty where nobody asks.
  std::vector<glm::vec2> error;
};

/// Splits the difference of the mean to the guide into bands (taps 1, 2 and 4 pixels apart, and the rest), estimates the
/// noise of each band about a pixel, and adds the part of the band that is no noise to the guide. So light, which the
/// guide has wrong and which is smooth, comes from many pixels of the mean; detail comes from the guide, or from the mean
/// where the two differ by more than noise. Pixels that one of the two does not cover, or brighter than BRIGHTEST (times
/// the median of the guide, where that is above white), are the mean's: a sun would spread over its neighbours.
/// src: Holschneider et al. 1989, "A Real-Time Algorithm for Signal Analysis with the Help of the Wavelet Transform"
///      (a trous, with a cubic B-spline); Mihcak, Kozintsev & Ramchandran 1999, "Spatially Adaptive Statistical
///      Modeling of Wavelet Image Coefficients" (the gain of a band)
Denoised denoise(GuidedPicture picture);

/// Far above white, which is 1.
constexpr float BRIGHTEST = 16;

}  // namespace telar::frame
