#pragma once
#include "ktx2/byte_reader.h"

namespace telar::ktx2 {

/// Decompresses a Zstandard frame into exactly `out.size()` bytes; never writes beyond, whatever the frame says.
/// libzstd is loaded by the first call, and by nothing else.
/// @throws Error{E_IMAGE_CORRUPT, X_LIBRARY_MISSING}
void decompressZstd(Bytes frame, std::span<std::uint8_t> out);

}  // namespace telar::ktx2
