#pragma once
#include <string>
#include <vector>

#include "image/sample_files.h"

namespace sample {

/// How a .exr file is written.
struct ExrKind {
  std::string compression;  ///< OpenImageIO's name: "none", "zip", ...
  bool isFloat = false;     ///< 32 bits a channel, else 16
  bool isInteger = false;   ///< whole numbers of 32 bits in place of both, and no alpha
  bool isTiled = false;     ///< 16 x 16 px each
  bool isMipmap = false;    ///< with smaller levels behind; tiled
  bool isMultiPart = false;
  bool isDecreasing = false;  ///< the last row first
};

/// A file of R, G, B, A and Z (32 bits) with slopes and noise, by OpenImageIO.
File exrFile(const ExrKind& kind, int width, int height);

/// Every compression in every kind of file.
std::vector<ExrKind> exrKinds();

/// For the messages of tests.
std::string nameOf(const ExrKind& kind);

/// R, G and B of each texel, by OpenImageIO alone.
std::vector<float> texelsByOpenImageIo(const File& file);

}  // namespace sample
