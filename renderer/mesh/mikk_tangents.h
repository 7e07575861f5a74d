#pragma once
#include "telar/scene.h"

namespace telar {

/// Gives a triangle primitive the tangents that normal maps are baked against: MikkTSpace with its default threshold of
/// 180 degrees, without the quad rule (glTF has triangles only).
/// @param source    kTriangles with normals and uvs[texCoord], all finite; normals are normalised for the computation
/// @param texCoord  0 or 1: the set that the normal texture reads
/// @return  the primitive with `tangents` filled: unit, at right angles to the normal, w = +-1 by glTF's convention, in
///          which bitangent = cross(normal, tangent) * w points to where v falls (the texture's up). A vertex whose
///          corners disagree is repeated at the end of each stream; vertices keep their places otherwise, and the
///          corners of each triangle stay in order. An unindexed primitive stays unindexed. Corners that UVs say
///          nothing about (collapsed triangles or UVs) get some unit tangent. Unchanged when it is not triangles, is
///          empty, or lacks the normals or the UV set.
/// The same input gives the same bytes. O(n log n) time, O(n) memory, no recursion.
/// @throws std::bad_alloc
/// src: Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited" (thesis), chapter 4, and the behaviour of its
///      reference implementation
Primitive withMikkTangents(const Primitive& source, int texCoord = 0);

}  // namespace telar
