// SurfaceInfo member by member, read from its declaration: a member that somebody adds is tested from then on.
#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>

#include "shader/library.h"
#include "surface_point.h"

namespace telar::numerics {
namespace {

/// Numbers that a type of the language is made of; 0 = a struct.
std::size_t widthOf(const std::string& type) {
  static const std::map<std::string, std::size_t> widths{{"float", 1}, {"int", 1},  {"vec2", 2},
                                                         {"vec3", 3},  {"vec4", 4}, {"mat3", 9}};
  const auto found = widths.find(type);
  return found == widths.end() ? 0 : found->second;
}

/// The lines of a struct's body.
std::vector<std::string> declarationOf(const std::string& type) {
  for (const auto& [path, text] : shader::embeddedFiles()) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
      if (line.rfind("struct " + type + " ", 0) == 0) {
        inside = true;
      } else if (inside && line.rfind("};", 0) == 0) {
        return lines;
      } else if (inside) {
        lines.push_back(line);
      }
    }
  }
  throw std::runtime_error("no shader declares struct " + type);
}

struct Member {
  std::string type, name;
};

/// The member that a line declares; empty for any other line.
Member memberIn(const std::string& line) {
  std::istringstream words(line.substr(0, line.find(';')));
  Member member;
  std::string more;
  const auto isWord = [](const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  };
  const bool isOne = line.find(';') != std::string::npos && words >> member.type >> member.name && !(words >> more);
  return isOne && isWord(member.type) && isWord(member.name) ? member : Member{};
}

/// Terms, which only C++ chooses at run time: of a principled shading, or of a release of three.js. Empty for any other
/// type.
std::vector<std::string> termMembers(const std::string& type, const std::string& prefix) {
  std::vector<std::string> lines;
#define TELAR_TERM_LINE(define, member, ...) lines.push_back("int " + prefix + #member);
  if (type == "ShadingTerms") {
    TELAR_SHADING_SLOTS(TELAR_TERM_LINE)
  } else if (type == "ThreeTerms") {
    TELAR_THREE_SLOTS(TELAR_TERM_LINE)
  }
#undef TELAR_TERM_LINE
  return lines;
}

/// A struct's lines with the members of inner structs in their place, "outer.inner"; preprocessor lines stay.
std::vector<std::string> flattened(const std::string& type, const std::string& prefix) {
  std::vector<std::string> lines;
  for (const std::string& line : declarationOf(type)) {
    const Member member = memberIn(line);
    if (line.rfind("#", 0) == 0) {
      lines.push_back(line);
    } else if (member.type.empty()) {
      continue;
    } else if (widthOf(member.type) > 0) {
      lines.push_back(member.type + " " + prefix + member.name);
    } else {
      const std::string outer = prefix + member.name + ".";
      std::vector<std::string> inner = termMembers(member.type, outer);
      if (inner.empty()) inner = flattened(member.type, outer);
      lines.insert(lines.end(), inner.begin(), inner.end());
    }
  }
  return lines;
}

/// As flattened(); of a line that is no member, the type is empty and the name is the line.
std::vector<Member> declaration() {
  std::vector<Member> list;
  for (const std::string& line : flattened("SurfaceInfo", "")) {
    const std::size_t space = line.find(' ');
    const bool member = line[0] != '#';
    list.push_back(member ? Member{line.substr(0, space), line.substr(space + 1)} : Member{"", line});
  }
  return list;
}

struct Slot {
  std::size_t single, wide;  ///< offsets, bytes
  bool integer;
};

/// Where each number lies in both structs. @throws std::runtime_error where the compiler laid them out otherwise
std::vector<Slot> layOut() {
  std::vector<Slot> slots;
  std::size_t single = 0, wide = 0;
  for (const Member& member : declaration()) {
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
  for (const Member& member : declaration()) {
    const std::size_t width = widthOf(member.type);
    if (width == 0) {
      text += member.name + "\n";
      continue;
    }
    text += "s." + member.name + " = " + member.type + "(";
    for (std::size_t i = 0; i < width; ++i) text += (i ? ", p[" : "p[") + std::to_string(first++) + "]";
    text += ");\n";
  }
  return text;
}

}  // namespace telar::numerics
