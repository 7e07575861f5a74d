#pragma once
#include <cstdint>
#include <string>

namespace telar::addon {

/// Takes rights from this process that drawing does not need, for good: no new privileges, no core dump, few files,
/// bounded memory, no ptrace by others, the end of the parent is its own, and no system call that opens a network,
/// starts a program or reaches another process. A step that the kernel refuses does not stop the others. What
/// libtelar_worker.so gave up at the start (first_steps.h) is told first.
/// @param dataBytes bytes of memory that the process may write to (RLIMIT_DATA); 0 = no bound
/// @return JSON: [{step, failure?: null | string}], in order; a step that nobody took has no failure
std::string isolateProcess(std::uint64_t dataBytes);

/// What isolateProcess() would come to in a worker on this machine: a child does it, and ends. The same JSON.
/// @param withFirst whether a worker has libtelar_worker.so
std::string probeIsolation(bool withFirst);

}  // namespace telar::addon
