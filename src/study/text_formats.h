#pragma once
#include <string>

/// Names that others chose, in files that other programs read.
namespace ajar::study {

/// `text` in a line of Markdown, none of it read as markup or as HTML.
std::string markdown_text(const std::string& text);

/// A cell of text for a CSV file. Spreadsheets take what begins with = + - @ for a formula, which
/// can open programs and send data: such text gets an apostrophe before it, as OWASP advises.
/// Numbers do not come here.
std::string csv_cell(const std::string& text);

}  // namespace ajar::study
