#include "ibl/half_file.h"

#include <libdeflate.h>

#include <cstring>
#include <memory>

#include "core/sealed_file.h"

namespace telar::ibl {
namespace {

/// Before the body.
constexpr std::size_t FRONT_BYTES = sizeof(HalfFileHead) + SEAL_BYTES;

using Compressor = std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>;
using Decompressor = std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>;

}  // namespace

std::vector<std::byte> packHalfs(const HalfFileHead& head, std::string_view key, std::span<const std::uint16_t> rgba) {
  // Neighbouring texels of one channel are alike: differences, low bytes apart from high bytes, pack to about a third.
  const std::size_t count = rgba.size() / 4 * 3;
  std::vector<std::uint8_t> planes(count * 2);
  std::uint16_t previous[3] = {};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t channel = i % 3;
    const std::uint16_t half = rgba[i / 3 * 4 + channel];
    const auto difference = static_cast<std::uint16_t>(half - previous[channel]);
    previous[channel] = half;
    planes[i] = static_cast<std::uint8_t>(difference >> 8);
    planes[count + i] = static_cast<std::uint8_t>(difference);
  }
  const Compressor compressor(libdeflate_alloc_compressor(9), &libdeflate_free_compressor);
  std::vector<std::byte> packed(FRONT_BYTES + libdeflate_deflate_compress_bound(compressor.get(), planes.size()));
  const std::size_t size = libdeflate_deflate_compress(compressor.get(), planes.data(), planes.size(),
                                                       &packed[FRONT_BYTES], packed.size() - FRONT_BYTES);
  packed.resize(FRONT_BYTES + size);
  std::memcpy(packed.data(), &head, sizeof head);
  seal(packed, sizeof head, key);
  return packed;
}

std::optional<HalfFileHead> headOf(std::span<const std::byte> file, std::string_view key) {
  if (file.size() <= FRONT_BYTES || !isSealed(file, sizeof(HalfFileHead), key)) return std::nullopt;
  HalfFileHead head;
  std::memcpy(&head, file.data(), sizeof head);
  return head;
}

std::optional<HalfReader> HalfReader::open(std::span<const std::byte> file, std::size_t texels) {
  const auto body = file.subspan(FRONT_BYTES);
  const std::size_t halfs = texels * 3;
  auto planes = std::make_unique_for_overwrite<std::uint8_t[]>(halfs * 2);
  const Decompressor decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (libdeflate_deflate_decompress(decompressor.get(), body.data(), body.size(), planes.get(), halfs * 2, nullptr) !=
      LIBDEFLATE_SUCCESS) {
    return std::nullopt;
  }
  return HalfReader(std::move(planes), halfs);
}

void HalfReader::read(std::span<std::uint16_t> rgba) {
  constexpr std::uint16_t HALF_ONE = 0x3c00;
  const std::uint8_t *high = planes_.get() + next_, *low = high + halfs_;
  for (std::size_t i = 0; i < rgba.size(); i += 4, high += 3, low += 3) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      previous_[channel] = static_cast<std::uint16_t>(previous_[channel] + (high[channel] << 8 | low[channel]));
      rgba[i + channel] = previous_[channel];
    }
    rgba[i + 3] = HALF_ONE;
  }
  next_ += rgba.size() / 4 * 3;
}

}  // namespace telar::ibl
