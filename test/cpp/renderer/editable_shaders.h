#pragma once
#include <string>

namespace telar::test {

/// Changes the shader text that this program embeds, before anything is compiled.
/// @param jsonFile  list of {"file": path below shaders/, "find": text, "replace": text}
/// @throws std::runtime_error where `find` does not stand in the file exactly once.
void editShaders(const std::string& jsonFile);

}  // namespace telar::test
