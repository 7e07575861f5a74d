#pragma once
#include <string>
#include <vector>

#include "ktx2/block_formats.h"
#include "ktx2/byte_reader.h"
#include "ktx2/raw_formats.h"
#include "telar/image.h"
#include "telar/limits.h"

namespace telar::ktx2 {

enum class Payload {
  kEtc1s,  ///< BasisLZ: codebooks and indices
  kUastc,  ///< UASTC LDR 4x4: 16 bytes a block
  kRaw,    ///< uncompressed
  kBlocks  ///< of a GPU, handed to it as they are
};

/// The parts of a KTX2 file that holds one 2D texture of a kind that telar draws; every range lies within the file.
struct Container {
  std::uint32_t width = 0, height = 0;  ///< level 0, texels, at least 1
  Payload payload = Payload::kRaw;
  const RawFormat* raw = nullptr;       ///< kRaw
  const BlockLayout* blocks = nullptr;  ///< kBlocks
  bool zstd = false;                    ///< the levels are compressed by zstd
  bool alphaSlices = false;             ///< kEtc1s: each level has a second slice, its alpha
  TexelCoding coding = TexelCoding::kByUse;
  std::vector<Bytes> levels;  ///< largest first; as compressed as `zstd` says
  Bytes globalData;           ///< kEtc1s: codebooks
};

/// src: KTX File Format Specification 2.0, and Khronos Data Format Specification 1.3 for the descriptor.
/// @throws Error{E_IMAGE_CORRUPT}, and Error{E_IMAGE_FORMAT} that names what the file is where it is not drawn: arrays,
/// cubes, volumes, GPU block formats, other supercompressions; Error{L_IMAGE_DIMENSION} before anything else is read
Container readContainer(Bytes file, const Limits& limits);

/// Whether the bytes start as a KTX2 file does.
bool isKtx2(Bytes file);

/// What the file holds, for people: "KTX2 UASTC zstd".
std::string formatName(const Container& container);

/// Bytes of a level after zstd (not for kEtc1s).
std::uint64_t levelBytes(const Container& container, std::size_t level);

inline std::uint32_t sideOf(std::uint32_t side, std::size_t level) { return side >> level == 0 ? 1 : side >> level; }
/// @param texels of a block's side
inline std::uint32_t blocksOf(std::uint32_t side, std::uint32_t texels = 4) {
  return side / texels + (side % texels != 0);
}

}  // namespace telar::ktx2
