#include "faults.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace telar::numerics {

std::string readText(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot open " + file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<Fault> readFaults(const std::string& jsonFile) {
  std::vector<Fault> faults;
  for (const nlohmann::json& item : nlohmann::json::parse(readText(jsonFile))) {
    Fault fault{item.at("name"), {}, {}};
    for (const nlohmann::json& edit : item.at("edits"))
      fault.edits.push_back({edit.at("file"), edit.at("find"), edit.at("replace")});
    for (const auto& [check, fails] : item.at("found").items()) fault.finders.push_back({check, fails});
    faults.push_back(std::move(fault));
  }
  return faults;
}

std::size_t placeOf(const Edit& edit, const std::string& text) {
  const std::size_t at = text.find(edit.find);
  if (at == std::string::npos) throw std::runtime_error(edit.file + " does not hold: " + edit.find);
  if (text.find(edit.find, at + 1) != std::string::npos)
    throw std::runtime_error(edit.file + " holds more than once: " + edit.find);
  return at;
}

}  // namespace telar::numerics
