#include "asset/scene/graph.h"

#include <algorithm>

#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

const tinygltf::Node& nodeAt(const tinygltf::Model& model, int index) {
  return model.nodes[static_cast<std::size_t>(index)];
}

/// True for each node that is a child of another. @throws Error{E_GRAPH} where one is a child twice
std::vector<bool> findChildren(const tinygltf::Model& model) {
  std::vector<bool> child(model.nodes.size(), false);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const auto& children = model.nodes[i].children;
    for (std::size_t k = 0; k < children.size(); ++k) {
      const auto node = static_cast<std::size_t>(children[k]);
      if (child[node]) fail("E_GRAPH", "a node has two parents", pointer("nodes", i, "children", k));
      child[node] = true;
    }
  }
  return child;
}

std::vector<int> rootsOf(const std::vector<bool>& child) {
  std::vector<int> roots;
  for (std::size_t i = 0; i < child.size(); ++i) {
    if (!child[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

/// Breadth first from `roots`. Every node has at most one parent, so none is met twice.
std::vector<Visit> walk(const tinygltf::Model& model, const std::vector<int>& roots, const Limits& limits,
                        const CancelToken& cancel) {
  std::vector<Visit> order;
  order.reserve(model.nodes.size());
  for (const int root : roots) order.push_back({root, -1});
  std::uint64_t depth = 1;
  std::size_t levelEnd = order.size();
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % 1024 == 0) cancel.check();
    if (i == levelEnd) {
      levelEnd = order.size();
      checkSum("L_NODE_DEPTH", static_cast<double>(limits.nodeDepth), static_cast<double>(++depth),
               pointer("nodes", order[i].node));
    }
    for (const int child : nodeAt(model, order[i].node).children) order.push_back({child, static_cast<int>(i)});
  }
  return order;
}

}  // namespace

std::vector<Visit> walkScene(const tinygltf::Model& model, const Limits& limits, const CancelToken& cancel,
                             Warnings& warnings) {
  const std::vector<bool> child = findChildren(model);
  const std::vector<int> allRoots = rootsOf(child);
  std::vector<Visit> all = walk(model, allRoots, limits, cancel);
  if (all.size() != model.nodes.size()) {
    std::vector<bool> met(model.nodes.size(), false);
    for (const Visit& visit : all) met[static_cast<std::size_t>(visit.node)] = true;
    const auto missed = static_cast<std::size_t>(std::find(met.begin(), met.end(), false) - met.begin());
    fail("E_GRAPH", "the node is part of a cycle", pointer("nodes", missed));
  }
  if (model.scenes.empty()) {
    if (!all.empty()) warnings.add("W_NO_SCENE", "the file has no scene; all root nodes are drawn", "/scenes");
    return all;
  }
  const std::size_t scene = model.defaultScene >= 0 ? static_cast<std::size_t>(model.defaultScene) : 0;
  const auto& roots = model.scenes[scene].nodes;
  std::vector<bool> met(model.nodes.size(), false);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const auto node = static_cast<std::size_t>(roots[k]);
    if (child[node] || met[node]) {
      fail("E_GRAPH", "a scene must list root nodes, each once", pointer("scenes", scene, "nodes", k));
    }
    met[node] = true;
  }
  return walk(model, roots, limits, cancel);
}

}  // namespace telar::asset
