#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/contents.h"
#include "core/error.h"
#include "import/code/json_place.h"

/// JSON in and out of the C face.
namespace ajar::c {

using code::Json;

using v0::json_text;

/// Raises UsageError if it is no object, as `code::parse_json` does, and for members that are not
/// among `names`: one of what `kind` says.
inline Json parsed_object(std::string_view text, const std::string& kind,
                          const std::vector<std::string>& names) {
  Json json = code::parse_json(text);
  if (!json.is_object()) throw UsageError("this is no JSON object: " + code::shown(json));
  for (const auto& [name, value] : json.items()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw UsageError(unknown_name_message(kind, name, names));
    }
  }
  return json;
}

/// Raises UsageError ("must be …") for what is of another type, or beyond its range.
template <typename T>
struct JsonValue;

template <typename T>
T value_of(const Json& json) {
  return JsonValue<T>::read(json);
}

template <>
struct JsonValue<bool> {
  static bool read(const Json& json) {
    if (!json.is_boolean()) throw UsageError("must be true or false, not " + code::shown(json));
    return json.get<bool>();
  }
};

template <std::integral T>
requires(!std::same_as<T, bool>) struct JsonValue<T> {
  static T read(const Json& json) {
    const bool fits =
        json.is_number_unsigned()
            ? json.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<T>::max())
            : json.is_number_integer() && std::signed_integral<T> &&
                  json.get<std::int64_t>() >=
                      static_cast<std::int64_t>(std::numeric_limits<T>::min());
    if (fits) return json.get<T>();
    if (std::signed_integral<T> && json.is_number_integer()) {
      throw UsageError("is far beyond what can be: " + code::shown(json));
    }
    throw UsageError((std::signed_integral<T> ? "must be a whole number, not "
                                              : "must be a whole number from 0 on, not ") +
                     code::shown(json));
  }
};

template <>
struct JsonValue<double> {
  static double read(const Json& json) {
    if (!json.is_number()) throw UsageError("must be a number, not " + code::shown(json));
    return json.get<double>();
  }
};

template <>
struct JsonValue<std::string> {
  static std::string read(const Json& json) {
    if (!json.is_string()) throw UsageError("must be text, not " + code::shown(json));
    std::string text = json.get<std::string>();
    // Names of files end there.
    if (text.find('\0') != std::string::npos) throw UsageError("must be text without a zero in it");
    return text;
  }
};

template <typename T>
struct JsonValue<std::vector<T>> {
  static std::vector<T> read(const Json& json) {
    if (!json.is_array()) throw UsageError("must be a list, not " + code::shown(json));
    std::vector<T> values;
    for (const Json& item : json) values.push_back(value_of<T>(item));
    return values;
  }
};

template <typename T, std::size_t N>
struct JsonValue<std::array<T, N>> {
  static std::array<T, N> read(const Json& json) {
    if (!json.is_array() || json.size() != N) {
      throw UsageError("must be " + std::to_string(N) + " numbers, not " + code::shown(json));
    }
    std::array<T, N> values{};
    for (std::size_t i = 0; i < N; ++i) values[i] = value_of<T>(json[i]);
    return values;
  }
};

/// Type that a member is read as: that of its value, if it is optional.
template <typename T>
struct ReadAs {
  using Type = T;
};
template <typename T>
struct ReadAs<std::optional<T>> {
  using Type = T;
};

/// Reads a member of an object, whose name stands before what is wrong with it. Null is as if it
/// were not there.
template <typename Read>
void read_member(const Json& object, const std::string& name, const Read& read) {
  const auto found = object.find(name);
  if (found == object.end() || found->is_null()) return;
  try {
    read(*found);
  } catch (const UsageError& error) {
    throw UsageError(name + ": " + error.what());
  }
}

}  // namespace ajar::c
