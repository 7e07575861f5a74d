#pragma once
#include <optional>

namespace telar::addon {

/// Allocations of this process that failed, as libtelar_worker.so counts them; nothing where that library is not
/// loaded or does not see them.
std::optional<unsigned> failedAllocations();

}  // namespace telar::addon
