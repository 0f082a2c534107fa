#pragma once
#include <string>
#include <string_view>

namespace ajar {

/// What a library says of an image, in one line: errors come line by line, some twice.
std::string image_complaint(std::string_view text);

}  // namespace ajar
