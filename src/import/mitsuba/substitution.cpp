#include "import/mitsuba/substitution.h"

#include "import/common/printable.h"

namespace ajar::mitsuba {
namespace {

/// Definitions may use others: a few lines can stand for any length.
constexpr std::size_t kLongest = 1U << 20U;

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

[[noreturn]] void fail_undefined(std::string_view rest, const Definitions& definitions,
                                 const SourceLocation& where) {
  std::size_t length = 0;
  while (length < rest.size() && is_of_name(rest[length])) ++length;
  std::vector<std::string> valid;
  for (const auto& entry : definitions) valid.push_back(entry.first);
  throw SceneError(where,
                   unknown_name_message("parameter", printable(rest.substr(0, length)), valid) +
                       ". <default> gives parameters a value");
}

/// The longest name that `rest` begins with.
Definitions::const_iterator definition_at(std::string_view rest, const Definitions& definitions) {
  auto best = definitions.end();
  for (auto entry = definitions.begin(); entry != definitions.end(); ++entry) {
    const bool is_longer = best == definitions.end() || entry->first.size() > best->first.size();
    if (is_longer && rest.starts_with(entry->first)) best = entry;
  }
  return best;
}

}  // namespace

std::string substitute(std::string_view text, const Definitions& definitions,
                       const SourceLocation& where) {
  std::string result;
  while (true) {
    const std::size_t dollar = text.find('$');
    result += text.substr(0, dollar);
    if (dollar == std::string_view::npos) return result;
    text.remove_prefix(dollar + 1);
    if (!result.empty() && result.back() == '\\') {
      result.back() = '$';
      continue;
    }
    const auto definition = definition_at(text, definitions);
    if (definition == definitions.end()) fail_undefined(text, definitions, where);
    result += definition->second;
    text.remove_prefix(definition->first.size());
    if (result.size() > kLongest) {
      throw SceneError(where, "a value made of parameters is longer than a million characters");
    }
  }
}

}  // namespace ajar::mitsuba
