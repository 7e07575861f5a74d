#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace telar {

/// Whole regular file, or nothing when it is none, cannot be read or is larger than `maxBytes`. Never waits for a pipe.
std::optional<std::vector<std::byte>> readFile(const std::filesystem::path& path, std::size_t maxBytes);

}  // namespace telar
