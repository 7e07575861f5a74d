#pragma once
#include <limits>
#include <span>
#include <vector>

#include "frame/guided_denoise.h"
#include "frame/linear_output.h"
#include "telar/image.h"
#include "telar/shot.h"

namespace telar::frame {

/// Averages the passes over a picture. A pixel whose standard error is small enough takes no more of them.
class PixelMean {
 public:
  static constexpr unsigned FEWEST = 16;  ///< passes before a pixel is looked at, where they are scattered

  /// @param shot  its size, output and noise    @param exposed  whether the passes are, by its exposure
  /// @param measures  whether standardError() is wanted of a shot without noise to stop at
  /// @param fewest  passes before a pixel is looked at, a power of 2
  explicit PixelMean(const Shot& shot, bool exposed = true, bool measures = false, unsigned fewest = FEWEST);

  /// The mean is joined with this from now on, and the error is what that leaves: denoise().
  /// @param picture  row 0 on top; linear Rec.709, premultiplied with coverage, and coverage, exposed as the passes are
  void setGuide(std::vector<glm::vec4> picture);

  /// Adds a pass to the pixels that are not settled. Where that makes `fewest` of them, twice, four times ... as many,
  /// those are settled whose standard error, as the two halves of their passes differ there and in their neighbours, is
  /// Shot::noise or less.
  /// @param frame  kRgbaF32 of the shot's size    @param last  no pass follows: nothing is settled any more
  /// @param passes  that the frame is the sum of; a power of two is not passed by, but reached
  /// @return whether pixels were looked at
  bool add(const Frame& frame, bool last = false, unsigned passes = 1);

  /// Which pixels are settled: 255 or 0, row 0 on top. Empty before they are looked at.
  std::span<const std::uint8_t> settled() const { return settled_; }
  bool allSettled() const { return left_ == 0; }
  /// Mean over the pixels that are not the same in both halves, in 1/255 of encoded luma, as of the last look; infinity
  /// before it, and 0 where all are.
  double standardError() const { return standardError_; }

  /// Row 0 on top; linear Rec.709, premultiplied with coverage, and coverage. Joined with the guide from 8 passes on.
  std::vector<glm::vec4> mean() const;
  /// It as the shot's output.
  Frame frame() const { return toFrame(mean(), shot_); }

 private:
  void look();
  /// Squares of the standard error of each pixel that is not settled, in encoded luma.
  std::vector<float> squaresOfHalves() const;
  std::vector<float> squaresOfDenoised();
  void settle(std::vector<float> squares);
  glm::vec2 difference(std::size_t pixel, const PixelEncoder& encoded) const;
  void setHalvesApart();
  std::vector<glm::vec4> plainMean() const;
  Denoised denoised(bool asksError) const;

  Shot shot_;
  bool measures_;
  unsigned fewest_;
  unsigned passes_ = 0;
  std::size_t left_;
  std::vector<glm::vec4> first_, second_;  ///< sums of the two halves of a pixel's passes
  std::vector<std::uint32_t> count_;
  std::vector<std::uint8_t> settled_;
  std::vector<float> error_;              ///< standard error of a pixel, in encoded luma
  std::vector<glm::vec4> guide_, apart_;  ///< GuidedPicture
  std::vector<glm::vec4> joined_;         ///< with the guide, until the next pass; empty = not known
  double standardError_ = std::numeric_limits<double>::infinity();
};

}  // namespace telar::frame
