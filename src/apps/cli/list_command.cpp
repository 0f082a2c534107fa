#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/cli/commands.h"
#include "core/error.h"
#include "os/standard_streams.h"
#include "session/scenes/catalog.h"

namespace ajar::cli {

namespace {

/// `list mlt` is `list integrators mlt`, if one kind alone has the name.
ListArguments with_kind(ListArguments arguments) {
  const std::vector<std::string> kinds = catalog_kinds();
  const bool is_kind = std::find(kinds.begin(), kinds.end(), arguments.kind) != kinds.end();
  if (is_kind || arguments.kind.empty() || !arguments.name.empty()) return arguments;
  const std::vector<std::string> with_name = kinds_with(arguments.kind);
  if (with_name.size() > 1) {
    throw UsageError("\"" + arguments.kind + "\" is of several kinds; try: ajar list " +
                     with_name.front() + " " + arguments.kind + ", or " + with_name.back());
  }
  if (with_name.empty()) {
    const std::string near = nearest_name(arguments.kind, names_with_parameters());
    const bool is_near_kind = !nearest_name(arguments.kind, kinds).empty();
    if (!near.empty() && !is_near_kind) {
      throw UsageError("nothing is called \"" + arguments.kind + "\"; did you mean \"" + near +
                       "\"?");
    }
    return arguments;
  }
  return {.kind = with_name.front(), .name = arguments.kind, .json = arguments.json};
}

}  // namespace

int list(const ListArguments& given) {
  const ListArguments arguments = with_kind(given);
  std::vector<std::string> kinds = catalog_kinds();
  if (!arguments.kind.empty()) {
    if (std::find(kinds.begin(), kinds.end(), arguments.kind) == kinds.end()) {
      throw UsageError(unknown_name_message("kind of list", arguments.kind, kinds));
    }
    kinds = {arguments.kind};
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!arguments.name.empty()) {
    if (arguments.json) {
      json[arguments.kind] = {entry_json(arguments.kind, arguments.name)};
      print_result(json.dump(2) + "\n");
    } else {
      print_result(entry_text(arguments.kind, arguments.name));
    }
    return 0;
  }
  std::string text;
  for (const std::string& kind : kinds) {
    if (arguments.json) {
      json[kind] = catalog_json(kind);
    } else {
      if (!text.empty()) text += '\n';
      text += catalog_text(kind);
    }
  }
  print_result(arguments.json ? json.dump(2) + "\n" : text);
  return 0;
}

}  // namespace ajar::cli
