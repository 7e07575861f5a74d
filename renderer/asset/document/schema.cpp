#include "asset/document/schema.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "asset/check/pointer.h"
#include "core/json_text.h"

namespace telar::asset {
namespace {

using nlohmann::json;

constexpr std::size_t NAME_MAX_BYTES = 1024;
constexpr std::uint64_t OBJECTS_PER_CANCEL_CHECK = 1024;
constexpr std::size_t NO_INDEX = ~std::size_t{0};

/// A place in the document, as a chain up to the root; the pointer is only written when something is wrong there.
struct Where {
  const Where* parent = nullptr;
  std::string_view key = {};
  std::size_t index = NO_INDEX;

  std::string pointer() const {
    std::string out = parent ? parent->pointer() : std::string();
    if (!parent) return out;
    index == NO_INDEX ? addToken(out, key) : addToken(out, index);
    return out;
  }
};

[[noreturn]] void wrongType(const char* expected, const json& value, const Where& where) {
  fail("E_SCHEMA", std::string("expected ") + expected + " here, got " + shown(value), where.pointer());
}

class Reducer {
 public:
  Reducer(const json& document, const Limits& limits, const CancelToken& cancel)
      : document_(document), limits_(limits), cancel_(cancel) {}

  json object(const ObjectRule& rule, const json& value, const Where& where) {
    if (!value.is_object()) wrongType("an object", value, where);
    if (++objects_ % OBJECTS_PER_CANCEL_CHECK == 0) cancel_.check();
    json out = json::object();
    for (const Field& field : rule.fields) {
      const Where here{&where, field.key};
      const auto found = value.find(field.key);
      if (found != value.end()) {
        out.emplace(field.key, property(field, *found, here));
      } else if (field.required) {
        fail("E_SCHEMA", "the required property " + telar::quoted(field.key) + " is missing", here.pointer());
      }
    }
    return out;
  }

 private:
  json property(const Field& field, const json& value, const Where& where) {
    switch (field.kind) {
      case Kind::kBool:
        if (!value.is_boolean()) wrongType("true or false", value, where);
        return value;
      case Kind::kText:
        return text(value, where);
      case Kind::kName:
        return cutName(text(value, where));
      case Kind::kNumber:
        return number(value, where);
      case Kind::kSize:
        return integer(field, value, where);
      case Kind::kIndex:
        return index(field, value, where);
      case Kind::kObject:
        return object(*field.object, value, where);
      case Kind::kExtras:
        return value.is_object() ? object(*field.object, value, where) : json::object();
      case Kind::kSizes:
      case Kind::kIndexMap:
        return map(field, value, where);
      case Kind::kNumbers:
      case Kind::kIndices:
      case Kind::kIndexMaps:
      case Kind::kTexts:
      case Kind::kObjects:
        return list(field, value, where);
    }
    throw Error("X_INTERNAL", "a schema field has an unknown kind");
  }

  json list(const Field& field, const json& value, const Where& where) {
    if (!value.is_array()) wrongType("an array", value, where);
    if (field.limit) {
      checkLimit(field.limitName, static_cast<double>(limits_.*field.limit), static_cast<double>(value.size()),
                 where.pointer());
    }
    if (value.size() < field.min || value.size() > field.max) {
      const bool open = field.max == INTEGER_MAX, one = field.min == field.max;
      const std::string most = open ? " or more" : one ? "" : " to " + std::to_string(field.max);
      fail(field.rangeCode,
           "expected " + std::to_string(field.min) + most + " items here, got " + std::to_string(value.size()),
           where.pointer());
    }
    json out = json::array();
    for (std::size_t i = 0; i < value.size(); ++i) out.push_back(item(field, value[i], Where{&where, {}, i}));
    return out;
  }

  json item(const Field& field, const json& value, const Where& where) {
    switch (field.kind) {
      case Kind::kNumbers:
        return number(value, where);
      case Kind::kIndices:
        return index(field, value, where);
      case Kind::kIndexMaps:
        return map(field, value, where);
      case Kind::kTexts:
        return cutName(text(value, where));
      default:
        return object(*field.object, value, where);
    }
  }

  json map(const Field& field, const json& value, const Where& where) {
    if (!value.is_object()) wrongType("an object", value, where);
    json out = json::object();
    for (const auto& [key, entry] : value.items()) {
      const Where here{&where, key};
      out.emplace(key, field.kind == Kind::kSizes ? integer(field, entry, here) : index(field, entry, here));
    }
    return out;
  }

  static const std::string& text(const json& value, const Where& where) {
    if (!value.is_string()) wrongType("a string", value, where);
    return value.get_ref<const std::string&>();
  }

  static double number(const json& value, const Where& where) {
    if (!value.is_number()) wrongType("a number", value, where);
    return value.get<double>();
  }

  /// Negative values throw; 1.0 counts as 1, as it does in JavaScript; above 2^53 all values become 2^53 + 1.
  static std::uint64_t unsignedInteger(const Field& field, const json& value, const Where& where) {
    if (value.is_number_unsigned()) return std::min(value.get<std::uint64_t>(), INTEGER_MAX + 1);
    if (!value.is_number() || std::floor(value.get<double>()) != value.get<double>()) {
      wrongType("an integer", value, where);
    }
    const auto real = value.get<double>();
    if (real < 0)
      fail(field.negativeCode, "expected an integer of 0 or more here, got " + shown(value), where.pointer());
    return real > static_cast<double>(INTEGER_MAX) ? INTEGER_MAX + 1 : static_cast<std::uint64_t>(real);
  }

  static json integer(const Field& field, const json& value, const Where& where) {
    const std::uint64_t out = unsignedInteger(field, value, where);
    if (out > field.max && field.rangeCode.empty()) return field.max;
    if (out < field.min || out > field.max || out % field.step != 0) {
      const std::string step = field.step > 1 ? " in steps of " + std::to_string(field.step) : "";
      fail(field.rangeCode,
           "the value is out of range here: expected " + std::to_string(field.min) + " to " +
               std::to_string(field.max) + step + ", got " + shown(value),
           where.pointer());
    }
    return out;
  }

  json index(const Field& field, const json& value, const Where& where) {
    const std::uint64_t out = unsignedInteger(field, value, where);
    const std::uint64_t count = lengthOf(field.target);
    if (out >= count) {
      fail("E_REF",
           "the index " + shown(value) + " names an object that does not exist: the length of " +
               telar::quoted(field.target) + " is " + std::to_string(count),
           where.pointer());
    }
    return out;
  }

  std::uint64_t lengthOf(std::string_view target) {
    const auto known = lengths_.find(target);
    if (known != lengths_.end()) return known->second;
    const json::json_pointer path(target.starts_with('/') ? std::string(target) : "/" + std::string(target));
    const std::uint64_t length =
        document_.contains(path) && document_.at(path).is_array() ? document_.at(path).size() : 0;
    // Consumers keep indices as int.
    return lengths_[target] = std::min(length, INT_32_MAX);
  }

  const json& document_;
  const Limits& limits_;
  const CancelToken& cancel_;
  std::map<std::string_view, std::uint64_t> lengths_;
  std::uint64_t objects_ = 0;
};

}  // namespace

std::string cutName(const std::string& text) {
  if (text.size() <= NAME_MAX_BYTES) return text;
  std::size_t end = NAME_MAX_BYTES;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end);
}

json reduce(const ObjectRule& rule, const json& document, const Limits& limits, const CancelToken& cancel) {
  return Reducer(document, limits, cancel).object(rule, document, Where{});
}

}  // namespace telar::asset
