#pragma once
#include "ktx2/byte_reader.h"
#include "telar/cancel.h"
#include "telar/codec.h"

/// KTX2 textures: a container of 2D images with their mip levels, in ETC1S or UASTC (Basis Universal) or uncompressed.
namespace telar::ktx2 {

bool isKtx2(Bytes file);

/// Checks the container and gives its size, as decode() will. @throws Error{E_IMAGE_CORRUPT, E_IMAGE_FORMAT,
/// L_IMAGE_DIMENSION}
ImageHeader readHeader(Bytes file, const Limits& limits);

/// Decodes every level to RGBA as three.js's KTX2Loader has it uncompressed: 8-bit, or floats where the file has more.
/// An uncompressed file's levels are those of the file, and smaller ones are black (MissingLevels). A texture of blocks
/// with a single level is as large as its blocks, as the loader makes it: sides are rounded up to multiples of 4.
/// @throws Error{E_IMAGE_CORRUPT, E_IMAGE_FORMAT, L_IMAGE_DIMENSION, X_LIBRARY_MISSING, X_CANCELLED}
Image8 decode(Bytes file, const Limits& limits, const CancelToken& cancel);

}  // namespace telar::ktx2
