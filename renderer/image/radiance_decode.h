#pragma once
#include "image/environment_header.h"
#include "telar/cancel.h"
#include "telar/codec.h"

namespace telar::image {

/// R, G and B of a .hdr file: mantissa / 256 * 2^(exponent - 128) (Ward 1991, "Real Pixels"), row 0 on top. A is left
/// 0. A row is flat, or has run lengths a channel. Run lengths of whole texels, which Radiance wrote before, are read
/// as texels, as three.js does.
/// @param header  of the file, and allowed by the limits
/// @throws Error{E_ENVIRONMENT_CORRUPT, X_CANCELLED}
ImageF decodeRadiance(Bytes file, const EnvironmentHeader& header, const CancelToken& cancel);

}  // namespace telar::image
