#include "editable_shaders.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "shader/library.h"

// The generated text under another name. The linker then takes the embeddedFiles() below in place of the library's, so
// that the library itself needs no way to change it.
#define embeddedFiles unchangedFiles
#include "embedded.cpp"
#undef embeddedFiles

namespace telar {
namespace {

using Files = std::map<std::string, std::string, std::less<>>;

Files& editableFiles() {
  static Files files = shader::unchangedFiles();
  return files;
}

void edit(const nlohmann::json& change) {
  const std::string file = change.at("file"), find = change.at("find"), replace = change.at("replace");
  const auto found = editableFiles().find(file);
  if (found == editableFiles().end()) throw std::runtime_error("no shader file " + file);
  std::string& text = found->second;
  const std::size_t at = text.find(find);
  if (at == std::string::npos) throw std::runtime_error(file + " does not hold: " + find);
  if (text.find(find, at + 1) != std::string::npos) throw std::runtime_error(file + " holds more than once: " + find);
  text.replace(at, find.size(), replace);
}

}  // namespace

const Files& shader::embeddedFiles() { return editableFiles(); }

void test::editShaders(const std::string& jsonFile) {
  std::ifstream in(jsonFile);
  if (!in) throw std::runtime_error("cannot open " + jsonFile);
  for (const nlohmann::json& change : nlohmann::json::parse(in)) edit(change);
}

}  // namespace telar
