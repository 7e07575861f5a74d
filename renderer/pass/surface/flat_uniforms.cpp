#include "pass/surface/flat_uniforms.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

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

/// What the preprocessor takes out, as far as sums and products of plain defines tell.
class Conditions {
 public:
  void read(const std::string& line) {
    if (line.rfind("#define ", 0) == 0) {
      std::istringstream words(line.substr(8));
      std::string name;
      if (int value = 0; words >> name >> value) defines_[name] = value;
    } else if (line.rfind("#if", 0) == 0) {
      out_.push_back(line.rfind("#if ", 0) == 0 && isZero(line.substr(4)));
    } else if ((line.rfind("#else", 0) == 0 || line.rfind("#elif", 0) == 0) && !out_.empty()) {
      out_.back() = false;
    } else if (line.rfind("#endif", 0) == 0 && !out_.empty()) {
      out_.pop_back();
    }
  }
  bool takenOut() const { return std::ranges::find(out_, true) != out_.end(); }

 private:
  std::map<std::string, int, std::less<>> defines_;
  std::vector<bool> out_;  ///< of each #if that is open

  static std::vector<std::string> split(const std::string& text, const std::string& by) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t at; (at = text.find(by, from)) != std::string::npos; from = at + by.size())
      parts.push_back(text.substr(from, at - from));
    parts.push_back(text.substr(from));
    return parts;
  }
  bool isZero(const std::string& expression) const {
    return std::ranges::all_of(split(expression, " || "), [&](const std::string& term) {
      return std::ranges::any_of(split(term, " && "), [&](const std::string& factor) {
        const bool negated = factor[0] == '!';
        const auto found = defines_.find(negated ? factor.substr(1) : factor);
        return found != defines_.end() && (found->second != 0) == negated;
      });
    });
  }
};

}  // namespace

StageTexts withFlatUniforms(StageTexts texts) {
  std::string fragment, declarations, assignments;
  std::set<std::string, std::less<>> handed;
  Conditions conditions;
  int floats = 0;
  std::istringstream in(texts.fragment);
  for (std::string line; std::getline(in, line); fragment += line + '\n') {
    conditions.read(line);
    if (line.rfind(UNIFORM, 0) != 0 || conditions.takenOut()) continue;
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
    declarations.append("uniform ").append(type).append(" ").append(source);
    declarations.append(";\nflat out ").append(type).append(" ").append(name).append(";\n");
    assignments.append("  ").append(name).append(" = ").append(source).append(";\n");
  }
  texts.fragment = std::move(fragment);
  std::string& vertex = texts.vertex;
  vertex.insert(vertex.find('\n') + 1, "precision highp int;\n" + declarations);
  vertex.insert(vertex.rfind('}'), assignments);
  return texts;
}

}  // namespace telar::pass
