#include "import/mitsuba/definitions.h"

#include "core/printable_text.h"

namespace ajar::mitsuba {
namespace {

/// Definitions may use others: a few lines can expand to any length.
constexpr std::size_t kLongest = 1U << 20U;

bool is_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

[[noreturn]] void fail_undefined(std::string_view rest, const SceneDefinitions& definitions,
                                 const SourceLocation& where) {
  std::size_t length = 0;
  while (length < rest.size() && is_of_name(rest[length])) ++length;
  std::vector<std::string> valid;
  for (const auto& entry : definitions) valid.push_back(entry.first);
  throw SceneError(where,
                   unknown_name_message("parameter", printable(rest.substr(0, length)), valid) +
                       ". <default> gives parameters a value, and so does -Dname=value");
}

/// The longest name that `rest` begins with.
SceneDefinitions::const_iterator definition_at(std::string_view rest,
                                               const SceneDefinitions& definitions) {
  auto best = definitions.end();
  for (auto entry = definitions.begin(); entry != definitions.end(); ++entry) {
    const bool is_longer = best == definitions.end() || entry->first.size() > best->first.size();
    if (is_longer && rest.starts_with(entry->first)) best = entry;
  }
  return best;
}

}  // namespace

void Definitions::define(const std::string& name, const std::string& value) {
  values_.try_emplace(name, value);
  of_scene_.insert(name);
}

std::string Definitions::substitute(std::string_view text, const SourceLocation& where) {
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
    const auto definition = definition_at(text, values_);
    if (definition == values_.end()) fail_undefined(text, values_, where);
    of_scene_.insert(definition->first);
    result += definition->second;
    text.remove_prefix(definition->first.size());
    if (result.size() > kLongest) {
      throw SceneError(where, "a value made of parameters is longer than a million characters");
    }
  }
}

void Definitions::check_given(const SourceLocation& where) const {
  for (const auto& entry : given_) {
    if (of_scene_.contains(entry.first)) continue;
    const std::vector<std::string> valid(of_scene_.begin(), of_scene_.end());
    throw SceneError(where,
                     valid.empty()
                         ? "-D" + printable(entry.first) + ": this scene has no parameters"
                         : "-D" + printable(entry.first) + ": " +
                               unknown_name_message("parameter", printable(entry.first), valid));
  }
}

}  // namespace ajar::mitsuba
