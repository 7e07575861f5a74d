#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace telar {

/// What was made of a file's content, on disk, of any number of processes. What cannot be read or written is not there:
/// a cache is never an error.
class DiskCache {
 public:
  /// @param folder   empty = nothing is kept
  /// @param maxBytes of all its files, of every kind
  DiskCache(std::filesystem::path folder, std::uint64_t maxBytes) : folder_(std::move(folder)), maxBytes_(maxBytes) {}

  bool enabled() const { return !folder_.empty() && maxBytes_ > 0; }

  /// What files hold, by the end of their names: KEY.pmrem, KEY.visibility.
  enum class Kind { kEnvironment, kVisibility };

  /// @param key SHA-256 as 64 hex digits
  std::optional<std::vector<std::byte>> read(Kind kind, const std::string& key) const;

  /// Keeps a file, then deletes those that were used longest ago while all are larger than maxBytes together, and what
  /// processes that died left half written.
  void write(Kind kind, const std::string& key, std::span<const std::byte> file) const;

 private:
  std::filesystem::path pathOf(Kind kind, const std::string& key) const;
  void sweep() const;

  std::filesystem::path folder_;
  std::uint64_t maxBytes_;
};

/// Writes beside the target and renames, so that a reader never sees half a file.
bool writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace telar
