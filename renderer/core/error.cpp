#include "telar/error.h"

#include <cstdio>

namespace telar {
namespace {

constexpr std::size_t MESSAGE_MAX = 300;
constexpr std::size_t QUOTED_MAX = 64;

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", x);
  return text;
}

[[noreturn]] void throwOver(std::string_view name, const std::string& what, double max, double actual,
                            std::string_view pointer) {
  Error error(name,
              std::string(name) + ": " + what + "; reduce the file, or raise this limit for files that you trust");
  error.withLimit(name, max, actual);
  if (!pointer.empty()) error.at(pointer);
  throw error;
}

}  // namespace

Error::Error(std::string_view code_, const std::string& message)
    : std::runtime_error(message.substr(0, MESSAGE_MAX)), code(code_) {}

Error& Error::at(std::string_view where) {
  pointer = std::string(where);
  return *this;
}

Error& Error::atOffset(std::uint64_t where) {
  offset = where;
  return *this;
}

Error& Error::withLimit(std::string_view name, double max, double actual) {
  limit = LimitFact{std::string(name), max, actual};
  return *this;
}

std::string quoted(std::string_view untrusted) {
  std::string out = "\"";
  const bool cut = untrusted.size() > QUOTED_MAX;
  for (const char c : untrusted.substr(0, QUOTED_MAX)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte >= 0x7f || c == '"' || c == '\\') {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\x%02x", byte);
      out += escaped;
    } else {
      out += c;
    }
  }
  return out + (cut ? "...\"" : "\"");
}

void checkLimit(std::string_view name, double max, double actual, std::string_view pointer) {
  if (actual > max) throwOver(name, number(actual) + " is over the limit of " + number(max), max, actual, pointer);
}

void checkSum(std::string_view name, double max, double soFar, std::string_view pointer) {
  if (soFar <= max) return;
  throwOver(name, "more than the limit of " + number(max) + " (at least " + number(soFar) + ": counting stopped there)",
            max, soFar, pointer);
}

}  // namespace telar
