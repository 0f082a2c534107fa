#pragma once
#include <string>

#include "core/warnings.h"

/// Messages for people, on stderr; results go to stdout (`print_result`).
namespace ajar::cli {

void print_error(const std::string& text);
void print_warning(const std::string& text);
void print_note(const std::string& text);
/// From here on nothing but errors: for processes that render what another tells of.
void print_errors_only();
/// Where a file was written, on stdout for scripts.
void print_path(const std::string& path);
/// At most a screen of them, by what they do to the picture of `scene`, which `ajar info` tells all
/// of.
void print_warnings(const Warnings& warnings, const std::string& scene);
/// Every one that is kept.
void print_all_warnings(const Warnings& warnings);

}  // namespace ajar::cli
