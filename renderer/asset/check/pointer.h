#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "telar/error.h"

namespace telar::asset {

/// Adds one reference token to a JSON pointer (RFC 6901): escaped, control characters replaced, cut at 64 bytes.
void addToken(std::string& pointer, std::string_view token);

inline void addToken(std::string& pointer, std::size_t index) { pointer += "/" + std::to_string(index); }
inline void addToken(std::string& pointer, int index) { pointer += "/" + std::to_string(index); }

/// pointer("meshes", 3, "primitives", 0) == "/meshes/3/primitives/0"
template <typename... Tokens>
std::string pointer(const Tokens&... tokens) {
  std::string out;
  (addToken(out, tokens), ...);
  return out;
}

[[noreturn]] inline void fail(std::string_view code, const std::string& message, std::string_view where) {
  throw Error(code, message).at(where);
}

}  // namespace telar::asset
