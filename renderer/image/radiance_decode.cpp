#include "image/radiance_decode.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace telar::image {
namespace {

constexpr std::uint32_t RUNS_WIDTH_MIN = 8, RUNS_WIDTH_MAX = 0x7fff;  // of rows that may be run lengths
constexpr std::size_t RUN_MAX = 127, ROW_HEAD = 4;
constexpr std::uint32_t ROWS_BETWEEN_LOOKS = 64;  // at the cancel token

bool mayHaveRuns(std::uint32_t width) { return width >= RUNS_WIDTH_MIN && width <= RUNS_WIDTH_MAX; }

/// Of the shortest file of this size: what is allocated is at most 128 times as long as the file.
std::uint64_t leastBytes(const EnvironmentHeader& header) {
  const std::uint64_t flat = std::uint64_t{header.width} * 4;
  const std::uint64_t runs = ROW_HEAD + 4 * 2 * ((header.width + RUN_MAX - 1) / RUN_MAX);
  return header.height * (mayHaveRuns(header.width) ? std::min(flat, runs) : flat);
}

class RadianceRows {
 public:
  RadianceRows(Bytes file, const EnvironmentHeader& header)
      : file_(file), position_(header.pixels), width_(header.width), row_(std::size_t{header.width} * 4) {}

  /// The next row: all of R, then G, B and the exponents.
  const std::vector<std::uint8_t>& next() {
    const std::uint8_t* head = need(ROW_HEAD);
    if (!mayHaveRuns(width_) || head[0] != 2 || head[1] != 2 || head[2] & 0x80) {
      readFlat();
    } else {
      if (be16(head + 2) != width_) throw damagedEnvironment(".hdr file has a row of another width", position_);
      position_ += ROW_HEAD;
      for (std::size_t channel = 0; channel < 4; ++channel) readRuns(row_.data() + channel * width_);
    }
    return row_;
  }

 private:
  const std::uint8_t* need(std::size_t bytes) const {
    if (file_.size() - position_ < bytes) throw damagedEnvironment(".hdr file ends too early", file_.size());
    return data(file_) + position_;
  }

  void readFlat() {
    const std::uint8_t* texels = need(row_.size());
    for (std::size_t x = 0; x < width_; ++x)
      for (std::size_t channel = 0; channel < 4; ++channel) row_[channel * width_ + x] = texels[x * 4 + channel];
    position_ += row_.size();
  }

  void readRuns(std::uint8_t* channel) {
    for (std::size_t x = 0; x < width_;) {
      const std::uint8_t code = *need(1);
      const bool run = code > 128;
      const std::size_t count = run ? code - 128 : code;
      if (count == 0 || count > width_ - x) throw damagedEnvironment(".hdr file has a run length of no row", position_);
      ++position_;
      const std::uint8_t* values = need(run ? 1 : count);
      if (run)
        std::fill_n(channel + x, count, *values);
      else
        std::copy_n(values, count, channel + x);
      position_ += run ? 1 : count;
      x += count;
    }
  }

  Bytes file_;
  std::size_t position_, width_;
  std::vector<std::uint8_t> row_;
};

/// What a mantissa is multiplied with, exactly, in float; an exponent of 0 is black.
std::array<float, 256> scales() {
  std::array<float, 256> out{};
  for (int exponent = 1; exponent < 256; ++exponent) out[exponent] = std::ldexp(1.0f, exponent - (128 + 8));
  return out;
}

}  // namespace

ImageF decodeRadiance(Bytes file, const EnvironmentHeader& header, const CancelToken& cancel) {
  if (file.size() - header.pixels < leastBytes(header))
    throw damagedEnvironment(".hdr file ends too early", file.size());
  ImageF out{header.width, header.height, std::vector<float>(std::size_t{header.width} * header.height * 4)};
  const std::array<float, 256> scale = scales();
  RadianceRows rows(file, header);
  float* texel = out.pixels.data();
  for (std::uint32_t y = 0; y < header.height; ++y) {
    if (y % ROWS_BETWEEN_LOOKS == 0) cancel.check();
    const std::uint8_t* row = rows.next().data();
    for (std::size_t x = 0; x < header.width; ++x, texel += 4) {
      const float f = scale[row[3 * std::size_t{header.width} + x]];
      for (std::size_t channel = 0; channel < 3; ++channel) texel[channel] = float(row[channel * header.width + x]) * f;
    }
  }
  return out;
}

}  // namespace telar::image
