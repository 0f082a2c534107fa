#pragma once
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/error.h"

namespace ajar::code {

using Json = nlohmann::ordered_json;

/// JSON of a program. Raises UsageError for invalid text, or for deeper nesting than any valid
/// input has: readers may be recursive.
Json parse_json(std::string_view text);

/// A part of a description: an object, with the place in the program that it came from, and its
/// name in messages.
class JsonPlace {
 public:
  /// Raises SceneError if this is no object or has another member than `known` (and "where").
  JsonPlace(const Json& json, std::string what, std::initializer_list<const char*> known);

  const Json& json() const { return json_; }
  const SourceLocation& where() const { return where_; }
  const std::string& what() const { return what_; }
  [[noreturn]] void fail(const std::string& message) const;

  /// Null if there is none, or if it is null.
  const Json* find(const char* name) const;
  /// Raises SceneError for other types; without the member, the default.
  std::string text(const char* name, std::string otherwise = {}) const;
  bool flag(const char* name, bool otherwise) const;
  /// Finite.
  double number(const char* name, double otherwise) const;
  /// Index below `count`; -1 without the member.
  int index(const char* name, std::size_t count) const;

 private:
  const Json& json_;
  SourceLocation where_;
  std::string what_;
};

/// A number as text, "an object", …, for messages.
std::string shown(const Json& value);

}  // namespace ajar::code
