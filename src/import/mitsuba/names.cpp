#include "import/mitsuba/names.h"

namespace ajar::mitsuba {
namespace {

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
char lowered(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }
char raised(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = lowered(c);
  return result;
}

std::string snake_case(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i > 0 && is_upper(name[i]) && !is_upper(name[i - 1]) && name[i - 1] != '_') result += '_';
    result += lowered(name[i]);
  }
  return result;
}

std::string camel_case(std::string_view name) {
  // The only abbreviation among Mitsuba's names.
  if (name == "int_ior" || name == "ext_ior") return std::string(name.substr(0, 3)) + "IOR";
  std::string result;
  bool begins_word = false;
  for (const char c : name) {
    if (c == '_') {
      begins_word = true;
      continue;
    }
    result += begins_word ? raised(c) : c;
    begins_word = false;
  }
  return result;
}

}  // namespace ajar::mitsuba
