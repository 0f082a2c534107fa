#pragma once
#include <string>
#include <string_view>

#include "core/warnings.h"

namespace ajar::obj {

/// Warns of lines of a material file that have an effect elsewhere and none here, of words that no
/// material file has, with the nearest, and of options of images that are not read. Each word is
/// reported once for a file.
void check_material_words(std::string_view text, const std::string& name, Warnings& warnings);

/// The remark on an unread line of an OBJ file that begins with `keyword`: its effect, or that the
/// word is unknown. Empty for keywords without visible effect.
std::string remark_on_unread(std::string_view keyword);

}  // namespace ajar::obj
