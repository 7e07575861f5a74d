#pragma once
#include "image/bytes.h"
#include "image/exr_header.h"
#include "telar/cancel.h"

namespace telar::image {

/// Checks that the first part's picture is all there: its tables, and each chunk of the first level, its place, its
/// length, and that it unpacks to as many bytes as its rows have. OpenEXR 3.1 takes a chunk that unpacks to fewer, and
/// shows what lay in the memory behind them. It counts itself what PXR24 and B44 unpack to.
/// @throws Error{E_ENVIRONMENT_FORMAT, E_ENVIRONMENT_CORRUPT}
void checkExrChunks(Bytes file, const ExrFile& exr, const CancelToken& cancel);

}  // namespace telar::image
