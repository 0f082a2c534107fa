#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ajar::study {

/// A value in a JSON file that knows where it is, so that every error can say so. Accessors raise
/// UsageError that begins with `FILE: PATH: `.
class JsonNode {
 public:
  using Json = nlohmann::ordered_json;

  /// Raises IoError for an unreadable file and UsageError with file:line:column for bad syntax.
  static JsonNode read_file(const std::string& path);

  JsonNode(const Json& value, std::string file, std::string path)
      : value_(value), file_(std::move(file)), path_(std::move(path)) {}

  bool is_object() const { return value_.is_object(); }
  bool is_array() const { return value_.is_array(); }
  bool is_text() const { return value_.is_string(); }

  /// Raises unless this is an object with no other members than those.
  void check_members(const std::vector<std::string>& valid) const;
  bool has(const std::string& name) const;
  /// A member; raises if there is none.
  JsonNode at(const std::string& name) const;
  /// The elements of an array.
  std::vector<JsonNode> elements() const;
  /// The members of an object, in the file's order.
  std::vector<std::pair<std::string, JsonNode>> members() const;

  std::string text() const;  ///< not empty
  bool truth() const;        ///< true or false
  double positive() const;   ///< a number above 0
  /// A whole number from `minimum` to `maximum`.
  std::int64_t whole(std::int64_t minimum, std::int64_t maximum) const;
  /// Text, number or truth value, as `--set` takes it.
  std::string parameter_text() const;

  std::string place() const;  ///< `FILE: PATH: `
  [[noreturn]] void fail(const std::string& message) const;
  /// Runs a check that raises UsageError, and adds the place to its message.
  void check(const std::function<void()>& check) const;

 private:
  Json value_;
  std::string file_;
  std::string path_;  ///< such as integrators[1].sweep; empty for the whole
};

}  // namespace ajar::study
