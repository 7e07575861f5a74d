#pragma once
// Declarations of tinygltf with its file access and image decoders compiled out; tinygltf_model.cpp holds the one
// implementation. Every file that needs the types includes this header, so that the macros agree.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_USE_CPP14

// Hidden, but not what it includes: a hidden __assert_fail, for one, cannot be found in libc.
#include <cassert>
#include <nlohmann/json.hpp>
#include <string>

#pragma GCC visibility push(hidden)
#include <tiny_gltf.h>
#pragma GCC visibility pop

namespace telar::asset {

/// Parses a reduced document (schema.h) that has neither buffers nor images.
/// @throws Error{E_SCHEMA}
tinygltf::Model parseModel(const std::string& json);

}  // namespace telar::asset
