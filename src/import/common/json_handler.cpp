#include "import/common/json_handler.h"

#include "core/printable_text.h"

namespace ajar {
namespace {

constexpr int kNumberOutOfRange = 406;  // from the parser's documentation

/// The part of the parser's message with the reason; its own place is less exact than ours.
std::string reason_of(const std::string& message) {
  constexpr std::string_view kPlace = "column ";
  std::size_t begin = message.find(kPlace);
  begin = begin == std::string::npos ? message.find("] ") : message.find(": ", begin);
  return printable_line(begin == std::string::npos ? message : message.substr(begin + 2));
}

}  // namespace

bool JsonHandler::parse_error(std::size_t position, const std::string& token,
                              const nlohmann::detail::exception& error) {
  if (error.id == kNumberOutOfRange) {
    throw SceneError(token_place(), "the number " + printable_line(token.substr(0, 32)) +
                                        " is beyond the range of numbers");
  }
  throw SceneError(places_.at(position == 0 ? 0 : position - 1),
                   "this is no JSON: " + reason_of(error.what()));
}

}  // namespace ajar
