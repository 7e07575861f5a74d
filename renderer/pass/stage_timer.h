#pragma once
#include <chrono>
#include <nlohmann/json.hpp>

namespace telar::pass {

/// Milliseconds of each stage, in order; of all its passes where there are several. By a clock that only says how long
/// something took.
class StageTimer {
 public:
  /// Ends a stage that began at the last lap, or with the timer.
  void lap(const char* stage) {
    const auto now = Clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    stages_[stage] = stages_.value(stage, 0.0) + ms;
    last_ = now;
  }
  const nlohmann::ordered_json& json() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  nlohmann::ordered_json stages_ = nlohmann::ordered_json::object();
};

}  // namespace telar::pass
