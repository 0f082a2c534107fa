#include "import/pbrt/lexer.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "core/number_text.h"
#include "core/printable_text.h"

namespace ajar::pbrt {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool ends_word(char c) { return is_space(c) || c == '"' || c == '[' || c == ']' || c == '#'; }

/// Digits, sign and exponent with nothing behind; "nan" and "inf" are not numbers.
template <typename T>
std::errc parse(std::string_view text, T& value) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  if (text.empty()) return std::errc::invalid_argument;
  const char last = text.back();
  if (!((last >= '0' && last <= '9') || last == '.')) return std::errc::invalid_argument;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return error;
  return end == text.data() + text.size() ? std::errc() : std::errc::invalid_argument;
}

}  // namespace

Lexer::Lexer(std::shared_ptr<const std::string> file, std::string_view text, Lexer* after)
    : file_(std::move(file)),
      position_(text.data()),
      end_(text.data() + text.size()),
      line_start_(text.data()),
      after_(after) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, 3) == kByteOrderMark) {
    position_ += 3;
    line_start_ += 3;
  }
}

SourceLocation Lexer::where(const Token& token) const {
  const bool is_own = token.file == nullptr || token.file == file_.get() || after_ == nullptr;
  if (!is_own) return after_->where(token);
  return {file_, static_cast<int>(token.line), static_cast<int>(token.column)};
}

Token Lexer::scan() {
  while (position_ < end_) {
    const char c = *position_;
    if (c == '\n') {
      ++position_;
      ++line_;
      line_start_ = position_;
    } else if (is_space(c)) {
      ++position_;
    } else if (c == '#') {
      while (position_ < end_ && *position_ != '\n') ++position_;
    } else {
      break;
    }
  }
  Token token;
  token.file = file_.get();
  token.line = line_;
  token.column = static_cast<std::uint32_t>(position_ - line_start_) + 1;
  if (position_ == end_) return token;
  const char* begin = position_;
  const char c = *position_++;
  if (c == '"') return scan_string(token);
  if (c == '[') {
    token.kind = TokenKind::Open;
  } else if (c == ']') {
    token.kind = TokenKind::Close;
  } else {
    token.kind = TokenKind::Word;
    while (position_ < end_ && !ends_word(*position_)) ++position_;
  }
  token.text = std::string_view(begin, static_cast<std::size_t>(position_ - begin));
  return token;
}

Token Lexer::scan_string(Token token) {
  const char* begin = position_;
  token.kind = TokenKind::String;
  while (position_ < end_ && *position_ != '"' && *position_ != '\n') {
    if (*position_ == '\\' && position_ + 1 < end_ && position_[1] != '\n') ++position_;
    ++position_;
  }
  if (position_ >= end_ || *position_ != '"') fail(token, "this string has no end on its line");
  token.text = std::string_view(begin, static_cast<std::size_t>(position_ - begin));
  ++position_;
  return token;
}

std::string Lexer::string_value(const Token& token) const {
  std::string value;
  value.reserve(token.text.size());
  for (std::size_t i = 0; i < token.text.size(); ++i) {
    char c = token.text[i];
    if (c == '\\') {
      c = ++i < token.text.size() ? token.text[i] : '\0';
      switch (c) {
        case 'b':
          c = '\b';
          break;
        case 'f':
          c = '\f';
          break;
        case 'n':
          c = '\n';
          break;
        case 'r':
          c = '\r';
          break;
        case 't':
          c = '\t';
          break;
        case '\\':
        case '\'':
        case '"':
          break;
        default:
          value += '\\';
          if (i == token.text.size()) return value;
      }
    }
    value += c;
  }
  return value;
}

double Lexer::double_value(const Token& token) const {
  double value = 0.0;
  const std::errc error =
      token.kind == TokenKind::Word ? parse(token.text, value) : std::errc::invalid_argument;
  if (error == std::errc()) return value;
  if (error == std::errc::result_out_of_range) {
    value = number_of(token.text).value_or(0.0);
    if (std::isfinite(value)) return value;
    fail(token, "the number " + printable(token.text) + " is too large");
  }
  if (token.kind == TokenKind::End) fail(token, "the file ends where a number should be");
  fail(token, "expected a number, found \"" + printable(token.text) + "\"");
}

float Lexer::float_value(const Token& token) const {
  float value = 0.F;
  if (token.kind == TokenKind::Word && parse(token.text, value) == std::errc()) return value;
  const double exact = double_value(token);
  if (std::abs(exact) > static_cast<double>(std::numeric_limits<float>::max())) {
    fail(token, "the number " + printable(token.text) + " is too large");
  }
  return static_cast<float>(exact);
}

int Lexer::int_value(const Token& token) const {
  int value = 0;
  if (token.kind == TokenKind::Word && parse(token.text, value) == std::errc()) return value;
  const double exact = double_value(token);
  if (exact != std::floor(exact)) {
    fail(token, "expected an integer, found " + printable(token.text));
  }
  if (std::abs(exact) > static_cast<double>(std::numeric_limits<int>::max())) {
    fail(token, "the integer " + printable(token.text) + " is too large");
  }
  return static_cast<int>(exact);
}

}  // namespace ajar::pbrt
