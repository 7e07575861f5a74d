// plant_faults FAULTS.json PROJECT OUTPUT: copies the shading text, and the C++ files that faults change, to OUTPUT,
// with every fault in its place and `planted(number)` to choose it when the program runs: one compilation serves all
// faults. src: Untch, Offutt & Harrold 1993, "Mutation Analysis Using Mutant Schemata"
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>

#include "faults.h"

namespace {

using telar::numerics::Edit;
using telar::numerics::Fault;
namespace fs = std::filesystem;

struct Change {
  std::string find;
  std::map<int, std::string> replaceByFault;
};

/// The text of `find` with its faults: `planted(n) ? (fault) : (text)`, or the same of statements.
std::string withChoice(const Change& change) {
  const bool statement = change.find.back() == ';';
  std::string text = statement ? "{ " + change.find + " }" : "(" + change.find + ")";
  for (const auto& [fault, replace] : change.replaceByFault) {
    const std::string condition = "planted(" + std::to_string(fault) + ")";
    text = statement ? "if (" + condition + ") { " + replace + " } else " + text
                     : "(" + condition + " ? (" + replace + ") : " + text + ")";
  }
  return text;
}

std::string withFaults(const std::string& file, std::string text, const std::vector<Fault>& faults) {
  std::map<std::size_t, Change> changes;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    for (const Edit& edit : faults[i].edits) {
      if (edit.file != file) continue;
      Change& change = changes[telar::numerics::placeOf(edit, text)];
      if (!change.find.empty() && change.find != edit.find)
        throw std::runtime_error(file + ": two faults change one place in two lengths: " + edit.find);
      change.find = edit.find;
      change.replaceByFault[static_cast<int>(i) + 1] = edit.replace;
    }
  }
  for (auto change = changes.rbegin(); change != changes.rend(); ++change)  // from the end: places stay
    text.replace(change->first, change->second.find.size(), withChoice(change->second));
  return text;
}

/// Leaves a file alone that is so already: nothing is compiled again for it.
void write(const fs::path& file, const std::string& text) {
  if (fs::exists(file) && telar::numerics::readText(file) == text) return;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

void plant(const std::string& list, const fs::path& project, const fs::path& output) {
  const std::vector<Fault> faults = telar::numerics::readFaults(list);
  const auto copy = [&](const fs::path& file) {
    write(output / file, withFaults(file.generic_string(), telar::numerics::readText(project / file), faults));
  };
  for (const auto& entry : fs::recursive_directory_iterator(project / "shaders"))
    if (entry.path().extension() == ".glsl") copy(fs::relative(entry.path(), project));
  for (const Fault& fault : faults)
    for (const Edit& edit : fault.edits)
      if (fs::path(edit.file).extension() == ".cpp") copy(edit.file);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) return std::fputs("usage: plant_faults FAULTS.json PROJECT OUTPUT\n", stderr), 2;
  plant(argv[1], argv[2], argv[3]);
  return 0;
} catch (const std::exception& error) {
  return std::fprintf(stderr, "plant_faults: %s\n", error.what()), 1;
}
