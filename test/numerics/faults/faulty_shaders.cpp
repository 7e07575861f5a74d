// The shaders of the renderer with the planted fault in their text.
#include <map>

#include "faults.h"
#include "planted.h"
#include "shader/library.h"

// The generated text under another name. The linker then takes the embeddedFiles() below in place of the library's, so
// that the library itself needs no way to change it.
#define embeddedFiles unchangedFiles
#include "embedded.cpp"
#undef embeddedFiles

namespace telar {

int plantedFault = 0;

namespace shader {

const std::map<std::string, std::string, std::less<>>& embeddedFiles() {
  using Files = std::map<std::string, std::string, std::less<>>;
  static std::map<int, Files> byFault;
  const auto [found, isNew] = byFault.try_emplace(plantedFault, unchangedFiles());
  if (isNew && plantedFault > 0) {
    static const std::vector<numerics::Fault> faults = numerics::readFaults(TELAR_FAULTS);
    for (const numerics::Edit& edit : faults.at(static_cast<std::size_t>(plantedFault) - 1).edits) {
      constexpr std::string_view FOLDER = "shaders/";
      if (edit.file.rfind(FOLDER, 0) != 0) continue;
      std::string& text = found->second.at(edit.file.substr(FOLDER.size()));
      text.replace(numerics::placeOf(edit, text), edit.find.size(), edit.replace);
    }
  }
  return found->second;
}

}  // namespace shader
}  // namespace telar
