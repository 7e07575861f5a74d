#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>

#include "image/effort.h"
#include "image/encoders.h"

namespace telar::image {
namespace {

// Filter types. src: W3C 2003, "Portable Network Graphics", 9.2
enum Filter : std::uint8_t { kNone, kSub, kUp, kAverage, kPaeth };
constexpr std::uint32_t ROWS_PER_STEP = 64;  // between two looks at the cancel token

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

void append32(std::vector<std::byte>& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(std::byte(value >> shift));
}

/// Writes length, type, data and CRC; `fill` appends the data.
template <class Fill>
void appendChunk(std::vector<std::byte>& out, std::string_view type, const Fill& fill) {
  const std::size_t start = out.size();
  append32(out, 0);
  for (const char c : type) out.push_back(std::byte(c));
  fill();
  const std::size_t length = out.size() - start - 8;
  for (int i = 0; i < 4; ++i) out[start + i] = std::byte(length >> (24 - 8 * i));
  append32(out, libdeflate_crc32(0, out.data() + start + 4, length + 4));
}

/// Sum of the residuals' magnitudes as signed bytes: the usual estimate of what deflate will make of a row.
std::uint32_t cost(const std::uint8_t* residuals, std::size_t count) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += std::uint32_t(std::abs(std::int8_t(residuals[i])));
  return sum;
}

/// Of the bytes to the left (a), above (b) and above to the left (c), the one that a + b - c is nearest to.
int paeth(int a, int b, int c) {
  const int left = std::abs(b - c), up = std::abs(a - c), both = std::abs(a + b - 2 * c);
  return left <= up && left <= both ? a : up <= both ? b : c;
}

/// A row less what `foretell` makes of the bytes to the left, above, and above to the left.
template <class Foretell>
void applyFilter(const std::uint8_t* row, const std::uint8_t* above, std::size_t pixelBytes,
                 std::vector<std::uint8_t>& out, const Foretell& foretell) {
  for (std::size_t i = 0; i < pixelBytes; ++i) out[i] = std::uint8_t(row[i] - foretell(0, above[i], 0));
  for (std::size_t i = pixelBytes; i < out.size(); ++i)
    out[i] = std::uint8_t(row[i] - foretell(row[i - pixelBytes], above[i], above[i - pixelBytes]));
}

void applyFilter(Filter filter, const std::uint8_t* row, const std::uint8_t* above, std::size_t pixelBytes,
                 std::vector<std::uint8_t>& out) {
  const auto apply = [&](const auto& foretell) { applyFilter(row, above, pixelBytes, out, foretell); };
  switch (filter) {
    case kNone:
      return apply([](int, int, int) { return 0; });
    case kSub:
      return apply([](int left, int, int) { return left; });
    case kUp:
      return apply([](int, int up, int) { return up; });
    case kAverage:
      return apply([](int left, int up, int) { return (left + up) / 2; });
    case kPaeth:
      return apply(paeth);
  }
}

/// Rows as PNG wants them before compression: a filter byte, then the row as the cheapest of the filters has it.
std::vector<std::uint8_t> filterRows(const std::vector<std::uint8_t>& rows, std::size_t rowBytes,
                                     std::size_t pixelBytes, bool allFilters, const CancelToken& cancel) {
  const std::size_t height = rows.size() / rowBytes;
  std::vector<std::uint8_t> out(height * (rowBytes + 1)), best(rowBytes), tried(rowBytes);
  const std::vector<std::uint8_t> zeros(rowBytes);
  for (std::size_t y = 0; y < height; ++y) {
    if (y % ROWS_PER_STEP == 0) cancel.check();
    const std::uint8_t* row = rows.data() + y * rowBytes;
    const std::uint8_t* above = y ? row - rowBytes : zeros.data();
    Filter chosen = kSub;
    applyFilter(kSub, row, above, pixelBytes, best);
    std::uint32_t least = cost(best.data(), rowBytes);
    for (const Filter filter : {kUp, kAverage, kPaeth, kNone}) {
      if (filter != kUp && !allFilters) break;
      applyFilter(filter, row, above, pixelBytes, tried);
      const std::uint32_t own = cost(tried.data(), rowBytes);
      if (own >= least) continue;
      least = own;
      chosen = filter;
      std::swap(best, tried);
    }
    std::uint8_t* to = out.data() + y * (rowBytes + 1);
    to[0] = chosen;
    std::copy_n(best.data(), rowBytes, to + 1);
  }
  return out;
}

/// Appends a zlib stream; deflate by libdeflate, which is faster than zlib and whose bytes do not depend on the
/// machine.
void appendDeflated(std::vector<std::byte>& out, const std::vector<std::uint8_t>& plain, int level) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(level));
  if (!compressor) throw std::bad_alloc();
  const std::size_t start = out.size();
  out.resize(start + libdeflate_zlib_compress_bound(compressor.get(), plain.size()));
  out.resize(start + libdeflate_zlib_compress(compressor.get(), plain.data(), plain.size(), out.data() + start,
                                              out.size() - start));
}

std::vector<std::uint8_t> rowsOf(const Frame& frame, bool wide) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(frame.pixels.data());
  const std::size_t count = frame.pixels.size();
  std::vector<std::uint8_t> rows(count * (wide ? 2 : 1));
  if (!wide) std::copy_n(from, count, rows.begin());
  for (std::size_t i = 0; wide && i < count; ++i) rows[2 * i] = rows[2 * i + 1] = from[i];
  return rows;
}

}  // namespace

std::vector<std::byte> encodePng(const Frame& frame, const OutputOptions& options, const CancelToken& cancel) {
  const bool wide = options.bitDepth == 16;
  return encodePngRows({frame.width, frame.height, options.bitDepth, 4, true, options.ppi, options.effort},
                       rowsOf(frame, wide), cancel);
}

std::vector<std::byte> encodePngRows(const PngRows& png, const std::vector<std::uint8_t>& rows,
                                     const CancelToken& cancel) {
  constexpr std::string_view SIGNATURE = "\x89PNG\r\n\x1a\n";
  constexpr double INCH = 0.0254;  // metres
  constexpr int GREY = 0, RGB = 2, RGBA = 6;
  const std::size_t pixelBytes = static_cast<std::size_t>(png.channels * png.bitDepth / 8);
  const EffortLevels& levels = levelsOf(png.effort);
  const auto filtered = filterRows(rows, png.width * pixelBytes, pixelBytes, levels.allFilters, cancel);
  const int colorType = png.channels == 1 ? GREY : png.channels == 3 ? RGB : RGBA;

  std::vector<std::byte> out;
  for (const char c : SIGNATURE) out.push_back(std::byte(c));
  appendChunk(out, "IHDR", [&] {
    append32(out, png.width);
    append32(out, png.height);
    for (const int b : {png.bitDepth, colorType, 0, 0, 0}) out.push_back(std::byte(b));
  });
  if (png.srgb) appendChunk(out, "sRGB", [&] { out.push_back(std::byte{0}); });  // perceptual intent
  if (png.ppi > 0) {
    appendChunk(out, "pHYs", [&] {
      const auto perMetre = std::uint32_t(std::lround(png.ppi / INCH));
      append32(out, perMetre);
      append32(out, perMetre);
      out.push_back(std::byte{1});
    });
  }
  appendChunk(out, "IDAT", [&] { appendDeflated(out, filtered, levels.libdeflate); });
  appendChunk(out, "IEND", [] {});
  cancel.check();
  return out;
}

}  // namespace telar::image
