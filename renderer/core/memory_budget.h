#pragma once
#include <cstdint>
#include <string_view>

#include "telar/error.h"

namespace telar {

/// The bytes that one model takes, on the CPU and on the GPU, counted before they are allocated.
class MemoryBudget {
 public:
  /// @param most  Limits::memoryBytes
  explicit MemoryBudget(std::uint64_t most) : most_(most) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// Bytes that the model keeps. @throws Error{L_MEMORY_BYTES}
  void charge(std::uint64_t bytes, std::string_view pointer = {}) { kept_ += granted(bytes, pointer); }

  /// Bytes that only a step of loading needs: given back when the loan ends.
  class Loan {
   public:
    Loan(Loan&& from) noexcept : budget_(from.budget_), bytes_(from.bytes_) { from.bytes_ = 0; }
    Loan& operator=(Loan&&) = delete;
    ~Loan() { budget_.lent_ -= bytes_; }
    /// Lends more, up to so many bytes together. @throws Error{L_MEMORY_BYTES}
    void growTo(std::uint64_t bytes, std::string_view pointer = {}) {
      if (bytes <= bytes_) return;
      budget_.lent_ += budget_.granted(bytes - bytes_, pointer);
      bytes_ = bytes;
    }

   private:
    friend class MemoryBudget;
    Loan(MemoryBudget& budget, std::uint64_t bytes) : budget_(budget), bytes_(bytes) { budget_.lent_ += bytes; }
    MemoryBudget& budget_;
    std::uint64_t bytes_;
  };
  /// @throws Error{L_MEMORY_BYTES}
  [[nodiscard]] Loan lend(std::uint64_t bytes, std::string_view pointer = {}) {
    return Loan(*this, granted(bytes, pointer));
  }

  std::uint64_t kept() const { return kept_; }

 private:
  std::uint64_t granted(std::uint64_t bytes, std::string_view pointer) const {
    const std::uint64_t used = kept_ + lent_;
    if (bytes > most_ - used) {
      checkSum("L_MEMORY_BYTES", static_cast<double>(most_), static_cast<double>(used) + static_cast<double>(bytes),
               pointer);
    }
    return bytes;
  }

  std::uint64_t most_;
  std::uint64_t kept_ = 0, lent_ = 0;  ///< together never over most_
};

}  // namespace telar
