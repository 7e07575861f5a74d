#include "image/exr_dwa.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "image/exr_huffman.h"

namespace telar::image {
namespace {

enum class Scheme : std::uint8_t { kUnknown, kCosine, kRuns };

/// What a chunk begins with, in this order, 64 bits each.
enum Count : std::size_t {
  VERSION,
  PLAIN_BYTES,
  PLAIN_PACKED,
  AC_PACKED,
  DC_PACKED,
  RUNS_PACKED,
  RUNS_BYTES,
  RUNS_RAW,
  AC_COUNT,
  DC_COUNT,
  AC_CODING,
  COUNTS
};

/// Which channels are packed how. The name is that behind the last dot.
struct Rule {
  std::string name;
  Scheme scheme;
  ExrType type;
  bool isAnyCase;
};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), lower);
  return text;
}

/// Those of files before version 2.
std::vector<Rule> oldRules() {
  std::vector<Rule> rules;
  for (const char* name : {"r", "red", "g", "grn", "green", "b", "blu", "blue", "y", "by", "ry"})
    for (const ExrType type : {ExrType::kHalf, ExrType::kFloat}) rules.push_back({name, Scheme::kCosine, type, true});
  for (const ExrType type : {ExrType::kUint, ExrType::kHalf, ExrType::kFloat})
    rules.push_back({"a", Scheme::kRuns, type, true});
  return rules;
}

/// Takes the rules off the front of `rest`; false where they are damaged.
bool takeRules(Bytes& rest, std::vector<Rule>& rules) {
  if (rest.size() < 2) return false;
  const std::size_t size = data(rest)[0] | data(rest)[1] << 8;
  if (size < 2 || size > rest.size()) return false;
  std::string_view text(reinterpret_cast<const char*>(rest.data()) + 2, size - 2);
  rest = rest.subspan(size);
  while (!text.empty()) {
    const std::size_t end = text.find('\0');
    if (end == std::string_view::npos || end > 253 || text.size() - end < 3) return false;
    const auto kind = static_cast<std::uint8_t>(text[end + 1]), type = static_cast<std::uint8_t>(text[end + 2]);
    if (kind >> 4 > 3 || (kind >> 2 & 3) > 2 || type > 2) return false;
    rules.push_back({std::string(text.substr(0, end)), static_cast<Scheme>(kind >> 2 & 3), static_cast<ExrType>(type),
                     (kind & 1) != 0});
    text.remove_prefix(end + 3);
  }
  return true;
}

/// How the channel is packed; false where several rules fit it, of which no file has need.
bool schemeOf(const ExrChannel& channel, const std::vector<Rule>& rules, Scheme& scheme) {
  const std::string name = channel.name.substr(channel.name.rfind('.') + 1);
  const auto fits = [&](const Rule& rule) {
    return rule.type == channel.type && (rule.isAnyCase ? lowered(name) : name) == rule.name;
  };
  scheme = Scheme::kUnknown;
  const auto found = std::find_if(rules.begin(), rules.end(), fits);
  if (found == rules.end()) return true;
  scheme = found->scheme;
  return std::find_if(found + 1, rules.end(), fits) == rules.end();
}

/// Whether the symbols of AC coefficients suffice for `blocks` blocks of 8 x 8.
bool endBlocks(const std::vector<std::uint16_t>& symbols, std::uint64_t blocks) {
  std::size_t i = 0;
  for (; blocks > 0; --blocks) {
    for (unsigned coefficient = 1; coefficient < 64; ++i) {
      if (i == symbols.size()) return false;
      const unsigned symbol = symbols[i];
      coefficient += symbol == 0xff00 ? 64 : symbol >> 8 == 0xff ? symbol & 0xff : 1;
    }
  }
  return true;
}

}  // namespace

bool DwaChunks::fills(Bytes packed, const std::vector<ExrChannel>& channels, std::uint64_t width,
                      std::uint64_t height) {
  std::array<std::uint64_t, COUNTS> counts;
  if (packed.size() < sizeof counts) return false;
  for (std::size_t i = 0; i < COUNTS; ++i)
    counts[i] = std::uint64_t{le32(data(packed) + 8 * i + 4)} << 32 | le32(data(packed) + 8 * i);
  Bytes rest = packed.subspan(sizeof counts);
  std::vector<Rule> rules;
  if (counts[VERSION] > 2) return false;
  if (counts[VERSION] == 2 ? !takeRules(rest, rules) : (rules = oldRules(), false)) return false;

  std::uint64_t plain = 0, runs = 0, cosines = 0;
  for (const ExrChannel& channel : channels) {
    Scheme scheme;
    if (!schemeOf(channel, rules, scheme)) return false;
    if (scheme == Scheme::kUnknown) plain += width * height * bytesOf(channel.type);
    if (scheme == Scheme::kRuns) runs += width * height * bytesOf(channel.type);
    if (scheme == Scheme::kCosine && channel.type == ExrType::kUint) return false;
    if (scheme == Scheme::kCosine) cosines += (width + 7) / 8 * ((height + 7) / 8);
  }
  const auto takeBytes = [&](std::uint64_t count, Bytes& part) {
    if (count > rest.size()) return false;
    part = rest.first(static_cast<std::size_t>(count));
    rest = rest.subspan(part.size());
    return true;
  };
  Bytes plainPart, acPart, dcPart, runsPart;
  if (!takeBytes(counts[PLAIN_PACKED], plainPart) || !takeBytes(counts[AC_PACKED], acPart) ||
      !takeBytes(counts[DC_PACKED], dcPart) || !takeBytes(counts[RUNS_PACKED], runsPart))
    return false;
  if (counts[PLAIN_BYTES] != plain || (plain > 0 && !inflater_.gives(plainPart, plain))) return false;
  if (counts[RUNS_RAW] != runs || counts[RUNS_BYTES] > 2 * runs) return false;
  if (runs > 0 && (!inflater_.gives(runsPart, counts[RUNS_BYTES]) || !runsGive(inflater_.bytes(), runs))) return false;
  if (counts[DC_COUNT] != cosines || (cosines > 0 && !inflater_.gives(dcPart, 2 * cosines))) return false;

  if (counts[AC_COUNT] > 63 * cosines || (counts[AC_COUNT] > 0 && acPart.empty())) return false;
  symbols_.resize(static_cast<std::size_t>(counts[AC_COUNT]));
  if (counts[AC_CODING] == 0 && !decodeExrHuffman(acPart, symbols_)) return false;
  if (counts[AC_CODING] == 1) {
    if (!symbols_.empty() && !inflater_.gives(acPart, 2 * symbols_.size())) return false;
    if (!symbols_.empty()) std::memcpy(symbols_.data(), inflater_.bytes().data(), 2 * symbols_.size());
  }
  return counts[AC_CODING] < 2 && endBlocks(symbols_, cosines);
}

}  // namespace telar::image
