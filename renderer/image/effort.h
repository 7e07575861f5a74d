#pragma once
#include <array>
#include <cstddef>

namespace telar::image {

/// What `output.effort` is on the scales of the libraries.
struct EffortLevels {
  int libdeflate;    ///< 0 to 12, PNG
  bool allFilters;   ///< of PNG: five a row in place of Sub and Up
  int zlib;          ///< 0 to 9, PNG with a profile
  int webpLossless;  ///< 0 to 9
  int webpMethod;    ///< 0 to 6, lossy WebP
  int tiff;          ///< 1 to 9; 0 = not compressed
  int exr;           ///< 1 to 9; 0 = not compressed
  bool ownHuffman;   ///< JPEG has tables of its own picture
  bool progressive;  ///< JPEG
};

/// By effort. The default is 1: test/bench/encode.mjs has the figures.
constexpr std::array<EffortLevels, 10> EFFORT_LEVELS = {{
    {0, false, 0, 0, 0, 0, 0, false, false},
    {1, false, 1, 1, 2, 2, 4, true, false},
    {3, false, 2, 2, 3, 3, 5, true, false},
    {5, true, 3, 3, 4, 4, 6, true, false},
    {6, true, 4, 4, 4, 5, 7, true, false},
    {7, true, 5, 5, 5, 6, 8, true, true},
    {8, true, 6, 6, 5, 7, 9, true, true},
    {9, true, 7, 7, 6, 8, 9, true, true},
    {10, true, 8, 8, 6, 9, 9, true, true},
    {12, true, 9, 9, 6, 9, 9, true, true},
}};

/// @param effort  0 to 9
constexpr const EffortLevels& levelsOf(int effort) { return EFFORT_LEVELS[static_cast<std::size_t>(effort)]; }

}  // namespace telar::image
