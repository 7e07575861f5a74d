#pragma once

namespace telar::addon {

/// Grows the heap of the calling thread by 62 MiB of addresses at once. To be called by a thread that draws, before all
/// else: a frame takes about as much and frees it. Without it, glibc maps and unmaps large blocks, which is 2,000 page
/// faults a frame, and grows the heap of a thread page by page. Where memory is short, nothing changes.
void growHeapOfThread();

}  // namespace telar::addon
