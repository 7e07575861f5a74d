#pragma once
#include <napi.h>

#include <cstdint>
#include <optional>
#include <string>

#include "telar/error.h"

namespace telar::addon {

/// An error as plain data, on its way from the thread where it was thrown to JavaScript.
struct Fault {
  std::string code, message;
  std::optional<std::string> pointer;
  std::optional<std::uint64_t> offset;
  std::optional<LimitFact> limit;

  /// Of the exception being handled; call it inside of a catch block.
  /// telar::Error keeps its fields, a failed allocation or thread start is X_MEMORY, all else is X_INTERNAL.
  static Fault current();

  /// {code, message, pointer?, offset?, limit?: {name, max, actual}}: what js/error's fromNative takes.
  Napi::Object toJs(Napi::Env env) const;
};

}  // namespace telar::addon
