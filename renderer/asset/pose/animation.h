#pragma once
#include <set>
#include <utility>

#include "asset/geometry/geometry.h"

namespace telar::asset {

/// Reads the animations of a document.
class AnimationReader {
 public:
  /// @param nodes by node of the file: its index in the scene, -1 = not in it
  AnimationReader(const GeometryReader::Sources& from, const std::vector<int>& nodes);

  /// All animations, in the file's order.
  /// @throws Error{E_ANIMATION, E_REF, E_SPARSE, L_KEYFRAME_VALUES, X_CANCELLED}
  std::vector<Animation> read();

 private:
  Animation readAnimation(std::size_t index);
  void addChannel(const tinygltf::Animation& source, const tinygltf::AnimationChannel& channel,
                  const std::string& where, Animation& out);
  AnimationSampler readSampler(const tinygltf::AnimationSampler& source, std::size_t width, const std::string& where);
  std::vector<float> readTimes(int accessor, const std::string& where);
  Interpolation interpolationOf(const tinygltf::AnimationSampler& source, const std::string& where) const;
  /// Whether three.js finds morphed meshes at a node: not behind a joint, nor where several primitives share the node
  /// with a camera or a light.
  bool animatesWeights(int node) const;
  std::size_t widthOf(AnimationPath path, int node) const;
  void count(std::uint64_t values, const std::string& where);

  const GeometryReader::Sources& from_;
  const std::vector<int>& nodes_;
  std::vector<bool> joints_;                         ///< by node of the file: it is a joint of some skin
  std::set<std::pair<int, AnimationPath>> targets_;  ///< of the animation that is being read
  std::uint64_t values_ = 0;                         ///< read so far
};

/// How many morph targets the meshes of a node's primitives have at most.
std::size_t morphTargetsOf(const tinygltf::Model& model, int node);

}  // namespace telar::asset
