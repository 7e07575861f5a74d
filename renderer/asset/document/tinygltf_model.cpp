#include <fstream>  // tinygltf's writer, which nothing here calls, needs it even without file access

#define TINYGLTF_IMPLEMENTATION
#include <limits>
#include <new>

#include "asset/check/pointer.h"
#include "asset/document/tinygltf_model.h"

namespace telar::asset {
namespace {

// The document that tinygltf gets names no file and no image, so these are never called; should that change, they
// refuse. Nothing outside the given text is ever read by it.
bool noFile(const std::string&, void*) { return false; }
std::string noPath(const std::string&, void*) { return {}; }
bool noRead(std::vector<unsigned char>*, std::string* error, const std::string&, void*) {
  if (error) *error += "file access is switched off";
  return false;
}
bool noWrite(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }
bool noImage(tinygltf::Image*, const int, std::string* error, std::string*, int, int, const unsigned char*, int,
             void*) {
  if (error) *error += "image access is switched off";
  return false;
}

}  // namespace

tinygltf::Model parseModel(const std::string& json) {
  if (json.size() > std::numeric_limits<unsigned int>::max()) {
    checkLimit("L_JSON_BYTES", std::numeric_limits<unsigned int>::max(), static_cast<double>(json.size()));
  }
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({noFile, noPath, noRead, noWrite, nullptr});
  parser.SetImageLoader(noImage, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const bool done = parser.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                               static_cast<unsigned int>(json.size()), {}, tinygltf::NO_REQUIRE);
  // It catches all exceptions: that memory is short is not the document's fault.
  if (!done && error == std::bad_alloc().what()) throw std::bad_alloc();
  if (!done) fail("E_SCHEMA", "the glTF document cannot be read: " + telar::quoted(error), "");
  return model;
}

}  // namespace telar::asset
