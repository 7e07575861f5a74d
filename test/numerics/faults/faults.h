#pragma once
#include <string>
#include <vector>

namespace telar::numerics {

/// One change of a text.
struct Edit {
  std::string file;     ///< below the project's folder
  std::string find;     ///< stands there once: an expression, or a statement with its semicolon
  std::string replace;  ///< what stands there with the fault
};

/// A check that finds a fault.
struct Finder {
  std::string check;
  std::vector<std::string> fails;  ///< its figures that are off their bars then
};

/// A fault that a renderer, or the suite, may have.
struct Fault {
  std::string name;
  std::vector<Edit> edits;
  std::vector<Finder> finders;
};

/// faults.json, in order. The first has number 1. @throws std::runtime_error
std::vector<Fault> readFaults(const std::string& jsonFile);

/// Where `find` stands in the text. @throws std::runtime_error unless it stands there exactly once
std::size_t placeOf(const Edit& edit, const std::string& text);

std::string readText(const std::string& file);

}  // namespace telar::numerics
