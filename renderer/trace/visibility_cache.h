#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/plugin.h"
#include "telar/scene.h"

namespace telar::trace {

/// By primitive of the file: its mesh as an index of the file, its place in that.
using FoundVisibility = std::map<std::pair<int, std::size_t>, VisibilityJob::Sides>;

/// What the rays of a model depend on, as 64 hex digits: its file and parts, what of them could not be read, the rays,
/// and the version of telar.
std::string visibilityKey(const Scene& model, int rays, std::string_view version);

/// A file of DiskCache: the floats as they are, since a picture has the same bytes whether rays were cast or not.
std::vector<std::byte> packVisibility(const FoundVisibility& found, std::string_view key);

/// @return nothing where the file is of another key, or is not as it was written
std::optional<FoundVisibility> unpackVisibility(std::span<const std::byte> file, std::string_view key);

}  // namespace telar::trace
