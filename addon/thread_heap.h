#pragma once

namespace telar::addon {

/// A frame takes some 60 MB of the heap of the thread that draws it, and gives them back. Left to itself, glibc maps each
/// large block anew and unmaps it, and lets the heap of a thread grow page by page: some 2,000 faults a frame, and 10,000
/// more for the first one. To be called once by a thread that will draw, before all else: it takes as much, so that what
/// is freed stays, and asks for large pages. Where memory is short, all is as before.
void growHeapOfThread();

}  // namespace telar::addon
