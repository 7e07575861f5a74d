#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace telar {

/// What tells that nothing was written to a file: the file system's number of it, its size, and the nanoseconds at
/// which its content and its entry were last changed. The latter nobody can set.
struct FileStamp {
  std::uint64_t device = 0, file = 0, bytes = 0;
  std::int64_t contentChanged = 0, entryChanged = 0;
  bool operator==(const FileStamp&) const = default;
};

/// Of a regular file that is there.
std::optional<FileStamp> stampOf(const std::filesystem::path& path);
/// Nanoseconds since 1970 began (UTC), of the clock that stamps are of.
std::int64_t stampNow();

/// The hashes of files that were read before.
class KnownFiles {
 public:
  /// The hash of a file that has not changed since.
  std::optional<std::string> sha256(const std::filesystem::path& path) const;
  /// @param before  its stamp before it was read; a file that was changed less than two seconds before `now` is not
  ///   remembered, for file systems have clocks as coarse: what is written next could have the same stamp
  /// @param now  as stampNow(): ns since 1970 began, UTC
  void remember(const std::filesystem::path& path, const std::optional<FileStamp>& before, const std::string& sha256,
                std::int64_t now = stampNow());

 private:
  struct Known {
    FileStamp stamp;
    std::string sha256;
  };
  std::map<std::filesystem::path, Known> files_;  ///< a few: all are forgotten when there are too many
};

}  // namespace telar
