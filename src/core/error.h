#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

/// A place in an input file; lines and columns count from 1, 0 means unknown.
struct SourceLocation {
  std::shared_ptr<const std::string> file;
  int line = 0;
  int column = 0;
  /// Part of the file there, as it is written after the place: "#/materials/3".
  std::shared_ptr<const std::string> part = nullptr;
  /// "file:line:column" and the part, without what is unknown.
  std::string to_string() const;
};
/// "place: message", or the message alone if the place is unknown.
std::string located(const SourceLocation& where, const std::string& message);

/// Base of every error a user can cause; `what()` is the complete message, ready to print.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// Exit code of the program (docs/command-line.md).
  virtual int exit_code() const = 0;
};
/// Wrong command line, unknown name or parameter value.
class UsageError : public Error {
 public:
  using Error::Error;
  int exit_code() const override { return 2; }
};
/// The scene cannot be used; the message starts with its location.
class SceneError : public Error {
 public:
  using Error::Error;
  SceneError(const SourceLocation& where, const std::string& message);
  int exit_code() const override { return 3; }
};
/// A file cannot be read or written.
class IoError : public Error {
 public:
  using Error::Error;
  int exit_code() const override { return 4; }
};

/// The name among `valid` that is nearest to `name` by edit distance, or empty if none is near.
std::string nearest_name(std::string_view name, std::span<const std::string> valid);
/// `unknown <kind> "name"; did you mean "…"? Valid: a, b, c`.
std::string unknown_name_message(std::string_view kind, std::string_view name,
                                 std::span<const std::string> valid);

}  // namespace ajar
