#include "shader/library.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "telar/error.h"

namespace telar::shader {
namespace {

constexpr std::string_view INCLUDE = "#include \"";

constexpr std::string_view REPEAT = "#repeat ", END = "#end", INDEX = "INDEX";

/// The lines up to #end once for each i below the define that #repeat names, with i in place of INDEX: GLSL ES 3.00 has
/// no other way to go through an array of samplers.
std::string repeated(std::istream& in, std::string_view name, const Defines& defines) {
  const auto found =
      std::find_if(defines.begin(), defines.end(), [&](const auto& define) { return define.first == name; });
  if (found == defines.end()) throw Error("X_SHADER", "#repeat " + quoted(name) + " is not among the defines");
  std::string body, out;
  for (std::string line; std::getline(in, line) && line != END;) body += line + '\n';
  for (int i = 0; i < found->second; ++i) {
    for (std::size_t from = 0; from < body.size();) {
      const std::size_t at = std::min(body.find(INDEX, from), body.size());
      out.append(body, from, at - from);
      if (at < body.size()) out += std::to_string(i);
      from = at + INDEX.size();
    }
  }
  return out;
}

struct Includer {
  const Defines& defines;
  std::set<std::string, std::less<>> open, done;
  std::string out;

  void append(std::string_view file) {
    const auto found = embeddedFiles().find(file);
    if (found == embeddedFiles().end()) throw Error("X_SHADER", "no shader file " + quoted(file));
    if (!open.emplace(file).second) throw Error("X_SHADER", "shader file " + quoted(file) + " includes itself");
    std::istringstream in(found->second);
    for (std::string line; std::getline(in, line);) {
      if (line.rfind(INCLUDE, 0) == 0) {
        const std::string included = line.substr(INCLUDE.size(), line.rfind('"') - INCLUDE.size());
        if (!done.contains(included)) append(included);
      } else if (line.rfind(REPEAT, 0) == 0) {
        out += repeated(in, std::string_view(line).substr(REPEAT.size()), defines);
      } else {
        out += line + '\n';
      }
    }
    open.erase(open.find(file));
    done.emplace(file);
  }
};

}  // namespace

std::string assemble(std::string_view file, const Defines& defines) {
  Includer includer{defines, {}, {}, {}};
  includer.out = "#version 300 es\n";
  for (const auto& [name, value] : defines) includer.out += "#define " + name + " " + std::to_string(value) + "\n";
  includer.append(file);
  return std::move(includer.out);
}

}  // namespace telar::shader
