#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace telar::shader {

/// `#define NAME value`, in order.
using Defines = std::vector<std::pair<std::string, int>>;

/// Text of shaders/, by path below it ("brdf/fresnel.glsl"). Constant data of the program.
const std::map<std::string, std::string, std::less<>>& embeddedFiles();

/// The full text of a stage: "#version 300 es", the defines, then the file with its #include lines replaced, each file
/// once. The lines from `#repeat NAME` to `#end` are repeated as often as the define says, with the number of the turn
/// in place of INDEX. Features are tested with #if, never #ifdef, so every one must be among the defines.
/// @throws Error{X_SHADER} for an unknown file or an include cycle.
std::string assemble(std::string_view file, const Defines& defines);

}  // namespace telar::shader
