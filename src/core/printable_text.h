#pragma once
#include <string>
#include <string_view>

/// Names of scenes, materials, files and other untrusted text, made safe to print. Terminals obey
/// control characters: they move the cursor over earlier text, set titles, even answer.
namespace ajar {

/// `text` for a terminal, in lines: UTF-8 as it is, with line feeds and tabs; other control
/// characters as "\x1b", those of Unicode (C1, and those that turn the direction of text) as
/// "\u202e", bytes that are no UTF-8 as "\xff". A text that says "\x1b" by itself looks the same.
std::string printable_text(std::string_view text);

/// One line of text, for names and cells of tables: line feeds and tabs become "\n" and "\t".
std::string printable_line(std::string_view text);

/// One line of at most about 60 bytes, for messages: longer text ends in "…".
std::string printable(std::string_view text);

/// `text` with U+FFFD in the place of every byte that is no UTF-8, for formats that are UTF-8.
std::string valid_utf8(std::string_view text);

}  // namespace ajar
