#pragma once
#include <string>
#include <vector>

#include "telar/scene.h"

namespace telar::asset {

/// Collects warnings: at most 100, each once.
class Warnings {
 public:
  Warnings() = default;
  /// Goes on from a list.
  explicit Warnings(std::vector<Warning> list) : list_(std::move(list)) {}

  void add(std::string_view code, std::string message, std::string pointer = {});
  std::size_t count() const { return list_.size(); }
  std::vector<Warning> take() { return std::move(list_); }

 private:
  std::vector<Warning> list_;
};

}  // namespace telar::asset
