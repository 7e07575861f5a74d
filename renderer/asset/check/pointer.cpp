#include "asset/check/pointer.h"

namespace telar::asset {
namespace {
constexpr std::size_t TOKEN_MAX = 64;
}

void addToken(std::string& pointer, std::string_view token) {
  pointer += '/';
  for (const char c : token.substr(0, TOKEN_MAX)) {
    if (c == '~') {
      pointer += "~0";
    } else if (c == '/') {
      pointer += "~1";
    } else {
      // A cut or a foreign byte must not make the pointer invalid UTF-8: it ends up in JSON.
      pointer += c >= 0x20 && c < 0x7f ? c : '?';
    }
  }
}

}  // namespace telar::asset
