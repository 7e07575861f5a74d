#include "asset/container/uri.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// One layer of percent-encoding; a '%' that is not followed by two hex digits stands for itself, as in browsers.
std::string percentDecode(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape =
        text[i] == '%' && text.size() - i > 2 && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
    if (escape) {
      out += static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2]));
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

int base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return -1;
}

/// RFC 4648 section 4; padding may be left out, nothing else is forgiven.
std::vector<std::byte> decodeBase64(std::string_view text, std::string_view where) {
  while (text.ends_with('=') && text.size() % 4 != 1) text.remove_suffix(1);
  if (text.size() % 4 == 1) fail("E_URI_DATA", "the base64 of a data: URI has a wrong length", where);
  std::vector<std::byte> out;
  out.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64Digit(c);
    if (digit < 0) fail("E_URI_DATA", "a data: URI has a character that is not base64", where);
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out.push_back(static_cast<std::byte>(bits >> count & 0xff));
  }
  return out;
}

bool equalIgnoringCase(std::string_view a, std::string_view lowerCase) {
  return std::equal(a.begin(), a.end(), lowerCase.begin(), lowerCase.end(),
                    [](char x, char y) { return std::tolower(static_cast<unsigned char>(x)) == y; });
}

bool startsIgnoringCase(std::string_view text, std::string_view lowerCase) {
  return text.size() >= lowerCase.size() && equalIgnoringCase(text.substr(0, lowerCase.size()), lowerCase);
}

/// src: RFC 3986, section 3.1
bool hasScheme(std::string_view uri) {
  const auto end = std::find_if(uri.begin(), uri.end(), [](char c) {
    return !std::isalnum(static_cast<unsigned char>(c)) && c != '+' && c != '-' && c != '.';
  });
  return end != uri.begin() && end != uri.end() && *end == ':';
}

bool hasParentComponent(std::string_view path) {
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    if (path.substr(0, end) == "..") return true;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return false;
}

bool leavesFolder(std::string_view path) {
  const auto forbidden = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\'; };
  return path.starts_with('/') || path.starts_with('$') || path.starts_with('~') || hasScheme(path) ||
         hasParentComponent(path) || std::any_of(path.begin(), path.end(), forbidden);
}

}  // namespace

bool isDataUri(std::string_view uri) { return startsIgnoringCase(uri, "data:"); }

std::vector<std::byte> decodeDataUri(std::string_view uri, std::string_view where) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) fail("E_URI_DATA", "a data: URI has no comma before its data", where);
  std::string_view head = uri.substr(5, comma - 5);
  const std::string_view data = uri.substr(comma + 1);
  constexpr std::string_view BASE64 = ";base64";
  const bool base64 =
      head.size() >= BASE64.size() && equalIgnoringCase(head.substr(head.size() - BASE64.size()), BASE64);
  if (base64) head.remove_suffix(BASE64.size());
  const std::string_view type = head.substr(0, head.find(';'));
  if (!type.empty() && !startsIgnoringCase(type, "application/") && !startsIgnoringCase(type, "image/")) {
    fail("E_URI_DATA", "a data: URI has the media type " + telar::quoted(type) + ", which holds no buffer and no image",
         where);
  }
  if (base64) return decodeBase64(data, where);
  const std::string text = percentDecode(data);
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  return {bytes, bytes + text.size()};
}

std::string relativePath(std::string_view uri, std::string_view where) {
  if (uri.empty()) fail("E_URI_MISSING", "a uri is empty; it must name a file beside the model", where);
  std::string path = percentDecode(uri);
  if (hasScheme(uri) || leavesFolder(path) || leavesFolder(percentDecode(path))) {
    fail("E_URI_DENIED",
         "the uri " + telar::quoted(uri) + " leads out of the model's folder; only files beneath it are opened", where);
  }
  return path;
}

}  // namespace telar::asset
