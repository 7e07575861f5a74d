#include "ktx2/decode.h"

#include <algorithm>

#include "ktx2/container.h"
#include "ktx2/etc1s.h"
#include "ktx2/uastc.h"
#include "ktx2/zstd.h"

namespace telar::ktx2 {
namespace {

/// One level that is being filled; the texels of blocks are 8-bit.
struct Target {
  std::uint32_t width, height;
  ZeroedBytes pixels;

  std::uint8_t* texel(std::uint32_t x, std::uint32_t y) { return pixels.data() + (std::size_t{y} * width + x) * 4; }
};

/// Sides of a level as the client's texture has them.
std::uint32_t paintedSide(const Container& container, std::uint32_t side, std::size_t level) {
  const bool basis = container.payload == Payload::kEtc1s || container.payload == Payload::kUastc;
  const bool wholeBlocks = basis && container.levels.size() == 1;
  return wholeBlocks ? blocksOf(side) * 4 : sideOf(side, level);
}

TexelType typeOf(const Container& container) {
  if (container.blocks) return TexelType::kBlocks;
  return container.raw ? container.raw->type() : TexelType::kByte;
}

Target targetOf(const Container& container, std::size_t level) {
  Target out{paintedSide(container, container.width, level), paintedSide(container, container.height, level), {}};
  out.pixels.resize(container.blocks ? levelBytes(container, level)
                                     : std::size_t{out.width} * out.height * texelBytes(typeOf(container)));
  return out;
}

/// Calls paint(texel of the target, index of the texel in its block) for the texels of a block that lie in the image.
template <class Paint>
void paintBlock(Target& target, std::uint32_t blockX, std::uint32_t blockY, const Paint& paint) {
  const std::uint32_t endX = std::min(blockX * 4 + 4, target.width), endY = std::min(blockY * 4 + 4, target.height);
  for (std::uint32_t y = blockY * 4; y < endY; ++y) {
    for (std::uint32_t x = blockX * 4; x < endX; ++x) paint(target.texel(x, y), y % 4 * 4 + x % 4);
  }
}

/// Calls paint(texel, colour) for every texel of a slice.
template <class Paint>
void paintSlice(const Etc1sCodebooks& codebooks, Bytes slice, Target& target, const CancelToken& cancel,
                const Paint& paint) {
  const std::uint32_t blocksX = blocksOf(target.width), blocksY = blocksOf(target.height);
  const auto blocks = decodeSlice(codebooks, slice, blocksX, blocksY, cancel);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto colors = colorsOf(codebooks.endpoints[blocks[i].endpoint]);
    const auto& selector = codebooks.selectors[blocks[i].selector];
    paintBlock(
        target, static_cast<std::uint32_t>(i % blocksX), static_cast<std::uint32_t>(i / blocksX),
        [&](std::uint8_t* texel, std::uint32_t at) { paint(texel, colors[selector[at / 4] >> (at % 4 * 2) & 3]); });
  }
}

void paintEtc1s(const Etc1sCodebooks& codebooks, const Etc1sSlices& slices, Target& target, const CancelToken& cancel) {
  paintSlice(codebooks, slices.color, target, cancel, [](std::uint8_t* texel, const auto& color) {
    std::copy(color.begin(), color.end(), texel);
    texel[3] = 255;
  });
  if (slices.alpha.empty()) return;
  paintSlice(codebooks, slices.alpha, target, cancel,
             [](std::uint8_t* texel, const auto& color) { texel[3] = color[1]; });
}

void paintUastc(Bytes blocks, Target& target, const CancelToken& cancel) {
  const std::uint32_t blocksX = blocksOf(target.width), blocksY = blocksOf(target.height);
  Texels4x4 texels{};
  for (std::uint32_t y = 0; y < blocksY; ++y) {
    cancel.check();
    for (std::uint32_t x = 0; x < blocksX; ++x) {
      const std::uint8_t* block = data(blocks) + (std::size_t{y} * blocksX + x) * 16;
      if (!decodeUastcBlock(std::span<const std::uint8_t, 16>(block, 16), texels)) {
        throw corrupt("it has a block that UASTC does not know");
      }
      paintBlock(target, x, y, [&](std::uint8_t* texel, std::uint32_t at) {
        std::copy(texels[at].begin(), texels[at].end(), texel);
      });
    }
  }
}

void paintLevel(const Container& container, std::size_t level, Target& target, const CancelToken& cancel) {
  Bytes bytes = container.levels[level];
  std::vector<std::uint8_t> inflated;
  if (container.zstd) {
    inflated.resize(levelBytes(container, level));
    decompressZstd(bytes, inflated);
    bytes = std::as_bytes(std::span(inflated));
  }
  if (container.payload == Payload::kUastc) {
    paintUastc(bytes, target, cancel);
  } else if (container.blocks) {
    std::copy_n(data(bytes), target.pixels.size(), target.pixels.data());
  } else if (!expandRaw(*container.raw, bytes, target.pixels)) {
    throw corrupt("it holds texels that are not numbers, or infinite");
  }
}

}  // namespace

ImageHeader readHeader(Bytes file, const Limits& limits) {
  const Container container = readContainer(file, limits);
  return {paintedSide(container, container.width, 0), paintedSide(container, container.height, 0), "image/ktx2",
          texelBytes(typeOf(container))};
}

Image8 decode(Bytes file, const Limits& limits, const CancelToken& cancel) {
  const Container container = readContainer(file, limits);
  const bool etc1s = container.payload == Payload::kEtc1s;
  const auto codebooks = etc1s ? readCodebooks(container) : Etc1sCodebooks();
  const auto slices = etc1s ? readSlices(container) : std::vector<Etc1sSlices>();
  Image8 out;
  for (std::size_t level = 0; level < container.levels.size(); ++level) {
    cancel.check();
    Target target = targetOf(container, level);
    etc1s ? paintEtc1s(codebooks, slices[level], target, cancel) : paintLevel(container, level, target, cancel);
    if (level == 0) {
      out = {target.width, target.height, std::move(target.pixels)};
    } else {
      out.smallerLevels.push_back(std::move(target.pixels));
    }
  }
  out.ownLevels = true;
  out.coding = container.coding;
  out.format = formatName(container);
  out.type = typeOf(container);
  if (container.blocks) out.blocks = container.blocks->format;
  if (container.raw) out.missingLevels = container.raw->components < 4 ? MissingLevels::kBlack : MissingLevels::kClear;
  return out;
}

}  // namespace telar::ktx2
