#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "asset/accessor/accessor.h"

namespace telar::asset {

/// Reads skin weights and morph targets of one primitive, as three.js's GLTFLoader takes them.
class DeformerReader {
 public:
  /// Reads one attribute of the primitive as floats (`components * vertices` of them).
  using StreamReader = std::function<void(const std::string& name, std::span<float> out)>;

  /// @param where  JSON pointer of the primitive
  /// @param joints how many joints the smallest of its skins has; 0 = no skin moves the primitive
  DeformerReader(const Accessors& accessors, const CancelToken& cancel, Warnings& warnings,
                 const tinygltf::Primitive& source, const std::string& where, std::size_t joints)
      : accessors_(accessors), cancel_(cancel), warnings_(warnings), source_(source), where_(where), joints_(joints) {}

  /// What the accessors are, before any of them is read. @throws Error{E_ACCESSOR, E_SKIN}
  void check() const;

  /// What read() will allocate, from counts alone.
  std::uint64_t bytes() const;

  /// @param base the primitive's own streams
  /// @return null where nothing deforms it
  /// @throws Error{E_SKIN, E_SPARSE, X_CANCELLED}
  std::shared_ptr<const Deformers> read(const Primitive& base, const StreamReader& stream) const;

 private:
  int attribute(const std::string& name) const;
  bool skinned() const;
  void checkSkin() const;
  void checkTarget(const std::string& name, int accessor, const std::string& where) const;
  void readSkin(const StreamReader& stream, Deformers& out) const;
  void readTargets(const Primitive& base, Deformers& out) const;
  MorphTarget readTarget(const std::map<std::string, int>& target, const Primitive& base) const;
  bool anyTargetHas(const std::string& name) const;

  const Accessors& accessors_;
  const CancelToken& cancel_;
  Warnings& warnings_;
  const tinygltf::Primitive& source_;
  std::string where_;
  std::size_t joints_;
};

}  // namespace telar::asset
