#pragma once
#include <string>
#include <string_view>

#include "core/warnings.h"

namespace ajar::obj {

/// Warns of lines of a material file that change nothing here though they would elsewhere, of words
/// that no material file has, with the nearest, and of options of images that are not read. Each
/// word is told of once for a file.
void check_material_words(std::string_view text, const std::string& name, Warnings& warnings);

/// The remark on a line of an OBJ file that begins with `keyword`, of which nothing is read: what
/// is left out, or that no such word is known. Empty for those that nobody would miss.
std::string remark_on_unread(std::string_view keyword);

}  // namespace ajar::obj
