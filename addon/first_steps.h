#pragma once
#include <sys/prctl.h>

#include <array>
#include <cerrno>
#include <tuple>

namespace telar::addon {

/// errno of a call that gives -1, else 0.
inline int failureOf(long result) { return result == -1 ? errno : 0; }

/// No program that this process starts gives it rights. 0, or errno.
inline int forgoPrivileges() { return failureOf(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)); }

/// What a worker of a pool gives up before its program runs: later it has threads, and descriptors of its own.
struct FirstStep {
  const char* name;
  /// Takes it. No heap: it runs in the loader, and between fork() and _exit(). 0, or errno.
  int (*take)();
};

/// In order. No descriptor above the pipe to the parent (3), which programs in between may have left open across exec;
/// what another preloaded library opens in its constructor is taken for one of these, too.
/// A network namespace of its own, without an interface, and without the abstract sockets of this machine: by the right
/// to make one, or in a user namespace where the process has no right that it would lose there.
/// No file is changed, made or removed but in WORKER_FOLDERS, devices, and what /proc has of the process itself.
extern const std::array<FirstStep, 3> FIRST_STEPS;

/// Of the environment (js/pool/environment.mjs): folders that a worker writes to, a line each.
inline constexpr const char* WORKER_FOLDERS = "TELAR_WORKER_FOLDERS";

using FirstFailures = std::array<int, std::tuple_size_v<decltype(FIRST_STEPS)>>;

/// Takes all. errno of each, 0 where it was taken.
FirstFailures takeFirstSteps();

/// What libtelar_worker.so, preloaded into a worker, took of them; null where it did not. Looked up by name.
inline constexpr const char* FIRST_FAILURES_SYMBOL = "telarFirstFailures";
using FirstFailuresFunction = const FirstFailures*();

}  // namespace telar::addon
