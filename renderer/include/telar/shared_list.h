#pragma once
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace telar {

/// A list that cannot be changed and whose copies share its items: copying it costs nothing, and an item keeps its
/// address in every copy, and in the lists that it is joined to.
template <typename T>
class SharedList {
  using Items = std::vector<std::shared_ptr<const T>>;

 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;

    Iterator() = default;
    explicit Iterator(typename Items::const_iterator at) : at_(at) {}
    const T& operator*() const { return **at_; }
    const T* operator->() const { return at_->get(); }
    Iterator& operator++() { return ++at_, *this; }
    Iterator operator++(int) { return Iterator(at_++); }
    bool operator==(const Iterator&) const = default;

   private:
    typename Items::const_iterator at_;
  };

  SharedList() = default;
  SharedList(std::vector<T> items) : SharedList(std::make_shared<const std::vector<T>>(std::move(items))) {}
  explicit SharedList(const std::shared_ptr<const std::vector<T>>& all) {
    Items out;
    out.reserve(all->size());
    for (const T& item : *all) out.emplace_back(all, &item);
    items_ = std::make_shared<const Items>(std::move(out));
  }
  SharedList(std::initializer_list<T> items) : SharedList(std::vector<T>(items)) {}

  std::size_t size() const { return items_->size(); }
  bool empty() const { return items_->empty(); }
  const T& operator[](std::size_t i) const { return *(*items_)[i]; }
  const T& at(std::size_t i) const { return *items_->at(i); }
  Iterator begin() const { return Iterator(items_->begin()); }
  Iterator end() const { return Iterator(items_->end()); }

  /// The items of this list, then those of the other.
  SharedList joined(const SharedList& other) const {
    Items all = *items_;
    all.insert(all.end(), other.items_->begin(), other.items_->end());
    SharedList out;
    out.items_ = std::make_shared<const Items>(std::move(all));
    return out;
  }

 private:
  std::shared_ptr<const Items> items_ = std::make_shared<const Items>();
};

}  // namespace telar
