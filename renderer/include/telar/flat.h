#pragma once
#include <string>
#include <string_view>

#include "telar/cancel.h"
#include "telar/image.h"
#include "telar/renderer.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar {

/// The technical flat of a scene as lines: silhouettes, contours, seams, stitches, creases, without what is hidden
/// (Benard and Hertzmann 2019, "Line Drawings from 3D Models: A Tutorial"). The request, which js/api/flat.mjs writes:
/// {part: {kind, which} | null, join: metres, creaseAngle: degrees, foldDepth: metres, foldLength: pixels, tolerance:
/// pixels, stitched: [{kind, which}, ...]}
/// @param shot  its camera, size and variant
/// @return JSON: {strokes: [{kind, closed, points: [[x, y], ...]}, ...], worldToPixel: [16], triangles}; pixels, y down
/// @throws Error{E_MEASURE (no such part), L_TRIANGLES, X_CANCELLED, X_TIMEOUT}
std::string drawFlat(const Scene& scene, const Shot& shot, std::string_view request, const CancelToken& cancel);

/// The layer of lines: the flat of the shot's own settings as antialiased pixels, 0 on its lines, 1 on the paper.
/// @throws Error{L_TRIANGLES, X_CANCELLED, X_TIMEOUT}
LayerImage drawLines(const Scene& scene, const Shot& shot, const CancelToken& cancel);

/// The picture of a shot of Style::kFlat: black lines on its background.
/// @param lines  of drawLines()
Frame flatFrame(const LayerImage& lines, const Shot& shot);

/// What info says of such a frame.
std::string describeFlat(const Shot& shot, double milliseconds);

}  // namespace telar
