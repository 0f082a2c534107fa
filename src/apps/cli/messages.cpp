#include "apps/cli/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "core/printable_text.h"
#include "core/warning_digest.h"
#include "os/standard_streams.h"

namespace ajar::cli {

namespace {

/// With the note, about a screen.
constexpr std::size_t kMostLines = 19;

bool errors_only = false;

void print(const char* kind, const std::string& text) {
  say(fmt::format("ajar: {}{}\n", kind, printable_text(text)));
}

/// `text` as a shell takes it for one word.
std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain = "/._-+:,@%=";
  const bool is_plain = std::all_of(text.begin(), text.end(), [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           (static_cast<unsigned char>(c) & 0x80U) != 0 || kPlain.find(c) != std::string_view::npos;
  });
  if (is_plain && !text.empty()) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace

void print_error(const std::string& text) { print("error: ", text); }
void print_warning(const std::string& text) {
  if (!errors_only) print("warning: ", text);
}
void print_note(const std::string& text) {
  if (!errors_only) print("", text);
}
void print_errors_only() { errors_only = true; }

void print_path(const std::string& path) { say_on_stdout(path + "\n"); }

void print_warnings(const Warnings& warnings, const std::string& scene) {
  const WarningDigest digested = digest(warnings, kMostLines, "ajar info " + shell_word(scene));
  for (const std::string& line : digested.lines) print_warning(line);
  if (!digested.note.empty()) print_note(digested.note);
}

void print_all_warnings(const Warnings& warnings) {
  for (const std::string& message : warnings.messages()) print_warning(message);
}

}  // namespace ajar::cli
