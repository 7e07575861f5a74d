#pragma once
#include <cstdint>
#include <string>

namespace telar::addon {

/// Takes rights from this process that drawing does not need, for good: no new privileges, no core dump, few files,
/// bounded memory, no ptrace by others, the end of the parent is its own, and no system call that opens a network,
/// starts a program or reaches another process. A step that the kernel refuses does not stop the others.
/// @param dataBytes bytes of memory that the process may write to (RLIMIT_DATA); 0 = no bound
/// @return JSON: [{step, failure: null | string}], in order
std::string isolateProcess(std::uint64_t dataBytes);

/// What isolateProcess() would come to on this machine: a child does it, and ends. The same JSON.
std::string probeIsolation();

}  // namespace telar::addon
