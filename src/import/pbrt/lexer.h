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
  const std::string* file = nullptr;  ///< its name; null: that of the lexer
};

/// Cuts a pbrt file into words, quoted strings and brackets; skips white space and # comments. An
/// included file is followed by the rest of the one that includes it, as pbrt has it: blocks may
/// span both.
class Lexer {
 public:
  /// `text` must outlive the lexer, and so must `after`, which goes on where it ends.
  Lexer(std::shared_ptr<const std::string> file, std::string_view text, Lexer* after = nullptr);

  /// Raises SceneError for strings without an end.
  Token next() {
    const Token token = has_peeked_ ? peeked_ : scan();
    has_peeked_ = false;
    return token.kind == TokenKind::End && after_ != nullptr ? after_->next() : token;
  }
  const Token& peek() {
    Lexer& source = current();
    source.look_ahead();
    return source.peeked_;
  }
  /// True if nothing is left of its own text.
  bool is_at_own_end() {
    look_ahead();
    return peeked_.kind == TokenKind::End;
  }
  /// Lexer that the next token is from.
  Lexer& current() { return after_ != nullptr && is_at_own_end() ? after_->current() : *this; }

  SourceLocation where(const Token& token) const;
  [[noreturn]] void fail(const Token& token, const std::string& message) const {
    throw SceneError(where(token), message);
  }

  /// Value of a string with escapes decoded. Other backslashes are kept: names of files on Windows
  /// have them.
  std::string string_value(const Token& token) const;
  /// Values of a number. Raise SceneError if the token is none, is not finite, or does not fit.
  double double_value(const Token& token) const;
  float float_value(const Token& token) const;
  int int_value(const Token& token) const;

 private:
  void look_ahead() {
    if (!has_peeked_) peeked_ = scan();
    has_peeked_ = true;
  }
  Token scan();
  Token scan_string(Token token);

  std::shared_ptr<const std::string> file_;
  const char* position_;
  const char* end_;
  const char* line_start_;
  std::uint32_t line_ = 1;
  Lexer* after_;
  Token peeked_;
  bool has_peeked_ = false;
};

}  // namespace ajar::pbrt
