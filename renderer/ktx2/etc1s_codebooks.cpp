#include <algorithm>

#include "ktx2/etc1s.h"

namespace telar::ktx2 {
namespace {

constexpr std::size_t GLOBAL_HEADER_BYTES = 20, IMAGE_DESCRIPTOR_BYTES = 20;
constexpr std::uint32_t FLAG_P_FRAME = 2;
constexpr unsigned HISTORY_SIZE_BITS = 13;
constexpr std::uint8_t MIDDLE_COLOR = 16;

constexpr int MODIFIERS[8][4] = {{-8, -2, 2, 8},     {-17, -5, 5, 17},   {-29, -9, 9, 29},     {-42, -13, 13, 42},
                                 {-60, -18, 18, 60}, {-80, -24, 24, 80}, {-106, -33, 33, 106}, {-183, -47, 47, 183}};

struct GlobalHeader {
  std::uint16_t endpoints, selectors;
  std::uint32_t endpointBytes, selectorBytes, tableBytes, extendedBytes;
};

GlobalHeader readGlobalHeader(ByteReader& from) {
  GlobalHeader out{};
  out.endpoints = from.u16();
  out.selectors = from.u16();
  for (std::uint32_t* field : {&out.endpointBytes, &out.selectorBytes, &out.tableBytes, &out.extendedBytes}) {
    *field = from.u32();
  }
  return out;
}

/// Deltas of a colour component have a code of their own for dark, middle and bright predecessors.
class ColorDeltas {
 public:
  explicit ColorDeltas(BitReader& from)
      : tables_{HuffmanTable::read(from), HuffmanTable::read(from), HuffmanTable::read(from)} {}

  std::uint8_t next(std::uint8_t previous, BitReader& from) const {
    const HuffmanTable& table = tables_[previous <= 9 ? 0 : previous <= 21 ? 1 : 2];
    return static_cast<std::uint8_t>((previous + table.decode(from)) & 31);
  }

 private:
  std::array<HuffmanTable, 3> tables_;
};

std::vector<Etc1sCodebooks::Endpoint> readEndpoints(Bytes bytes, std::uint16_t count) {
  BitReader from(bytes);
  const ColorDeltas deltas(from);
  const HuffmanTable intensityDelta = HuffmanTable::read(from);
  const bool gray = from.bit() != 0;
  std::vector<Etc1sCodebooks::Endpoint> out(count);
  Etc1sCodebooks::Endpoint last{MIDDLE_COLOR, MIDDLE_COLOR, MIDDLE_COLOR, 0};
  for (auto& endpoint : out) {
    last.intensity = static_cast<std::uint8_t>((last.intensity + intensityDelta.decode(from)) & 7);
    last.red = deltas.next(last.red, from);
    last.green = gray ? last.red : deltas.next(last.green, from);
    last.blue = gray ? last.red : deltas.next(last.blue, from);
    endpoint = last;
  }
  return out;
}

std::vector<Etc1sCodebooks::Selector> readSelectors(Bytes bytes, std::uint16_t count) {
  BitReader from(bytes);
  if (from.bits(2) != 0) throw corrupt("its selector codebook is of an unknown kind");
  const bool raw = from.bit() != 0;
  const HuffmanTable delta = raw ? HuffmanTable() : HuffmanTable::read(from);
  std::vector<Etc1sCodebooks::Selector> out(count);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t row = 0; row < 4; ++row) {
      const bool plain = raw || i == 0;
      const std::uint32_t bits = plain ? from.bits(8) : delta.decode(from) ^ out[i - 1][row];
      out[i][row] = static_cast<std::uint8_t>(bits);
    }
  }
  return out;
}

void readTables(Bytes bytes, Etc1sCodebooks& out) {
  BitReader from(bytes);
  for (HuffmanTable* table : {&out.endpointPrediction, &out.endpointDelta, &out.selector, &out.selectorRun}) {
    *table = HuffmanTable::read(from);
  }
  out.historySize = from.bits(HISTORY_SIZE_BITS);
}

}  // namespace

Etc1sCodebooks readCodebooks(const Container& container) {
  ByteReader from(container.globalData);
  const GlobalHeader header = readGlobalHeader(from);
  from.take(container.levels.size() * IMAGE_DESCRIPTOR_BYTES);
  if (header.endpoints == 0 || header.selectors == 0) throw corrupt("a codebook is empty");
  Etc1sCodebooks out;
  const Bytes endpoints = from.take(header.endpointBytes), selectors = from.take(header.selectorBytes);
  out.endpoints = readEndpoints(endpoints, header.endpoints);
  out.selectors = readSelectors(selectors, header.selectors);
  readTables(from.take(header.tableBytes), out);
  return out;
}

std::vector<Etc1sSlices> readSlices(const Container& container) {
  ByteReader from(container.globalData);
  from.take(GLOBAL_HEADER_BYTES);
  std::vector<Etc1sSlices> out;
  for (const Bytes level : container.levels) {
    if (from.u32() & FLAG_P_FRAME) throw unsupported("is a frame of a video");
    const std::uint32_t colorOffset = from.u32(), colorBytes = from.u32();
    const std::uint32_t alphaOffset = from.u32(), alphaBytes = from.u32();
    Etc1sSlices slices{rangeOf(level, colorOffset, colorBytes), {}};
    if (container.alphaSlices) slices.alpha = rangeOf(level, alphaOffset, alphaBytes);
    if (slices.color.empty() || (container.alphaSlices && slices.alpha.empty())) throw corrupt("a slice is empty");
    out.push_back(slices);
  }
  return out;
}

std::array<std::array<std::uint8_t, 3>, 4> colorsOf(const Etc1sCodebooks::Endpoint& endpoint) {
  const std::uint8_t base[3] = {endpoint.red, endpoint.green, endpoint.blue};
  std::array<std::array<std::uint8_t, 3>, 4> out{};
  for (std::size_t selector = 0; selector < 4; ++selector) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int full = base[c] << 3 | base[c] >> 2;  // 5 bits to 8
      out[selector][c] = static_cast<std::uint8_t>(std::clamp(full + MODIFIERS[endpoint.intensity][selector], 0, 255));
    }
  }
  return out;
}

}  // namespace telar::ktx2
