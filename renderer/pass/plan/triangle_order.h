#pragma once
#include "pass/plan/draw_list.h"
#include "telar/cancel.h"

namespace telar::pass {

/// Puts the triangles of DrawItem::ordered draws in order, far to near: a net or sheer cloth shows what lies behind it, its
/// own folds too. By the middles of the triangles, so those that cross are in no order; meshes go one after the other.
/// @throws Error{X_CANCELLED}
void orderTriangles(FramePlan& plan, const CancelToken& cancel);

}  // namespace telar::pass
