#pragma once
#include <functional>

namespace telar::reference {

/// Runs rows on several threads until all are done or one fails; rethrows what that one threw.
/// @param threads  at least 1
void forEachRow(int rows, int threads, const std::function<void(int)>& job);

}  // namespace telar::reference
