#include "asset/pose/animation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

std::optional<AnimationPath> pathOf(const std::string& name) {
  if (name == "translation") return AnimationPath::kTranslation;
  if (name == "rotation") return AnimationPath::kRotation;
  if (name == "scale") return AnimationPath::kScale;
  if (name == "weights") return AnimationPath::kWeights;
  return std::nullopt;
}

/// Values for each time.
std::size_t valuesPerTime(Interpolation interpolation) {
  return interpolation == Interpolation::kCubicSpline ? 3 : 1;  // tangents stand before and after the value
}

}  // namespace

std::size_t morphTargetsOf(const tinygltf::Model& model, int node) {
  const int mesh = model.nodes[static_cast<std::size_t>(node)].mesh;
  if (mesh < 0) return 0;
  std::size_t most = 0;
  for (const auto& primitive : model.meshes[static_cast<std::size_t>(mesh)].primitives) {
    most = std::max(most, primitive.targets.size());
  }
  return most;
}

AnimationReader::AnimationReader(const GeometryReader::Sources& from, const std::vector<int>& nodes)
    : from_(from), nodes_(nodes), joints_(nodes.size(), false) {
  for (const auto& skin : from.document.model.skins) {
    for (const int joint : skin.joints) joints_[static_cast<std::size_t>(joint)] = true;
  }
}

bool AnimationReader::animatesWeights(int node) const {
  const auto& model = from_.document.model;
  const auto& source = model.nodes[static_cast<std::size_t>(node)];
  if (morphTargetsOf(model, node) == 0 || joints_[static_cast<std::size_t>(node)]) return false;
  const bool single = model.meshes[static_cast<std::size_t>(source.mesh)].primitives.size() == 1;
  return single || (source.camera < 0 && !source.extensions.contains("KHR_lights_punctual"));
}

void AnimationReader::count(std::uint64_t values, const std::string& where) {
  values_ += values;
  checkLimit("L_KEYFRAME_VALUES", static_cast<double>(from_.limits.keyframeValues), static_cast<double>(values_),
             where);
  from_.memory.charge(values * sizeof(float), where);
}

std::vector<float> AnimationReader::readTimes(int accessor, const std::string& where) {
  const auto& info = from_.accessors.info(accessor);
  if (info.type != TINYGLTF_TYPE_SCALAR || info.componentType != COMPONENT_F32) {
    fail("E_ANIMATION", "the times of an animation must be SCALAR floats", where);
  }
  count(info.count, where);
  std::vector<float> out(info.count);
  from_.accessors.readFloats(accessor, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!std::isfinite(out[i]) || (i > 0 && out[i] < out[i - 1])) {
      fail("E_ANIMATION",
           "time " + std::to_string(i) + " of the animation is not finite or falls behind the one before", where);
    }
  }
  return out;
}

Interpolation AnimationReader::interpolationOf(const tinygltf::AnimationSampler& source,
                                               const std::string& where) const {
  if (source.interpolation == "STEP") return Interpolation::kStep;
  if (source.interpolation == "CUBICSPLINE") return Interpolation::kCubicSpline;
  if (source.interpolation != "LINEAR") {
    from_.warnings.add("W_ENUM",
                       "the interpolation " + telar::quoted(source.interpolation) + " is unknown; LINEAR is used",
                       where + "/interpolation");
  }
  return Interpolation::kLinear;
}

std::size_t AnimationReader::widthOf(AnimationPath path, int node) const {
  if (path == AnimationPath::kRotation) return 4;
  return path == AnimationPath::kWeights ? morphTargetsOf(from_.document.model, node) : 3;
}

AnimationSampler AnimationReader::readSampler(const tinygltf::AnimationSampler& source, std::size_t width,
                                              const std::string& where) {
  AnimationSampler out;
  out.interpolation = interpolationOf(source, where);
  out.width = width;
  out.times = readTimes(source.input, where + "/input");
  const auto& info = from_.accessors.info(source.output);
  const std::uint64_t components = from_.accessors.components(source.output);
  const bool scalars = info.type == TINYGLTF_TYPE_SCALAR;  // one morph weight each
  if ((!scalars && (components != width || info.type > TINYGLTF_TYPE_VEC4)) || info.componentType == COMPONENT_U32) {
    fail("E_ANIMATION", "the values of the animation have a type that their target cannot have", where + "/output");
  }
  const std::uint64_t wanted = out.times.size() * valuesPerTime(out.interpolation) * width;
  count(wanted, where + "/output");
  if (info.count * components != wanted) {
    fail("E_ANIMATION",
         "the animation needs " + std::to_string(wanted / components) + " values for its times, it has " +
             std::to_string(info.count),
         where + "/output");
  }
  out.values.resize(wanted);
  from_.accessors.readFloats(source.output, out.values);
  return out;
}

void AnimationReader::addChannel(const tinygltf::Animation& source, const tinygltf::AnimationChannel& channel,
                                 const std::string& where, Animation& out) {
  if (static_cast<std::size_t>(channel.sampler) >= source.samplers.size()) {
    fail("E_REF", "the index names a sampler that the animation does not have", where + "/sampler");
  }
  if (channel.target_node < 0) return;  // an extension's target: three.js leaves it out
  const auto path = pathOf(channel.target_path);
  const bool weights = path == AnimationPath::kWeights;
  if (weights && !animatesWeights(channel.target_node)) {
    from_.warnings.add("W_ANIMATION", "the channel moves no morph target that three.js would move", where);
    return;
  }
  const auto& sampler = source.samplers[static_cast<std::size_t>(channel.sampler)];
  const std::string whereSampler = where.substr(0, where.find("/channels")) + pointer("samplers", channel.sampler);
  const int node = nodes_[static_cast<std::size_t>(channel.target_node)];
  if (!path || node < 0) {
    from_.warnings.add("W_ANIMATION",
                       !path ? "the path " + telar::quoted(channel.target_path) + " is unknown"
                             : std::string("the node is not in the drawn scene"),
                       where + "/target");
    out.duration = std::max<double>(out.duration, readTimes(sampler.input, whereSampler + "/input").back());
    return;
  }
  if (!targets_.emplace(node, *path).second) {
    fail("E_ANIMATION", "two channels of the animation have the same target", where + "/target");
  }
  out.channels.push_back({node, *path, readSampler(sampler, widthOf(*path, channel.target_node), whereSampler)});
  out.duration = std::max<double>(out.duration, out.channels.back().sampler.times.back());
}

Animation AnimationReader::readAnimation(std::size_t index) {
  const auto& source = from_.document.model.animations[index];
  Animation out;
  targets_.clear();
  out.name = source.name.empty() ? "animation_" + std::to_string(index) : source.name;
  for (std::size_t i = 0; i < source.channels.size(); ++i) {
    from_.cancel.check();
    addChannel(source, source.channels[i], pointer("animations", index, "channels", i), out);
  }
  return out;
}

std::vector<Animation> AnimationReader::read() {
  std::vector<Animation> out;
  for (std::size_t i = 0; i < from_.document.model.animations.size(); ++i) out.push_back(readAnimation(i));
  return out;
}

}  // namespace telar::asset
