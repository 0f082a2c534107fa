#include "import/code/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace ajar::code {

namespace {

using Kind = LocatedJson::Kind;

/// A member of an object; nothing of another kind of value. Asking a value for what it is not would
/// ask for its place.
std::optional<LocatedJson> member_of(const LocatedJson& json, const char* name, Kind kind) {
  auto member = json.is(Kind::Object) ? json.find(name) : std::nullopt;
  return member && member->is(kind) ? member : std::nullopt;
}

/// [file, line], or nothing.
SourceLocation given_place(const LocatedJson& json) {
  const auto where = member_of(json, "where", Kind::Array);
  if (!where || where->size() != 2 || !(*where)[0].is(Kind::Text) ||
      !(*where)[1].is(Kind::Number)) {
    return {};
  }
  const double line = std::clamp((*where)[1].number(), 0.0, 1e9);
  return {std::make_shared<const std::string>((*where)[0].text()), static_cast<int>(line), 0};
}

/// "shape" for "shapes".
std::string singular(std::string name) {
  if (name == "media") return "medium";
  if (name.ends_with('s')) name.pop_back();
  return name;
}

/// `shape "lamp"` for a part with a name.
std::string title_of(const LocatedJson& part, const std::string& kind) {
  const auto name = member_of(part, "name", Kind::Text);
  return name && !name->text().empty() ? kind + " \"" + name->text() + "\"" : kind;
}

SourceLocation place_in_program(const LocatedJson& value) {
  std::vector<std::string> path;  // the innermost first
  SourceLocation where;
  bool has_part = false;
  for (std::optional<LocatedJson> at = value; at; at = at->parent()) {
    if (!where.file) where = given_place(*at);
    const std::optional<LocatedJson> around = at->parent();
    const std::string name = around ? at->name() : at->rules().name;
    if (has_part || name.empty() || name == "parameters") continue;
    // A part of the scene is in a list, a member of the whole.
    has_part = around && around->is(Kind::Array) && around->parent() && !around->parent()->parent();
    path.push_back(has_part ? title_of(*at, singular(around->name())) : name);
  }
  std::reverse(path.begin(), path.end());
  const auto text = fmt::format("{}", fmt::join(path, ": "));
  if (where.file) {
    where.part = std::make_shared<const std::string>(": " + text);
  } else {
    where.file = std::make_shared<const std::string>(text);
  }
  return where;
}

}  // namespace

LocatedJson parse_description(std::string_view text, const std::string& name) {
  return LocatedJson::parse(
      std::string(text),
      {.name = name, .deepest = 64, .null_is_absent = true, .place = place_in_program});
}

void check_members(const LocatedJson& part, std::vector<std::string> known) {
  known.emplace_back("where");
  part.check_members("member", known);
}

}  // namespace ajar::code
