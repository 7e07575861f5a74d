#pragma once
#include <string>

#include "asset/document/tinygltf_model.h"

namespace telar::asset {

/// The array at `key` of an object; an empty one where there is none. Types are known from the schema.
inline const tinygltf::Value::Array& arrayOf(const tinygltf::Value& object, const std::string& key) {
  static const tinygltf::Value::Array NONE;
  return object.Has(key) ? object.Get(key).Get<tinygltf::Value::Array>() : NONE;
}

/// The number at `key`, or `fallback`.
inline double numberOf(const tinygltf::Value& object, const std::string& key, double fallback) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

}  // namespace telar::asset
