#include "surface/chain.h"

#include <map>
#include <optional>
#include <utility>

namespace telar::surface {
namespace {

class Walker {
 public:
  Walker(const std::vector<std::array<std::uint32_t, 2>>& links, const CancelToken& cancel)
      : links_(links), used_(links.size()), cancel_(cancel) {
    for (std::uint32_t i = 0; i < links.size(); ++i) {
      for (const std::uint32_t node : links[i]) at_[node].links.push_back(i);
    }
  }

  std::vector<Chain> walkAll() {
    for (auto& [node, at] : at_) {
      if (at.links.size() % 2 == 1) walk(node);
    }
    for (auto& [node, at] : at_) {
      while (firstLeft(at)) walk(node);
    }
    return std::move(chains_);
  }

 private:
  /// Links of a node, in order. Those before `next` are used.
  struct Node {
    std::vector<std::uint32_t> links;
    std::size_t next = 0;
  };

  std::optional<std::uint32_t> firstLeft(Node& at) const {
    while (at.next < at.links.size() && used_[at.links[at.next]]) ++at.next;
    if (at.next == at.links.size()) return std::nullopt;
    return at.links[at.next];
  }

  void walk(std::uint32_t node) {
    cancel_.check();
    Chain chain{{node}, false};
    do {
      const auto link = firstLeft(at_.at(node));
      if (!link) break;
      used_[*link] = true;
      node = links_[*link][0] == node ? links_[*link][1] : links_[*link][0];
      chain.nodes.push_back(node);
    } while (node != chain.nodes.front());
    if (chain.nodes.size() < 2) return;
    if (chain.nodes.back() == chain.nodes.front()) {
      chain.closed = true;
      chain.nodes.pop_back();
    }
    chains_.push_back(std::move(chain));
  }

  const std::vector<std::array<std::uint32_t, 2>>& links_;
  std::vector<char> used_;
  const CancelToken& cancel_;
  std::map<std::uint32_t, Node> at_;  ///< by node
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<Chain> chainLinks(const std::vector<std::array<std::uint32_t, 2>>& links, const CancelToken& cancel) {
  return Walker(links, cancel).walkAll();
}

}  // namespace telar::surface
