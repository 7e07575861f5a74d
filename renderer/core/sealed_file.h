#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace telar {

/// Bytes between the head and the body of a file of a cache: the key of what it holds, and the SHA-256 of all the rest.
constexpr std::size_t SEAL_BYTES = 128;

/// Writes the seal of a file whose head and body are there.
/// @param file  head, SEAL_BYTES, body    @param key  up to 64 characters
void seal(std::span<std::byte> file, std::size_t headBytes, std::string_view key);

/// Whether a file is of this key, and every byte is as it was sealed.
bool isSealed(std::span<const std::byte> file, std::size_t headBytes, std::string_view key);

}  // namespace telar
