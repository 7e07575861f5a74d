#include "pass/flat_uniforms.h"

#include <array>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "gl/program.h"

namespace telar::pass {
namespace {

constexpr std::string_view UNIFORM = "uniform ";

/// Floats of a type that is handed on, else 0.
int floatsOf(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, int>, 6> TYPES{
      {{"float", 1}, {"int", 1}, {"vec2", 2}, {"vec3", 3}, {"vec4", 4}, {"mat3", 9}}};
  for (const auto& [name, floats] : TYPES) {
    if (name == type) return floats;
  }
  return 0;
}

}  // namespace

StageTexts withFlatUniforms(StageTexts texts) {
  std::string fragment, declarations, assignments;
  std::set<std::string, std::less<>> handed;
  int floats = 0;
  std::istringstream in(texts.fragment);
  for (std::string line; std::getline(in, line); fragment += line + '\n') {
    if (line.rfind(UNIFORM, 0) != 0) continue;
    const std::size_t typeEnd = line.find(' ', UNIFORM.size()), end = line.find_first_of(";[", UNIFORM.size());
    if (typeEnd >= end || end == std::string::npos || line[end] == '[') continue;
    const std::string type = line.substr(UNIFORM.size(), typeEnd - UNIFORM.size());
    const std::string name = line.substr(typeEnd + 1, end - typeEnd - 1);
    const bool isKnown = handed.contains(name);
    const int size = floatsOf(type);
    if (size == 0 || (!isKnown && floats + size > MOST_HANDED)) continue;
    line.replace(0, UNIFORM.size(), "flat in ");
    if (isKnown) continue;
    handed.insert(name);
    floats += size;
    const std::string source = std::string(gl::HANDED_ON) + name;
    declarations += "uniform " + type + " " + source + ";\nflat out " + type + " " + name + ";\n";
    assignments += "  " + name + " = " + source + ";\n";
  }
  texts.fragment = std::move(fragment);
  std::string& vertex = texts.vertex;
  vertex.insert(vertex.find('\n') + 1, "precision highp int;\n" + declarations);
  vertex.insert(vertex.rfind('}'), assignments);
  return texts;
}

}  // namespace telar::pass
