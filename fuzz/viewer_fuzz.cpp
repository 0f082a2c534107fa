// Any message of a page must change a render's state, or raise one of our errors.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "apps/viewer/messages.h"
#include "core/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view message(reinterpret_cast<const char*>(data), size);
  ajar::viewer::LiveState state;
  try {
    ajar::viewer::parse_mask(message);
  } catch (const ajar::Error&) {
  }
  try {
    const nlohmann::json parsed = ajar::viewer::parse_message(message);
    ajar::viewer::parse_stop_at(parsed);
    ajar::viewer::apply_message(parsed, state);
  } catch (const ajar::Error&) {
  }
  return 0;
}
