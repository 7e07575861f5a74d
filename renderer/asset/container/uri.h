#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace telar::asset {

bool isDataUri(std::string_view uri);

/// Decodes a data: URI (RFC 2397), base64 or percent-encoded; only application/* and image/* types, or none.
/// @throws Error{E_URI_DATA}
std::vector<std::byte> decodeDataUri(std::string_view uri, std::string_view where);

/// Turns a relative reference into a path beneath the model's folder: percent-decoded once, '/' between components.
/// @throws Error{E_URI_DENIED} for a scheme, an absolute path, "..", a backslash, a control character, a second layer
///         of percent-encoding that hides one of these, or a leading '$' or '~'; Error{E_URI_MISSING} when empty
std::string relativePath(std::string_view uri, std::string_view where);

}  // namespace telar::asset
