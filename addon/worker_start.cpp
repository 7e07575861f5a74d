// Of libtelar_worker.so: before a worker's program runs, it takes the steps that are possible only then.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>

#include "first_steps.h"

namespace {

/// js/pool/environment.mjs sets it. What a worker starts has the library too, and is no worker.
constexpr const char* IS_WORKER = "TELAR_IS_WORKER";

bool areTaken = false;
telar::addon::FirstFailures failures{};

/// Mesa's list of the programs that it has on disk: 65,536 names of 20 bytes, and their size.
constexpr off_t PROGRAM_LIST_BYTES = 65536 * 20 + 8;

/// Mesa maps that list into memory, and leaves holes in it: where the disk is full, what writes to one is ended (SIGBUS).
/// So it is filled before; where that cannot be, no programs are kept.
void fillProgramList() {
  const char* folder = std::getenv("MESA_SHADER_CACHE_DIR");
  if (!folder) return;
  char file[PATH_MAX];
  const int length = std::snprintf(file, sizeof file, "%s/mesa_shader_cache/index", folder);
  if (length < 0 || length >= static_cast<int>(sizeof file)) return;
  const int place = open(file, O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  const int failure = place == -1 ? errno : posix_fallocate(place, 0, PROGRAM_LIST_BYTES);
  if (place != -1) close(place);
  if (failure == ENOSPC || failure == EDQUOT) setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
}

[[gnu::constructor]] void startWorker() {
  if (!std::getenv(IS_WORKER)) return;
  unsetenv(IS_WORKER);
  failures = telar::addon::takeFirstSteps();
  unsetenv(telar::addon::WORKER_FOLDERS);
  fillProgramList();
  areTaken = true;
}

}  // namespace

/// The addon looks it up by this name (isolation.cpp).
extern "C" [[gnu::visibility("default")]] const telar::addon::FirstFailures* telarFirstFailures() {
  return areTaken ? &failures : nullptr;
}
