#include "api/c/settings_json.h"

#include <map>
#include <optional>
#include <type_traits>
#include <variant>

#include "api/c/json_text.h"
#include "session/options/render_options.h"

namespace ajar::c {

namespace {

/// Members of other types are no settings.
template <typename T>
void read(const LocatedJson& json, T& member) {
  if constexpr (std::is_arithmetic_v<T> || requires { typename T::value_type; }) {
    member = json.as<T>();
  }
}
template <typename T>
void read(const LocatedJson& json, std::optional<T>& member) {
  read(json, member.emplace());
}
void read(const LocatedJson& json, std::map<std::string, std::string>& values) {
  for (const auto& [name, key, value] : json.members()) values[name] = value.plain();
}

}  // namespace

v0::Settings settings_from_json(std::string_view json) {
  RenderSpec spec{v0::Settings()};
  std::vector<std::string> names;
  for (const RenderOption& option : render_options()) {
    if (option.in_settings) names.push_back(option.name);
  }
  const LocatedJson object = parsed_object(json, "setting", names);
  for (const RenderOption& option : render_options()) {
    const auto value = option.in_settings ? object.find(option.name) : std::nullopt;
    if (value) std::visit([&](auto member) { read(*value, spec.*member); }, option.member);
  }
  return spec;
}

}  // namespace ajar::c
