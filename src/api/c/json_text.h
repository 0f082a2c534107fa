#pragma once
#include <array>
#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

/// JSON in and out of the C face.
namespace ajar::c {

using Json = nlohmann::ordered_json;

/// Names of files need not be UTF-8.
inline std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Raises UsageError if it is no object.
inline Json parsed_object(std::string_view text) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& error) {
    throw UsageError("this is no JSON: " + std::string(error.what()));
  }
  if (!json.is_object()) throw UsageError("this is no JSON object: " + json_text(json));
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
    if (!json.is_boolean()) throw UsageError("must be true or false, not " + json_text(json));
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
    if (!fits) {
      throw UsageError((std::signed_integral<T> ? "must be a whole number, not "
                                                : "must be a whole number from 0 on, not ") +
                       json_text(json));
    }
    return json.get<T>();
  }
};

template <>
struct JsonValue<double> {
  static double read(const Json& json) {
    if (!json.is_number()) throw UsageError("must be a number, not " + json_text(json));
    return json.get<double>();
  }
};

template <>
struct JsonValue<std::string> {
  static std::string read(const Json& json) {
    if (!json.is_string()) throw UsageError("must be text, not " + json_text(json));
    return json.get<std::string>();
  }
};

template <typename T>
struct JsonValue<std::vector<T>> {
  static std::vector<T> read(const Json& json) {
    if (!json.is_array()) throw UsageError("must be a list, not " + json_text(json));
    std::vector<T> values;
    for (const Json& item : json) values.push_back(value_of<T>(item));
    return values;
  }
};

template <typename T, std::size_t N>
struct JsonValue<std::array<T, N>> {
  static std::array<T, N> read(const Json& json) {
    if (!json.is_array() || json.size() != N) {
      throw UsageError("must be " + std::to_string(N) + " numbers, not " + json_text(json));
    }
    std::array<T, N> values{};
    for (std::size_t i = 0; i < N; ++i) values[i] = value_of<T>(json[i]);
    return values;
  }
};

}  // namespace ajar::c
