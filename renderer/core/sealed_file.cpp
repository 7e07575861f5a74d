#include "core/sealed_file.h"

#include <algorithm>
#include <array>

#include "core/sha256.h"

namespace telar {
namespace {

using Field = std::array<std::byte, SEAL_BYTES / 2>;

/// Zeros behind a shorter text.
Field fieldOf(std::string_view text) {
  Field field{};
  std::copy_n(std::as_bytes(std::span(text)).begin(), std::min(text.size(), field.size()), field.begin());
  return field;
}

/// Of the file with zeros in place of the digest.
Field digestOf(std::span<const std::byte> file, std::size_t headBytes) {
  Sha256 digest;
  digest.add(file.first(headBytes + sizeof(Field)));
  digest.add(Field{});
  digest.add(file.subspan(headBytes + SEAL_BYTES));
  return fieldOf(digest.hex());
}

}  // namespace

void seal(std::span<std::byte> file, std::size_t headBytes, std::string_view key) {
  std::ranges::copy(fieldOf(key), file.subspan(headBytes).begin());
  std::ranges::copy(digestOf(file, headBytes), file.subspan(headBytes + sizeof(Field)).begin());
}

bool isSealed(std::span<const std::byte> file, std::size_t headBytes, std::string_view key) {
  if (file.size() < headBytes + SEAL_BYTES) return false;
  const auto fields = file.subspan(headBytes, SEAL_BYTES);
  return std::ranges::equal(fields.first(sizeof(Field)), fieldOf(key)) &&
         std::ranges::equal(fields.last(sizeof(Field)), digestOf(file, headBytes));
}

}  // namespace telar
