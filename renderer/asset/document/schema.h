#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "telar/cancel.h"
#include "telar/limits.h"

namespace telar::asset {

enum class Kind {
  kBool,
  kText,       ///< string of any length
  kName,       ///< string, cut at 1 KiB
  kNumber,     ///< finite; copied as a double
  kNumbers,    ///< array of numbers, min..max of them
  kSize,       ///< integer, min..max
  kSizes,      ///< object of integers, any keys
  kIndex,      ///< integer below the length of the array at `target`
  kIndices,    ///< array of such, min..max of them
  kIndexMap,   ///< object of such, any keys
  kIndexMaps,  ///< array of such objects
  kTexts,      ///< array of strings
  kObject,
  kExtras,   ///< an object, or anything else, which becomes an empty one: the application's own
  kObjects,  ///< array of objects, min..max of them
};

constexpr std::uint64_t INTEGER_MAX = std::uint64_t{1} << 53;  ///< JSON's own: exact in a double
constexpr std::uint64_t INT_32_MAX = 0x7fffffff;

struct ObjectRule;

/// What one property of a glTF object must be.
struct Field {
  std::string_view key;
  Kind kind;
  bool required = false;
  std::string_view target = {};  ///< root array, or the JSON pointer of an array
  const ObjectRule* object = nullptr;
  std::uint64_t min = 0, max = INTEGER_MAX;
  std::uint64_t step = 1;                      ///< a kSize must be a multiple of it
  std::string_view rangeCode = "E_SCHEMA";     ///< thrown outside min..max; empty = values above max become max
  std::string_view negativeCode = "E_SCHEMA";  ///< thrown below 0
  std::uint64_t Limits::*limit = nullptr;      ///< most items of a list
  std::string_view limitName = {};
};

struct ObjectRule {
  std::span<const Field> fields;
};

/// A name cut at 1 KiB, at a code point's start, so that it stays valid UTF-8.
std::string cutName(const std::string& text);

/// The rule of a whole glTF document (as far as telar draws it).
extern const ObjectRule DOCUMENT_RULE;

/// Copies the properties that the rule names and drops all others, so that what comes out is known to be well formed:
/// types, lengths, ranges, and every index below the length of what it points into.
/// @throws Error{E_SCHEMA, E_REF, L_*, or the field's own code} with the JSON pointer
nlohmann::json reduce(const ObjectRule& rule, const nlohmann::json& document, const Limits& limits,
                      const CancelToken& cancel);

}  // namespace telar::asset
