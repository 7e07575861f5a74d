#pragma once
#include <nettle/sha2.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace telar {

/// SHA-256 (FIPS 180-4) by nettle, which uses the CPU's own instructions where it has them.
class Sha256 {
 public:
  Sha256() { sha256_init(&state_); }
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
  /// 64 hex digits of what was added; the next digest begins empty.
  std::string hex();

 private:
  sha256_ctx state_;
};

/// SHA-256 as 64 hex digits.
std::string sha256Hex(std::span<const std::byte> bytes);

}  // namespace telar
