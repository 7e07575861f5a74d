#pragma once
#include <vector>

#include "asset/check/warnings.h"
#include "asset/document/tinygltf_model.h"
#include "telar/cancel.h"
#include "telar/limits.h"

namespace telar::asset {

/// A node of the drawn scene, by its index in the file and in the list itself.
struct Visit {
  int node = -1;
  int parent = -1;  ///< index into the list, -1 = root
};

/// Checks that the nodes form trees (all nodes, reached or not), without recursion, and lists those of the drawn scene,
/// parents before children: the file's default scene, else its first, else all roots (W_NO_SCENE).
/// @throws Error{E_GRAPH, L_NODE_DEPTH, X_CANCELLED}
std::vector<Visit> walkScene(const tinygltf::Model& model, const Limits& limits, const CancelToken& cancel,
                             Warnings& warnings);

}  // namespace telar::asset
