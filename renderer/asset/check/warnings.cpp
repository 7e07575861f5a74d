#include "asset/check/warnings.h"

#include <algorithm>

namespace telar::asset {
namespace {
constexpr std::size_t WARNINGS_MAX = 100;
}

void Warnings::add(std::string_view code, std::string message, std::string pointer) {
  if (list_.size() >= WARNINGS_MAX) return;
  const auto alike = [&](const Warning& w) { return w.code == code && w.message == message && w.pointer == pointer; };
  if (std::any_of(list_.begin(), list_.end(), alike)) return;
  list_.push_back({std::string(code), std::move(message), std::move(pointer)});
}

}  // namespace telar::asset
