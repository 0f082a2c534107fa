#pragma once
#include <charconv>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace ajar {

/// The lines of a text, with the line ends of any system; a backslash at the end of one joins it
/// with the next, but of comments, which may end with the name of a folder.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
  }

  /// False at the end. Views from `line` are valid until the next call.
  bool next() {
    if (rest_.empty()) return false;
    line_ = take();
    number_ = ++lines_;
    if (is_comment(line_) || !goes_on(line_)) return true;
    joined_.clear();
    for (;; line_ = take(), ++lines_) {
      const bool has_next = goes_on(line_);
      joined_ += has_next ? line_.substr(0, line_.rfind('\\')) : line_;
      if (!has_next || rest_.empty()) break;
      joined_ += ' ';
    }
    line_ = joined_;
    return true;
  }
  std::string_view line() const { return line_; }
  /// Number of the line at its beginning, counted from 1.
  int number() const { return number_; }

 private:
  static constexpr std::string_view kSpace = " \t";

  static bool is_comment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(kSpace);
    return first != line.npos && line[first] == '#';
  }
  /// True if the last character that is not a space is a backslash.
  static bool goes_on(std::string_view line) {
    const std::size_t last = line.find_last_not_of(kSpace);
    return last != line.npos && line[last] == '\\';
  }

  std::string_view take() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    const std::size_t carriage_return = line.find('\r');
    if (carriage_return == line.npos || carriage_return + 1 == line.size()) {
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      if (carriage_return != line.npos) line.remove_suffix(1);
      return line;
    }
    rest_.remove_prefix(carriage_return + 1);
    return line.substr(0, carriage_return);
  }

  std::string_view rest_;
  std::string_view line_;
  std::string joined_;
  int lines_ = 0;
  int number_ = 0;
};

/// The words of a line.
class LineWords {
 public:
  explicit LineWords(std::string_view line) : line_(line), rest_(line) {}

  /// Word before the next space; empty at the end of the line.
  std::string_view word() {
    skip_spaces();
    std::size_t length = 0;
    while (length < rest_.size() && !is_space(rest_[length])) ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }
  /// All that is left, without the spaces around it.
  std::string_view rest() {
    skip_spaces();
    while (!rest_.empty() && is_space(rest_.back())) rest_.remove_suffix(1);
    return rest_;
  }
  /// Column of the next word, counted from 1.
  int column() {
    skip_spaces();
    return static_cast<int>(rest_.data() - line_.data()) + 1;
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t'; }
  void skip_spaces() {
    while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
  }

  std::string_view line_;
  std::string_view rest_;
};

/// The number in `word`; nothing if it is none, or beyond the range of doubles.
inline std::optional<float> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return static_cast<float>(value);
}

}  // namespace ajar
