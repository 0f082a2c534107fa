#include "import/common/printable.h"

#include "core/printable_text.h"

namespace ajar {

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return printable_line(text);
  // Not in the middle of a character: its further bytes are 10xxxxxx.
  std::size_t end = kLongest;
  while (end > kLongest - 4 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return printable_line(text.substr(0, end)) + "…";
}

}  // namespace ajar
