#include "import/tungsten/context.h"

#include "core/printable_text.h"

namespace ajar::tungsten {

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  return printable_line(text.size() <= kLongest ? std::string(text)
                                                : std::string(text.substr(0, kLongest)) + "…");
}

}  // namespace ajar::tungsten
