#pragma once
#include <cstdint>
#include <vector>

#include "ktx2/container.h"
#include "ktx2/huffman.h"
#include "telar/cancel.h"

namespace telar::ktx2 {

/// What all levels of an ETC1S texture share.
struct Etc1sCodebooks {
  /// One colour a block, with its spread.
  struct Endpoint {
    std::uint8_t red, green, blue;  ///< 0..31
    std::uint8_t intensity;         ///< row of the modifier table, 0..7
  };
  /// Rows from the top; two bits a texel, the left one lowest.
  using Selector = std::array<std::uint8_t, 4>;

  std::vector<Endpoint> endpoints;
  std::vector<Selector> selectors;
  HuffmanTable endpointPrediction, endpointDelta, selector, selectorRun;
  std::uint32_t historySize = 0;
};

/// Where the slices of one level lie in its bytes.
struct Etc1sSlices {
  Bytes color;
  Bytes alpha;  ///< empty where the texture has none
};

/// src: KTX 2.0, appendices "BasisLZ Global Data" and "BasisLZ/ETC1S Bitstream".
/// @throws Error{E_IMAGE_CORRUPT}
Etc1sCodebooks readCodebooks(const Container& container);

/// @throws Error{E_IMAGE_CORRUPT}
std::vector<Etc1sSlices> readSlices(const Container& container);

/// A block as indices into the codebooks, both in range.
struct Etc1sBlock {
  std::uint16_t endpoint = 0, selector = 0;
};

/// The blocks of one slice, row by row. @throws Error{E_IMAGE_CORRUPT, X_CANCELLED}
std::vector<Etc1sBlock> decodeSlice(const Etc1sCodebooks& codebooks, Bytes slice, std::uint32_t blocksX,
                                    std::uint32_t blocksY, const CancelToken& cancel);

/// Four colours of an endpoint by selector value. src: Khronos Data Format Specification 1.3, chapter "ETC1S".
std::array<std::array<std::uint8_t, 3>, 4> colorsOf(const Etc1sCodebooks::Endpoint& endpoint);

}  // namespace telar::ktx2
