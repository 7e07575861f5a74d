#include "ibl/disk_cache.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <thread>

#include "core/read_file.h"

namespace telar::ibl {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t FILE_MAX = 256u << 20;
constexpr std::size_t KEY_DIGITS = 64;
constexpr std::string_view SUFFIX = ".pmrem";
/// A file takes milliseconds to write: one that is older belongs to a process that died.
constexpr std::chrono::hours UNFINISHED_MAX{1};

/// What of a file's name is this cache's: nothing else in the folder is touched.
enum class Kind { kOther, kEntry, kUnfinished };

Kind kindOf(const std::string& name) {
  const auto isHex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (name.size() < KEY_DIGITS + SUFFIX.size() || !std::all_of(name.begin(), name.begin() + KEY_DIGITS, isHex) ||
      name.compare(KEY_DIGITS, SUFFIX.size(), SUFFIX) != 0) {
    return Kind::kOther;
  }
  return name.size() == KEY_DIGITS + SUFFIX.size() ? Kind::kEntry : Kind::kUnfinished;
}

struct Kept {
  fs::path path;
  fs::file_time_type used;
  std::uint64_t bytes = 0;
};

/// A new file for writing; what lies there under its name, a pipe for one, is removed and never opened.
int openNew(const std::string& path) {
  constexpr int FLAGS = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  constexpr mode_t MODE = 0666;  // less the process's umask
  const int file = open(path.c_str(), FLAGS, MODE);
  if (file >= 0 || errno != EEXIST || unlink(path.c_str()) != 0) return file;
  return open(path.c_str(), FLAGS, MODE);
}

}  // namespace

std::optional<std::vector<std::byte>> DiskCache::read(const std::string& key) const {
  if (!enabled()) return std::nullopt;
  auto file = readFile(pathOf(key), FILE_MAX);
  // The time of the last change is that of the last use.
  if (file) utimensat(AT_FDCWD, pathOf(key).c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
  return file;
}

void DiskCache::write(const std::string& key, std::span<const std::byte> file) const {
  if (!enabled() || file.size() > maxBytes_) return;
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (writeFileAtomically(pathOf(key), file)) sweep();
}

void DiskCache::sweep() const {
  std::vector<Kept> kept;
  std::uint64_t bytes = 0;
  std::error_code failure;
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator at(folder_, failure), end; !failure && at != end; at.increment(failure)) {
    const Kind kind = kindOf(at->path().filename().string());
    std::error_code gone;  // another process sweeps too
    if (kind == Kind::kOther || at->symlink_status(gone).type() != fs::file_type::regular) continue;
    const Kept file{at->path(), at->last_write_time(gone), at->file_size(gone)};
    if (gone) continue;
    if (kind == Kind::kEntry) {
      kept.push_back(file);
      bytes += file.bytes;
    } else if (now - file.used > UNFINISHED_MAX) {
      fs::remove(file.path, gone);
    }
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
  for (const Kept& file : kept) {
    if (bytes <= maxBytes_) return;
    fs::remove(file.path, failure);
    bytes -= file.bytes;
  }
}

bool writeFileAtomically(const fs::path& path, std::span<const std::byte> bytes) {
  // One name a process and thread; a left-over of a process that died is replaced.
  const std::string temporary = path.string() + "." + std::to_string(getpid()) + "-" +
                                std::to_string(std::hash<std::thread::id>()(std::this_thread::get_id()));
  const int file = openNew(temporary);
  if (file < 0) return false;
  bool ok = true;
  for (std::size_t done = 0; ok && done < bytes.size();) {
    const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
    ok = written > 0;
    if (ok) done += static_cast<std::size_t>(written);
  }
  ok = close(file) == 0 && ok && rename(temporary.c_str(), path.c_str()) == 0;
  if (!ok) unlink(temporary.c_str());
  return ok;
}

}  // namespace telar::ibl
