#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <string>
#include <vector>

#include "telar/shot/pose.inc"

/// What a file says of things that move, or that are drawn many times. Plain data, checked: every index is in range.
namespace telar {

/// Translation in metres, quaternion (x, y, z, w) as the file or an animation gives it, factors.
struct Transform {
  glm::dvec3 translation{0};
  glm::dvec4 rotation{0, 0, 0, 1};
  glm::dvec3 scale{1};
};

/// What one morph target adds to each vertex of a primitive at weight 1. A stream is empty where the target leaves it
/// as it is; else it has an entry for each vertex.
struct MorphTarget {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> colors;
};

/// What moves the vertices of a primitive besides its node.
struct Deformers {
  std::vector<MorphTarget> targets;
  std::vector<glm::u16vec4> joints;  ///< by vertex; empty = cannot be skinned
  std::vector<glm::vec4> weights;    ///< as many; finite, normalized as three.js does it
};

struct Skin {
  std::vector<int> joints;                     ///< index into Scene::nodes; -1 = not in the drawn scene, at the origin
  std::vector<glm::mat4> inverseBindMatrices;  ///< by joint
};

/// EXT_mesh_gpu_instancing: places of a node's mesh, in the node's space.
struct Instances {
  std::vector<glm::mat4> matrices;  ///< finite
  std::vector<glm::vec3> colors;    ///< linear, by instance; empty = white
  std::vector<glm::dvec3> centers;  ///< by primitive of the mesh: of the sphere around all instances
};

enum class AnimationPath { kTranslation, kRotation, kScale, kWeights };
enum class Interpolation { kLinear, kStep, kCubicSpline };

struct AnimationSampler {
  Interpolation interpolation = Interpolation::kLinear;
  std::size_t width = 0;      ///< numbers of one value: 3, 4, or the number of morph targets
  std::vector<float> times;   ///< seconds; at least one, finite, not falling
  std::vector<float> values;  ///< times.size() values; with kCubicSpline in-tangent, value, out-tangent for each time
};

struct AnimationChannel {
  int node = -1;  ///< index into Scene::nodes
  AnimationPath path = AnimationPath::kTranslation;
  AnimationSampler sampler;
};

/// Channels that move something of the drawn scene; no two move the same.
struct Animation {
  std::string name;     ///< "animation_<index>" where the file has none
  double duration = 0;  ///< seconds, the last time of all channels
  std::vector<AnimationChannel> channels;
};

/// All of a scene that can move.
struct Motion {
  std::vector<Animation> animations;
  std::vector<Skin> skins;
};

/// A moment of an animation. What is before its start or after its end stands as at the start or the end.
/// `animation` is an index into Motion::animations.
using Pose = shot::Pose;

}  // namespace telar
