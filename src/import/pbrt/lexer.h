#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.h"

namespace ajar::pbrt {

enum class TokenKind : std::uint8_t { End, Word, String, Open, Close };

/// A piece of the file. `text` points into the file and, for strings, is without the quotes and
/// with escapes as written; lines and columns count from 1.
struct Token {
  TokenKind kind = TokenKind::End;
  std::string_view text;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// Cuts a pbrt file into words, quoted strings and brackets; skips white space and # comments.
class Lexer {
 public:
  /// `text` must outlive the lexer.
  Lexer(std::shared_ptr<const std::string> file, std::string_view text);

  /// Raises SceneError for strings without an end.
  Token next() {
    if (!has_peeked_) return scan();
    has_peeked_ = false;
    return peeked_;
  }
  const Token& peek() {
    if (!has_peeked_) peeked_ = scan();
    has_peeked_ = true;
    return peeked_;
  }

  SourceLocation where(const Token& token) const {
    return {file_, static_cast<int>(token.line), static_cast<int>(token.column)};
  }
  [[noreturn]] void fail(const Token& token, const std::string& message) const {
    throw SceneError(where(token), message);
  }

  /// Value of a string with escapes decoded. Raises SceneError for unknown escapes.
  std::string string_value(const Token& token) const;
  /// Values of a number. Raise SceneError if the token is none, is not finite, or does not fit.
  double double_value(const Token& token) const;
  float float_value(const Token& token) const;
  int int_value(const Token& token) const;

 private:
  Token scan();
  Token scan_string(Token token);

  std::shared_ptr<const std::string> file_;
  const char* position_;
  const char* end_;
  const char* line_start_;
  std::uint32_t line_ = 1;
  Token peeked_;
  bool has_peeked_ = false;
};

}  // namespace ajar::pbrt
