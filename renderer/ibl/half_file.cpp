#include "ibl/half_file.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "core/sha256.h"

namespace telar::ibl {
namespace {

struct Header {
  HalfFileHead head;
  char key[64];  ///< zeros behind a shorter one
  char sha256[64];
};

/// Of the header as it is with zeros for the digest, and of the body.
std::string digestOf(Header header, std::span<const std::byte> body) {
  std::memset(header.sha256, 0, sizeof header.sha256);
  Sha256 digest;
  digest.add(std::as_bytes(std::span(&header, 1)));
  digest.add(body);
  return digest.hex();
}

std::array<char, sizeof Header::key> keyField(std::string_view key) {
  std::array<char, sizeof Header::key> out{};
  std::copy_n(key.begin(), std::min(key.size(), out.size()), out.begin());
  return out;
}

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
  std::vector<std::byte> packed(sizeof(Header) + libdeflate_deflate_compress_bound(compressor.get(), planes.size()));
  const std::size_t size = libdeflate_deflate_compress(compressor.get(), planes.data(), planes.size(),
                                                       &packed[sizeof(Header)], packed.size() - sizeof(Header));
  packed.resize(sizeof(Header) + size);
  Header header{};
  header.head = head;
  std::memcpy(header.key, keyField(key).data(), sizeof header.key);
  std::memcpy(header.sha256, digestOf(header, std::span(packed).subspan(sizeof(Header))).data(), sizeof header.sha256);
  std::memcpy(packed.data(), &header, sizeof header);
  return packed;
}

std::optional<HalfFileHead> headOf(std::span<const std::byte> file, std::string_view key) {
  Header header;
  if (file.size() <= sizeof header) return std::nullopt;
  std::memcpy(&header, file.data(), sizeof header);
  if (std::memcmp(header.key, keyField(key).data(), sizeof header.key) != 0 ||
      std::memcmp(header.sha256, digestOf(header, file.subspan(sizeof header)).data(), sizeof header.sha256) != 0) {
    return std::nullopt;
  }
  return header.head;
}

std::optional<std::vector<std::uint16_t>> unpackHalfs(std::span<const std::byte> file, std::size_t texels) {
  const auto body = file.subspan(sizeof(Header));
  const std::size_t count = texels * 3;
  std::vector<std::uint8_t> planes(count * 2);
  const Decompressor decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (libdeflate_deflate_decompress(decompressor.get(), body.data(), body.size(), planes.data(), planes.size(),
                                    nullptr) != LIBDEFLATE_SUCCESS) {
    return std::nullopt;
  }
  constexpr std::uint16_t HALF_ONE = 0x3c00;
  std::vector<std::uint16_t> rgba(texels * 4, HALF_ONE);
  std::uint16_t previous[3] = {};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t channel = i % 3;
    previous[channel] = static_cast<std::uint16_t>(previous[channel] + (planes[i] << 8 | planes[count + i]));
    rgba[i / 3 * 4 + channel] = previous[channel];
  }
  return rgba;
}

}  // namespace telar::ibl
