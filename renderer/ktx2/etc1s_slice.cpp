#include <numeric>

#include "ktx2/etc1s.h"

namespace telar::ktx2 {
namespace {

constexpr std::uint32_t REPEAT_PREDICTIONS = 256;  ///< after the 4^4 predictions of 2 x 2 blocks
constexpr std::uint32_t REPEAT_LEAST = 3;
constexpr std::uint32_t RUN_LEAST = 3;
constexpr std::uint32_t RUN_LONG = 63;  ///< the run's length follows

/// Where a block's endpoint comes from.
enum Prediction : std::uint32_t { LEFT = 0, ABOVE = 1, ABOVE_LEFT = 2, CODED = 3 };

/// Predictions of endpoints: one symbol for 2 x 2 blocks, with runs of equal ones.
class Predictions {
 public:
  Predictions(const Etc1sCodebooks& codebooks, BitReader& from, std::uint32_t blocksX)
      : table_(codebooks.endpointPrediction), from_(from), below_((blocksX + 1) / 2) {}

  std::uint32_t next(std::uint32_t x, std::uint32_t y) {
    if (x % 2 == 0) {
      if (y % 2 == 0) {
        bits_ = readGroup();
        below_[x / 2] = static_cast<std::uint8_t>(bits_ >> 4);
      } else {
        bits_ = below_[x / 2];
      }
    }
    const std::uint32_t out = bits_ & 3;
    bits_ >>= 2;
    return out;
  }

 private:
  std::uint32_t readGroup() {
    if (repeat_ > 0) {
      --repeat_;
      return last_;
    }
    const std::uint32_t symbol = table_.decode(from_);
    if (symbol > REPEAT_PREDICTIONS) throw corrupt("a block is predicted in an unknown way");
    if (symbol < REPEAT_PREDICTIONS) return last_ = symbol;
    repeat_ = std::uint64_t{from_.groups(4)} + REPEAT_LEAST - 1;
    return last_;
  }

  const HuffmanTable& table_;
  BitReader& from_;
  std::vector<std::uint8_t> below_;  ///< what a symbol says of the row below
  std::uint32_t bits_ = 0, last_ = 0;
  std::uint64_t repeat_ = 0;
};

/// The selectors used of late: a new one goes into the upper half in turn, one that is used moves half way to the
/// front.
class SelectorHistory {
 public:
  explicit SelectorHistory(std::uint32_t size) : values_(size), next_(size / 2) {}

  void add(std::uint16_t selector) {
    if (values_.empty()) return;
    values_[next_] = selector;
    if (++next_ == values_.size()) next_ = values_.size() / 2;
  }

  std::uint16_t use(std::uint32_t index) {
    if (index >= values_.size()) throw corrupt("a block uses a selector that was not kept");
    const std::uint16_t out = values_[index];
    std::swap(values_[index], values_[index / 2]);
    return out;
  }

 private:
  std::vector<std::uint16_t> values_;
  std::size_t next_;
};

class Selectors {
 public:
  Selectors(const Etc1sCodebooks& codebooks, BitReader& from)
      : codebooks_(codebooks), from_(from), history_(codebooks.historySize) {}

  std::uint16_t next() {
    const auto count = static_cast<std::uint32_t>(codebooks_.selectors.size());
    const std::uint32_t symbol = readSymbol(count);
    if (symbol >= count) return history_.use(symbol - count);
    history_.add(static_cast<std::uint16_t>(symbol));
    return static_cast<std::uint16_t>(symbol);
  }

 private:
  /// Below `count` a selector, above it a place in the history; a run repeats the first place.
  std::uint32_t readSymbol(std::uint32_t count) {
    if (run_ > 0) {
      --run_;
      return count;
    }
    const std::uint32_t symbol = codebooks_.selector.decode(from_);
    if (symbol != count + codebooks_.historySize) return symbol;
    const std::uint32_t run = codebooks_.selectorRun.decode(from_);
    run_ = std::uint64_t{run == RUN_LONG ? from_.groups(7) : run} + RUN_LEAST - 1;
    return count;
  }

  const Etc1sCodebooks& codebooks_;
  BitReader& from_;
  SelectorHistory history_;
  std::uint64_t run_ = 0;
};

}  // namespace

std::vector<Etc1sBlock> decodeSlice(const Etc1sCodebooks& codebooks, Bytes slice, std::uint32_t blocksX,
                                    std::uint32_t blocksY, const CancelToken& cancel) {
  BitReader from(slice);
  Predictions predictions(codebooks, from, blocksX);
  Selectors selectors(codebooks, from);
  const auto endpoints = static_cast<std::uint32_t>(codebooks.endpoints.size());
  std::vector<Etc1sBlock> out(std::size_t{blocksX} * blocksY);
  std::uint32_t endpoint = 0;
  for (std::uint32_t y = 0; y < blocksY; ++y) {
    cancel.check();
    Etc1sBlock* row = out.data() + std::size_t{y} * blocksX;
    const Etc1sBlock* above = y > 0 ? row - blocksX : nullptr;
    for (std::uint32_t x = 0; x < blocksX; ++x) {
      const std::uint32_t prediction = predictions.next(x, y);
      const bool outside = (x == 0 && (prediction == LEFT || prediction == ABOVE_LEFT)) ||
                           (y == 0 && (prediction == ABOVE || prediction == ABOVE_LEFT));
      if (outside) throw corrupt("a block is predicted from outside the image");
      if (prediction == ABOVE) endpoint = above[x].endpoint;
      if (prediction == ABOVE_LEFT) endpoint = above[x - 1].endpoint;
      if (prediction == CODED) {
        endpoint += codebooks.endpointDelta.decode(from);
        if (endpoint >= endpoints) endpoint -= endpoints;
        if (endpoint >= endpoints) throw corrupt("a block uses an endpoint that does not exist");
      }
      row[x].endpoint = static_cast<std::uint16_t>(endpoint);
      row[x].selector = selectors.next();
    }
  }
  return out;
}

}  // namespace telar::ktx2
