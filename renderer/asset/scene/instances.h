#pragma once
#include <memory>

#include "asset/geometry/geometry.h"

namespace telar::asset {

/// How many instances EXT_mesh_gpu_instancing asks for at this node; 1 where three.js draws the mesh once: without the
/// extension, without attributes, or where a primitive of the mesh is not of triangles. Nothing is read yet.
/// @throws Error{E_INSTANCING} where the attributes' types or counts are wrong
std::uint64_t countInstances(int node, const GeometryReader::Sources& from);

/// Reads a node's instances; null where the mesh is drawn once. Instances that are not finite are left out.
/// @param mesh as read
/// @throws Error{E_SPARSE, X_CANCELLED}
std::shared_ptr<const Instances> readInstances(int node, const Mesh& mesh, const GeometryReader::Sources& from);

}  // namespace telar::asset
