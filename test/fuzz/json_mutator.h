#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

/// Changes of JSON that keep it JSON: what bytes at random hardly ever do.
namespace telar::fuzz {

using Json = nlohmann::ordered_json;
using Random = std::minstd_rand;

inline std::size_t below(Random& random, std::size_t end) { return end == 0 ? 0 : random() % end; }

/// Every value of a document, the document first.
inline std::vector<Json*> valuesOf(Json& document) {
  std::vector<Json*> values = {&document};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i]->is_structured())
      for (Json& child : *values[i]) values.push_back(&child);
  return values;
}

/// A number where the limits of types and of ranges lie.
inline Json number(Random& random) {
  static const std::array<Json, 20> NUMBERS = {0,     1,          -1,          2,           3,
                                               255,   256,        65535,       65536,       5120,
                                               5126,  2147483647, 4294967295u, 4294967296,  9007199254740993,
                                               1e308, -1e-308,    0.5,         -2147483648, 18446744073709551615u};
  return NUMBERS[below(random, NUMBERS.size())];
}

/// The number next to one, of the same type.
inline Json neighbour(const Json& value, int step) {
  if (value.is_number_float()) return value.get<double>() + step;
  return static_cast<std::int64_t>(value.get<std::uint64_t>() + static_cast<std::uint64_t>(step));
}

/// A value by steps from the top, so that long lists do not draw all changes.
inline Json* walked(Json& document, Random& random) {
  Json* value = &document;
  while (value->is_structured() && !value->empty() && below(random, 5) != 0)
    value = &*std::next(value->begin(), static_cast<std::ptrdiff_t>(below(random, value->size())));
  return value;
}

/// One change somewhere: another number, a value of elsewhere, a member less, a member twice, another type.
inline void changeOnce(Json& document, Random& random) {
  const std::vector<Json*> values = valuesOf(document);
  Json& value = below(random, 2) == 0 ? *walked(document, random) : *values[below(random, values.size())];
  switch (below(random, 6)) {
    case 0:
      if (value.is_number())
        value = neighbour(value, random() % 2 ? 1 : -1);
      else
        value = number(random);
      break;
    case 1:
      value = number(random);
      break;
    case 2: {
      const Json other = *values[below(random, values.size())];
      value = other;
      break;
    }
    case 3:
      if (value.is_array() && !value.empty())
        value.erase(below(random, value.size()));
      else if (value.is_object() && !value.empty())
        value.erase(std::next(value.begin(), static_cast<std::ptrdiff_t>(below(random, value.size()))));
      break;
    case 4:
      if (value.is_array() && !value.empty()) {
        const Json copy = value[below(random, value.size())];
        value.push_back(copy);
      }
      break;
    default: {
      static const std::array<Json, 6> TYPES = {nullptr, true, "", Json::array(), Json::object(), "data:;base64,AAAA"};
      value = TYPES[below(random, TYPES.size())];
    }
  }
}

/// A document with one change or up to four, or nothing where the text is no JSON or what comes of it is longer than
/// `most`.
inline std::string changed(const std::string& text, std::size_t most, Random& random) {
  Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return {};
  for (std::size_t n = below(random, 2) == 0 ? 1 : 1 + below(random, 4); n > 0; --n) changeOnce(document, random);
  std::string out = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  return out.size() <= most ? out : std::string();
}

}  // namespace telar::fuzz
