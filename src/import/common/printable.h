#pragma once
#include <string>
#include <string_view>

namespace ajar {

/// `text` shortened and without control characters, fit for a message.
std::string printable(std::string_view text);

}  // namespace ajar
