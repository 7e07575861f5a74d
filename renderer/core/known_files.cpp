#include "core/known_files.h"

#include <sys/stat.h>

#include <chrono>

namespace telar {
namespace {

constexpr std::size_t FILES_MAX = 64;
constexpr std::int64_t COARSEST_CLOCK = 2'000'000'000;  ///< ns, of FAT

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

}  // namespace

std::optional<FileStamp> stampOf(const std::filesystem::path& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
  return FileStamp{found.st_dev, found.st_ino, static_cast<std::uint64_t>(found.st_size), nanoseconds(found.st_mtim),
                   nanoseconds(found.st_ctim)};
}

std::int64_t stampNow() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

std::optional<std::string> KnownFiles::sha256(const std::filesystem::path& path) const {
  const auto known = files_.find(path);
  if (known == files_.end() || stampOf(path) != known->second.stamp) return std::nullopt;
  return known->second.sha256;
}

void KnownFiles::remember(const std::filesystem::path& path, const std::optional<FileStamp>& before,
                          const std::string& sha256, std::int64_t now) {
  files_.erase(path);
  if (!before || before->contentChanged > now - COARSEST_CLOCK || before->entryChanged > now - COARSEST_CLOCK) return;
  if (files_.size() >= FILES_MAX) files_.clear();
  files_.emplace(path, Known{*before, sha256});
}

}  // namespace telar
