#pragma once

namespace telar::addon {

/// Grows the heap of the calling thread by 62 MiB at once and asks for large pages there. To be called by a thread that
/// draws, before all else: a frame takes about as much and frees it. Without it, glibc maps and unmaps large blocks, and
/// grows the heap of a thread page by page: 2,000 page faults a frame, and 10,000 more for the first one. Where memory is
/// short, nothing changes.
void growHeapOfThread();

}  // namespace telar::addon
