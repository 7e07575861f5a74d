#pragma once
#include "pass/plan/draw_list.h"

namespace telar::pass {

/// Size of a pixel where a box is next to the camera, metres.   bounds  world space
double pixelSize(const FramePlan& plan, const Bounds& bounds, const Shot& shot);

/// How many times larger than in its mesh an item is drawn, at most.
double scaleOf(const DrawItem& item);

}  // namespace telar::pass
