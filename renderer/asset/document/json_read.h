#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "telar/cancel.h"
#include "telar/limits.h"

namespace telar::asset {

/// Parses JSON without recursion; depth and the number of values are checked while reading, so that no text can
/// overflow the stack or the memory. Of equal keys the last one counts.
/// @param fileOffset where the text starts in the file, for error offsets
/// @throws Error{E_JSON (syntax, UTF-8; byte offset), E_SCHEMA (a number beyond double; pointer), L_JSON_DEPTH,
///         L_JSON_VALUES, X_CANCELLED}
nlohmann::json readJson(std::string_view text, std::uint64_t fileOffset, const Limits& limits,
                        const CancelToken& cancel);

}  // namespace telar::asset
