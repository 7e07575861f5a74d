// Of libtelar_worker.so: before a worker's program runs, it takes the steps that are possible only then.
#include <cstdlib>

#include "first_steps.h"

namespace {

/// js/pool/environment.mjs sets it. What a worker starts has the library too, and is no worker.
constexpr const char* IS_WORKER = "TELAR_IS_WORKER";

bool areTaken = false;
telar::addon::FirstFailures failures{};

[[gnu::constructor]] void startWorker() {
  if (!std::getenv(IS_WORKER)) return;
  unsetenv(IS_WORKER);
  failures = telar::addon::takeFirstSteps();
  unsetenv(telar::addon::WORKER_FOLDERS);
  areTaken = true;
}

}  // namespace

/// The addon looks it up by this name (isolation.cpp).
extern "C" [[gnu::visibility("default")]] const telar::addon::FirstFailures* telarFirstFailures() {
  return areTaken ? &failures : nullptr;
}
