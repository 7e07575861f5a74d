#include "image/exr_chunks.h"

#include <algorithm>
#include <string>
#include <vector>

#include "image/environment_header.h"
#include "image/exr_dwa.h"
#include "image/exr_huffman.h"
#include "image/exr_unpack.h"

namespace telar::image {
namespace {

constexpr std::uint64_t TABLE_ENTRY_BYTES = 8;      // of a table of chunks
constexpr std::uint64_t TILE_BYTES_MAX = 64 << 20;  // 2,048 x 2,048 of four floats

std::int64_t rowsOfChunk(ExrCompression compression) {
  switch (compression) {
    case ExrCompression::kNone:
    case ExrCompression::kRle:
    case ExrCompression::kZips:
      return 1;
    case ExrCompression::kZip:
    case ExrCompression::kPxr24:
      return 16;
    case ExrCompression::kDwab:
      return 256;
    default:
      return 32;
  }
}

std::uint64_t divideUp(std::uint64_t a, std::uint64_t b) { return a / b + (a % b != 0); }

/// Tiles along one side of one level.
std::uint64_t tilesAlong(std::uint64_t side, std::uint32_t tile, unsigned level, bool roundUp) {
  const std::uint64_t length = roundUp ? divideUp(side, std::uint64_t{1} << level) : side >> level;
  return divideUp(std::max<std::uint64_t>(length, 1), tile);
}

unsigned levelCount(std::uint64_t side, bool roundUp) {
  unsigned levels = 1;
  while (side >> levels) ++levels;
  const bool isPower = (side & (side - 1)) == 0;
  return levels + (roundUp && !isPower);
}

/// Entries of a part's table: the first level's, and those of all levels.
struct TableSize {
  std::uint64_t first = 0, all = 0;
};

TableSize tableOf(const ExrPart& part) {
  const auto width = static_cast<std::uint64_t>(part.width), height = static_cast<std::uint64_t>(part.height);
  if (!part.isTiled) {
    const std::uint64_t chunks = divideUp(height, static_cast<std::uint64_t>(rowsOfChunk(part.compression)));
    return {chunks, chunks};
  }
  const ExrTiles& tiles = part.tiles;
  const auto across = [&](unsigned level) { return tilesAlong(width, tiles.width, level, tiles.roundUp); };
  const auto down = [&](unsigned level) { return tilesAlong(height, tiles.height, level, tiles.roundUp); };
  TableSize size{across(0) * down(0), 0};
  if (tiles.levels == ExrTiles::Levels::kOne) size.all = size.first;
  if (tiles.levels == ExrTiles::Levels::kMipmap) {
    const unsigned levels = levelCount(std::max(width, height), tiles.roundUp);
    for (unsigned level = 0; level < levels; ++level) size.all += across(level) * down(level);
  }
  if (tiles.levels == ExrTiles::Levels::kRipmap) {
    for (unsigned x = 0; x < levelCount(width, tiles.roundUp); ++x)
      for (unsigned y = 0; y < levelCount(height, tiles.roundUp); ++y) size.all += across(x) * down(y);
  }
  return size;
}

std::uint64_t le64(const std::uint8_t* p) { return std::uint64_t{le32(p + 4)} << 32 | le32(p); }

/// A chunk's texels, and its packed bytes with where they lie.
struct Chunk {
  std::int64_t width, height;
  Bytes packed;
  std::size_t begin, end;
};

class Walk {
 public:
  Walk(Bytes file, const ExrFile& exr) : file_(file), exr_(exr), part_(exr.parts.front()) {
    for (const ExrChannel& channel : part_.channels) texelBytes_ += bytesOf(channel.type);
  }

  void tables() {
    std::uint64_t entries = 0;
    for (const ExrPart& part : exr_.parts) {
      entries += tableOf(part).all;
      if (entries > (file_.size() - exr_.tables) / TABLE_ENTRY_BYTES)
        throw damagedEnvironment(".exr file is shorter than its table of chunks", file_.size());
    }
    // One that is 0 makes OpenEXR look for the chunks of all parts, other ones than stand here.
    for (std::uint64_t i = 0; i < entries; ++i)
      if (entry(i) == 0) throw damagedEnvironment(".exr file was not written to its end: it lacks chunks", place(i));
  }

  void rows(const CancelToken& cancel) {
    const std::int64_t step = rowsOfChunk(part_.compression);
    const std::uint64_t chunks = tableOf(part_).first;
    std::size_t before = 0;
    for (std::uint64_t n = 0; n < chunks; ++n) {
      cancel.check();
      const std::uint64_t i = part_.isDecreasing ? chunks - 1 - n : n;
      const auto row = static_cast<std::int64_t>(i) * step;
      const Chunk chunk =
          chunkAt(i, {static_cast<std::uint32_t>(part_.top + row)}, part_.width, std::min(step, part_.height - row));
      // OpenEXR reads on where the last one ended, wherever the table says that the next one is.
      if (!exr_.isMultiPart && before != 0 && chunk.begin != before)
        throw damagedEnvironment(".exr file has its chunks in another order than it says", place(i));
      before = chunk.end;
      check(chunk);
    }
  }

  void tiles(const CancelToken& cancel) {
    const std::int64_t width = part_.tiles.width, height = part_.tiles.height;
    checkTileSize();
    std::uint64_t i = 0;
    for (std::int64_t y = 0; y < part_.height; y += height) {
      for (std::int64_t x = 0; x < part_.width; x += width, ++i) {
        cancel.check();
        check(chunkAt(i, {static_cast<std::uint32_t>(x / width), static_cast<std::uint32_t>(y / height), 0, 0},
                      std::min(width, part_.width - x), std::min(height, part_.height - y)));
      }
    }
  }

 private:
  /// OpenEXR takes memory for whole tiles, also where the map ends within the first one.
  void checkTileSize() const {
    const std::uint64_t map = static_cast<std::uint64_t>(part_.width * part_.height) * texelBytes_;
    const std::uint64_t texels = std::uint64_t{part_.tiles.width} * part_.tiles.height;
    if (texels > std::max(map, TILE_BYTES_MAX) / std::max<std::uint64_t>(texelBytes_, 1))
      throw damagedEnvironment(".exr header has tiles that are far larger than its map", 0);
  }

  std::size_t place(std::uint64_t i) const { return exr_.tables + static_cast<std::size_t>(i * TABLE_ENTRY_BYTES); }
  std::uint64_t entry(std::uint64_t i) const { return le64(data(file_) + place(i)); }

  /// @param where  the numbers that stand before its length, behind the number of the part
  Chunk chunkAt(std::uint64_t i, const std::vector<std::uint32_t>& where, std::int64_t width,
                std::int64_t height) const {
    const std::uint64_t offset = entry(i);
    const std::size_t numbers = (exr_.isMultiPart ? 1 : 0) + where.size() + 1;
    if (offset < exr_.tables || offset > file_.size() || file_.size() - offset < 4 * numbers)
      throw damagedEnvironment(".exr file has a chunk outside the file", place(i));
    const auto begin = static_cast<std::size_t>(offset), at = begin + 4 * numbers;
    const std::uint8_t* number = data(file_) + begin;
    bool isRight = true;
    if (exr_.isMultiPart) isRight = le32(number) == 0, number += 4;
    for (const std::uint32_t one : where) isRight = isRight && le32(number) == one, number += 4;
    const std::uint32_t bytes = le32(number);
    if (!isRight) throw damagedEnvironment(".exr file has a chunk in the place of another", begin);
    if (bytes > file_.size() - at) throw damagedEnvironment(".exr file is cut", file_.size());
    return {width, height, file_.subspan(at, bytes), begin, at + bytes};
  }

  void check(const Chunk& chunk) {
    const std::uint64_t whole = texelBytes_ * static_cast<std::uint64_t>(chunk.width * chunk.height);
    // Packed bytes that are no fewer are taken as they are.
    if (chunk.packed.size() >= whole) return;
    if (!unpacks(chunk, whole))
      throw damagedEnvironment(".exr file has a chunk that does not fill its rows", chunk.begin);
  }

  bool unpacks(const Chunk& chunk, std::uint64_t whole) {
    if (chunk.packed.empty()) return false;
    switch (part_.compression) {
      case ExrCompression::kNone:
        return false;
      case ExrCompression::kRle:
        return runsGive(chunk.packed, whole);
      case ExrCompression::kZips:
      case ExrCompression::kZip:
        return inflater_.gives(chunk.packed, whole);
      case ExrCompression::kDwaa:
      case ExrCompression::kDwab:
        return dwa_.fills(chunk.packed, part_.channels, static_cast<std::uint64_t>(chunk.width),
                          static_cast<std::uint64_t>(chunk.height));
      case ExrCompression::kPiz:
        return unpacksPiz(chunk.packed, static_cast<std::size_t>(whole / 2));
      default:  // OpenEXR refuses what is too short or too long: ImfPxr24Compressor.cpp, ImfB44Compressor.cpp
        return true;
    }
  }

  /// The range of its values, a bit each, then their code: OpenEXR's decoder goes on with zeros behind the end.
  bool unpacksPiz(Bytes packed, std::size_t count) {
    if (packed.size() < 4) return false;
    const std::uint32_t range = le32(data(packed)), least = range & 0xffff, most = range >> 16;
    const std::size_t at = 4 + (least <= most ? most - least + 1 : 0);
    if (packed.size() < at + 4 || le32(data(packed) + at) > packed.size() - at - 4) return false;
    // A code repeats 255 times with 9 bits at the least.
    if (count > packed.size() * 255) return false;
    symbols_.resize(count);
    return decodeExrHuffman(packed.subspan(at + 4, le32(data(packed) + at)), symbols_);
  }

  Bytes file_;
  const ExrFile& exr_;
  const ExrPart& part_;
  std::uint64_t texelBytes_ = 0;
  Inflater inflater_;
  std::vector<std::uint16_t> symbols_;
  DwaChunks dwa_;
};

}  // namespace

void checkExrChunks(Bytes file, const ExrFile& exr, const CancelToken& cancel) {
  const ExrPart& part = exr.parts.front();
  if (part.isDeep) throw unsupportedEnvironment("is a deep image");
  Walk walk(file, exr);
  walk.tables();
  part.isTiled ? walk.tiles(cancel) : walk.rows(cancel);
}

}  // namespace telar::image
