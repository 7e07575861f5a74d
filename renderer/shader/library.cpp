#include "shader/library.h"

#include <set>
#include <sstream>

#include "telar/error.h"

namespace telar::shader {
namespace {

constexpr std::string_view INCLUDE = "#include \"";

struct Includer {
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
  Includer includer;
  includer.out = "#version 300 es\n";
  for (const auto& [name, value] : defines) includer.out += "#define " + name + " " + std::to_string(value) + "\n";
  includer.append(file);
  return std::move(includer.out);
}

}  // namespace telar::shader
