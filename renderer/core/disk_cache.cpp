#include "core/disk_cache.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <thread>

#include "core/read_file.h"

namespace telar {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t FILE_MAX = 256u << 20;
constexpr std::size_t KEY_DIGITS = 64;
/// By DiskCache::Kind.
constexpr std::array<std::string_view, 2> SUFFIXES = {".pmrem", ".visibility"};
/// A file takes milliseconds to write: one that is older belongs to a process that died.
constexpr std::chrono::hours UNFINISHED_MAX{1};

/// What of a file's name is this cache's: nothing else in the folder is touched.
enum class State { kOther, kEntry, kUnfinished };

State stateOf(std::string_view name) {
  const auto isHex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (name.size() < KEY_DIGITS || !std::all_of(name.begin(), name.begin() + KEY_DIGITS, isHex)) return State::kOther;
  const std::string_view rest = name.substr(KEY_DIGITS);
  for (const std::string_view suffix : SUFFIXES) {
    if (rest == suffix) return State::kEntry;
    if (rest.starts_with(suffix)) return State::kUnfinished;
  }
  return State::kOther;
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

fs::path DiskCache::pathOf(Kind kind, const std::string& key) const {
  return folder_ / (key + std::string(SUFFIXES[static_cast<std::size_t>(kind)]));
}

std::optional<std::vector<std::byte>> DiskCache::read(Kind kind, const std::string& key) const {
  if (!enabled()) return std::nullopt;
  const fs::path path = pathOf(kind, key);
  auto file = readFile(path, FILE_MAX);
  // The time of the last change is that of the last use.
  if (file) utimensat(AT_FDCWD, path.c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
  return file;
}

void DiskCache::write(Kind kind, const std::string& key, std::span<const std::byte> file) const {
  if (!enabled() || file.size() > maxBytes_) return;
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (writeFileAtomically(pathOf(kind, key), file)) sweep();
}

void DiskCache::sweep() const {
  std::vector<Kept> kept;
  std::uint64_t bytes = 0;
  std::error_code failure;
  const auto now = fs::file_time_type::clock::now();
  for (fs::directory_iterator at(folder_, failure), end; !failure && at != end; at.increment(failure)) {
    const State state = stateOf(at->path().filename().string());
    std::error_code gone;  // another process sweeps too
    if (state == State::kOther || at->symlink_status(gone).type() != fs::file_type::regular) continue;
    const Kept file{at->path(), at->last_write_time(gone), at->file_size(gone)};
    if (gone) continue;
    if (state == State::kEntry) {
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

}  // namespace telar
