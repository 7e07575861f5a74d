#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace telar {

/// A limit that an input went over, in the unit that its name says.
struct LimitFact {
  std::string name;  ///< e.g. "L_IMAGE_PIXELS"
  double max = 0;
  double actual = 0;
};

/// The one error type of the renderer. `code` is a row of the table in js/error/table.mjs, which adds kind, retryable,
/// exit code and HTTP status; a test checks that each code thrown in C++ has a row there.
/// The message says what is wrong and what to do, never names a server path, and is cut at 300 characters.
class Error : public std::runtime_error {
 public:
  Error(std::string_view code, const std::string& message);

  /// JSON pointer into the glTF document, e.g. "/accessors/3/count".
  Error& at(std::string_view pointer);
  /// Byte offset in the file.
  Error& atOffset(std::uint64_t offset);
  Error& withLimit(std::string_view name, double max, double actual);

  std::string code;
  std::optional<std::string> pointer;
  std::optional<std::uint64_t> offset;
  std::optional<LimitFact> limit;
};

/// Text taken from a file, made safe for a message: control characters escaped, cut at 64 characters, quoted.
std::string quoted(std::string_view untrusted);

/// Throws `code` (an L_* row) when actual > max.
void checkLimit(std::string_view name, double max, double actual, std::string_view pointer = {});

/// The same for a sum that is still growing: the message says that the input holds at least this much, and counting
/// stopped there.
void checkSum(std::string_view name, double max, double soFar, std::string_view pointer = {});

}  // namespace telar
