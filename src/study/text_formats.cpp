#include "study/text_formats.h"

#include <string_view>

#include "core/printable_text.h"

namespace ajar::study {

std::string markdown_text(const std::string& text) {
  constexpr std::string_view kMarkup = "\\`*_[]<>|~&!#";
  std::string result;
  for (const char c : printable_line(text)) {
    if (kMarkup.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string csv_cell(const std::string& text) {
  constexpr std::string_view kFormula = "=+-@\t\r";
  const bool is_formula = !text.empty() && kFormula.find(text.front()) != std::string_view::npos;
  std::string cell = is_formula ? "'" + text : text;
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace ajar::study
