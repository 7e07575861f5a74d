#pragma once
#include <string_view>

namespace telar::asset {

/// What a file that is no glTF looks like from its first bytes, as "a PNG image" or "an HTML page, as downloads that
/// failed leave"; empty when nothing is recognised.
std::string_view fileKind(std::string_view head);

}  // namespace telar::asset
