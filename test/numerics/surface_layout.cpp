// SurfaceInfo member by member, read from its declaration: a member that somebody adds is tested from then on.
#include <cstring>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "shader/library.h"
#include "surface_point.h"

namespace telar::numerics {
namespace {

/// Numbers that a type is made of; 0 = not one that SurfaceInfo may have.
std::size_t widthOf(const std::string& type) {
  static const std::map<std::string, std::size_t> widths{{"float", 1}, {"int", 1},  {"vec2", 2},
                                                         {"vec3", 3},  {"vec4", 4}, {"mat3", 9}};
  const auto found = widths.find(type);
  return found == widths.end() ? 0 : found->second;
}

/// The lines of the struct's body.
std::vector<std::string> declaration() {
  std::istringstream in(shader::embeddedFiles().at("material/surface_types.glsl"));
  std::vector<std::string> lines;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("struct SurfaceInfo", 0) == 0) {
      inside = true;
    } else if (inside && line.rfind("};", 0) == 0) {
      return lines;
    } else if (inside) {
      lines.push_back(line);
    }
  }
  throw std::runtime_error("SurfaceInfo is not where it was");
}

struct Member {
  std::string type, name;
};

/// The member that a line declares; empty for any other line.
Member memberIn(const std::string& line) {
  static const std::regex pattern(R"(^\s*(\w+)\s+(\w+)\s*;)");
  std::smatch match;
  if (!std::regex_search(line, match, pattern)) return {};
  if (widthOf(match[1]) == 0) throw std::runtime_error("SurfaceInfo has a member of an unknown type: " + line);
  return {match[1], match[2]};
}

struct Slot {
  std::size_t single, wide;  ///< offsets, bytes
  bool integer;
};

/// Where each number lies in both structs. @throws std::runtime_error where the compiler laid them out otherwise
std::vector<Slot> layOut() {
  std::vector<Slot> slots;
  std::size_t single = 0, wide = 0;
  for (const std::string& line : declaration()) {
    const Member member = memberIn(line);
    const bool integer = member.type == "int";
    for (std::size_t i = 0; i < widthOf(member.type); ++i) {
      const std::size_t size = integer ? sizeof(int) : sizeof(double);
      wide = (wide + size - 1) / size * size;
      slots.push_back({single, wide, integer});
      single += 4;
      wide += size;
    }
  }
  wide = (wide + sizeof(double) - 1) / sizeof(double) * sizeof(double);
  if (single != sizeof(brdf_f::SurfaceInfo) || wide != sizeof(brdf_d::SurfaceInfo))
    throw std::runtime_error("SurfaceInfo has members beside those of surface_types.glsl");
  return slots;
}

const std::vector<Slot>& slots() {
  static const std::vector<Slot> laidOut = layOut();
  return laidOut;
}

template <class T>
T read(const void* from, std::size_t offset) {
  T value;
  std::memcpy(&value, static_cast<const char*>(from) + offset, sizeof(T));
  return value;
}

template <class T>
void write(void* to, std::size_t offset, T value) {
  std::memcpy(static_cast<char*>(to) + offset, &value, sizeof(T));
}

}  // namespace

std::size_t numberCount() { return slots().size(); }

std::vector<float> numbersOf(const brdf_f::SurfaceInfo& info) {
  std::vector<float> numbers;
  for (const Slot& slot : slots())
    numbers.push_back(slot.integer ? static_cast<float>(read<int>(&info, slot.single))
                                   : read<float>(&info, slot.single));
  return numbers;
}

brdf_d::SurfaceInfo inDouble(const brdf_f::SurfaceInfo& info) {
  brdf_d::SurfaceInfo wide{};
  for (const Slot& slot : slots()) {
    if (slot.integer) {
      write(&wide, slot.wide, read<int>(&info, slot.single));
    } else {
      write(&wide, slot.wide, static_cast<double>(read<float>(&info, slot.single)));
    }
  }
  return wide;
}

std::string glslReader(std::size_t first) {
  std::string text;
  for (const std::string& line : declaration()) {
    if (line.rfind("#", 0) == 0) text += line + "\n";
    const Member member = memberIn(line);
    const std::size_t width = widthOf(member.type);
    if (width == 0) continue;
    text += "s." + member.name + " = " + member.type + "(";
    for (std::size_t i = 0; i < width; ++i) text += (i ? ", p[" : "p[") + std::to_string(first++) + "]";
    text += ");\n";
  }
  return text;
}

}  // namespace telar::numerics
