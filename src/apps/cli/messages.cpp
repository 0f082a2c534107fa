#include "apps/cli/messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/printable_text.h"
#include "core/standard_streams.h"

namespace ajar::cli {

namespace {

constexpr std::size_t kMaxPrinted = 20;

bool errors_only = false;

void print(const char* kind, const std::string& text) {
  say(fmt::format("ajar: {}{}\n", kind, printable_text(text)));
}

}  // namespace

void print_error(const std::string& text) { print("error: ", text); }
void print_warning(const std::string& text) {
  if (!errors_only) print("warning: ", text);
}
void print_note(const std::string& text) {
  if (!errors_only) print("", text);
}
void print_errors_only() { errors_only = true; }

void print_path(const std::string& path) { say_on_stdout(path + "\n"); }

void print_warnings(const Warnings& warnings, const std::string& where_more) {
  const std::vector<std::string> messages = warnings.messages();
  const std::size_t printed = std::min(kMaxPrinted, messages.size());
  for (std::size_t i = 0; i < printed; ++i) print_warning(messages[i]);
  if (warnings.count() > printed) {
    print_warning(fmt::format("and {} more{}", warnings.count() - printed,
                              where_more.empty() ? "" : " (" + where_more + ")"));
  }
}

}  // namespace ajar::cli
