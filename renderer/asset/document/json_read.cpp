#include "asset/document/json_read.h"

#include <string>
#include <vector>

#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

using nlohmann::json;

constexpr int NUMBER_OVERFLOW = 406;  // nlohmann::json::out_of_range, "number overflow"
constexpr std::uint64_t VALUES_PER_CANCEL_CHECK = 4096;

/// Receives the parser's events and builds the document.
class Builder : public nlohmann::json_sax<json> {
 public:
  Builder(std::uint64_t fileOffset, const Limits& limits, const CancelToken& cancel)
      : fileOffset_(fileOffset), limits_(limits), cancel_(cancel) {}

  json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // JSON text has none
  bool start_object(std::size_t) override { return open(json::value_t::object); }
  bool start_array(std::size_t) override { return open(json::value_t::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    keys_.back() = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& fault) override {
    if (fault.id == NUMBER_OVERFLOW) fail("E_SCHEMA", "a number is too large for glTF", where());
    const std::uint64_t offset = fileOffset_ + (position > 0 ? position - 1 : 0);
    throw Error("E_JSON", "the glTF JSON is not well formed (syntax or UTF-8) at byte " + std::to_string(offset))
        .atOffset(offset);
  }

 private:
  bool add(json&& value) {
    place(std::move(value));
    return true;
  }

  bool open(json::value_t type) {
    checkSum("L_JSON_DEPTH", static_cast<double>(limits_.jsonDepth), static_cast<double>(open_.size() + 1));
    open_.push_back(place(json(type)));
    keys_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  json* place(json&& value) {
    if (++values_ % VALUES_PER_CANCEL_CHECK == 0) cancel_.check();
    checkSum("L_JSON_VALUES", static_cast<double>(limits_.jsonValues), static_cast<double>(values_));
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    json& parent = *open_.back();
    // Elements stay where they are while one of them is open: a parent grows only after its child is closed.
    if (parent.is_array()) return &parent.emplace_back(std::move(value));
    json& slot = parent[keys_.back()];
    slot = std::move(value);
    return &slot;
  }

  std::string where() const {
    std::string out;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (open_[i]->is_array()) {
        const bool last = i + 1 == open_.size();
        addToken(out, open_[i]->size() - (last ? 0 : 1));
      } else {
        addToken(out, keys_[i]);
      }
    }
    return out;
  }

  std::uint64_t fileOffset_;
  const Limits& limits_;
  const CancelToken& cancel_;
  json root_;
  std::vector<json*> open_;
  std::vector<std::string> keys_;  ///< of the open objects; empty for arrays
  std::uint64_t values_ = 0;
};

}  // namespace

json readJson(std::string_view text, std::uint64_t fileOffset, const Limits& limits, const CancelToken& cancel) {
  // The parser takes a NUL for the end of the text and would not see what follows.
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    throw Error("E_JSON", "the glTF JSON contains a NUL byte; pad with spaces").atOffset(fileOffset + nul);
  }
  Builder builder(fileOffset, limits, cancel);
  json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace telar::asset
