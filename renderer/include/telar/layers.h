#pragma once
#include "telar/cancel.h"
#include "telar/codec.h"
#include "telar/image.h"

namespace telar {

/// Least and largest depth that is there; {0, 0} where none is, and of every other layer.
struct DepthRange {
  float min = 0, max = 0;
};
DepthRange depthRange(const LayerImage& depth);

/// Encodes one layer of a frame as output.layers says. PNG holds whole numbers v of 0 to m = 255 or 65535: numbers as
/// they are; depths min + (v - 1) / (m - 1) * (max - min) with 0 for none; normals 2 v / m - 1 with 0 0 0 for none;
/// albedo sRGB-encoded v / m; all others v / m. EXR and raw hold floats.
/// @throws Error{X_OUTPUT, X_LIBRARY_MISSING, X_CANCELLED}
std::vector<std::byte> encodeLayer(const Frame& frame, const LayerImage& layer, const OutputOptions& output,
                                   const CancelToken& cancel);

/// One EXR file of the colour and all layers, channels named "depth.Z" and so on.
/// @throws Error{X_OUTPUT, X_LIBRARY_MISSING, X_CANCELLED}
std::vector<std::byte> encodeTogether(const Frame& frame, const OutputOptions& output, const CancelToken& cancel);

}  // namespace telar
