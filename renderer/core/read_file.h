#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace telar {

/// Whole file, or nothing when it cannot be read or is larger than `maxBytes`.
std::optional<std::vector<std::byte>> readFile(const std::filesystem::path& path, std::size_t maxBytes);

}  // namespace telar
