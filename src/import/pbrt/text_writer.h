#pragma once
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ajar::pbrt {

/// Puts pbrt's syntax together. Numbers are the shortest that read back as the same bits.
class TextWriter {
 public:
  /// Starts a directive on a new line.
  TextWriter& line(std::string_view directive) {
    if (!text_.empty()) text_ += '\n';
    text_ += directive;
    return *this;
  }
  TextWriter& quoted(std::string_view value) {
    text_ += " \"";
    for (const char c : value) append_escaped(c);
    text_ += '"';
    return *this;
  }
  template <typename Number>
  TextWriter& number(Number value) {
    char buffer[64];
    text_ += ' ';
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
    return *this;
  }
  TextWriter& matrix(const Mat4& m) {
    text_ += " [";
    for (const auto& row : m.x) {
      for (const double value : row) number(value);
    }
    text_ += " ]";
    return *this;
  }

  TextWriter& parameter(std::string_view declaration, std::string_view value) {
    return quoted(declaration).quoted(value);
  }
  TextWriter& flag(std::string_view name, bool value) {
    return quoted("bool " + std::string(name)).quoted(value ? "true" : "false");
  }
  template <typename... Numbers>
  TextWriter& parameter(std::string_view declaration,
                        Numbers... values) requires(std::is_arithmetic_v<Numbers>&&...) {
    quoted(declaration);
    text_ += " [";
    (number(values), ...);
    text_ += " ]";
    return *this;
  }
  TextWriter& rgb(std::string_view name, const Vec3& v) {
    return parameter("rgb " + std::string(name), v.x, v.y, v.z);
  }
  TextWriter& point(std::string_view name, const Vec3& v) {
    return parameter("point " + std::string(name), v.x, v.y, v.z);
  }
  /// Arrays of vectors of any length.
  template <typename Vector>
  TextWriter& vectors(std::string_view declaration, const std::vector<Vector>& values) {
    quoted(declaration);
    text_ += " [";
    for (const Vector& v : values) {
      for (unsigned i = 0; i < Vector::dimensions(); ++i) number(v[static_cast<int>(i)]);
    }
    text_ += " ]";
    return *this;
  }

  TextWriter& integers(std::string_view declaration, const std::vector<std::int8_t>& values) {
    quoted(declaration);
    text_ += " [";
    for (const std::int8_t value : values) number(static_cast<int>(value));
    text_ += " ]";
    return *this;
  }

  const std::string& text() const { return text_; }

 private:
  void append_escaped(char c) {
    switch (c) {
      case '"':
        text_ += "\\\"";
        break;
      case '\\':
        text_ += "\\\\";
        break;
      case '\n':
        text_ += "\\n";
        break;
      case '\r':
        text_ += "\\r";
        break;
      case '\t':
        text_ += "\\t";
        break;
      default:
        text_ += c;
    }
  }
  std::string text_;
};

}  // namespace ajar::pbrt
