#include "surface/chain.h"

#include <algorithm>
#include <map>

namespace telar::surface {
namespace {

class Walker {
 public:
  explicit Walker(const std::vector<std::array<std::uint32_t, 2>>& links) : links_(links), used_(links.size()) {
    for (std::uint32_t i = 0; i < links.size(); ++i) {
      for (const std::uint32_t node : links[i]) at_[node].push_back(i);
    }
  }

  std::vector<Chain> walkAll() {
    for (const auto& [node, links] : at_) {
      for (std::size_t i = 0; i < links.size() % 2; ++i) walk(node);
    }
    for (const auto& [node, links] : at_) {
      while (hasLink(node)) walk(node);
    }
    return std::move(chains_);
  }

 private:
  bool hasLink(std::uint32_t node) const {
    const auto& links = at_.at(node);
    return std::any_of(links.begin(), links.end(), [this](std::uint32_t i) { return !used_[i]; });
  }

  void walk(std::uint32_t node) {
    Chain chain{{node}, false};
    for (bool goesOn = true; goesOn;) {
      goesOn = false;
      for (const std::uint32_t i : at_.at(node)) {
        if (used_[i]) continue;
        used_[i] = true;
        node = links_[i][0] == node ? links_[i][1] : links_[i][0];
        chain.nodes.push_back(node);
        goesOn = node != chain.nodes.front();
        break;
      }
    }
    if (chain.nodes.size() < 2) return;
    if (chain.nodes.back() == chain.nodes.front()) {
      chain.closed = true;
      chain.nodes.pop_back();
    }
    chains_.push_back(std::move(chain));
  }

  const std::vector<std::array<std::uint32_t, 2>>& links_;
  std::vector<char> used_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> at_;  ///< links by node, in order
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<Chain> chainLinks(const std::vector<std::array<std::uint32_t, 2>>& links) {
  return Walker(links).walkAll();
}

}  // namespace telar::surface
