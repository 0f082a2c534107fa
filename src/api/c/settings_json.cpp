#include "api/c/settings_json.h"

#include <map>
#include <optional>
#include <type_traits>
#include <variant>

#include "api/c/json_text.h"
#include "core/error.h"
#include "session/options/render_options.h"

namespace ajar::c {

namespace {

template <typename T>
concept Readable = requires(const Json& json) {
  JsonValue<T>::read(json);
};

}  // namespace

template <>
struct JsonValue<std::map<std::string, std::string>> {
  static std::map<std::string, std::string> read(const Json& json) {
    if (!json.is_object()) throw UsageError("must be an object, not " + code::shown(json));
    std::map<std::string, std::string> values;
    for (const auto& [name, value] : json.items()) {
      values[name] = value.is_string() ? value_of<std::string>(value) : json_text(value);
    }
    return values;
  }
};

v0::Settings settings_from_json(std::string_view json) {
  RenderSpec spec{v0::Settings()};
  std::vector<std::string> names;
  for (const RenderOption& option : render_options()) {
    if (option.in_settings) names.push_back(option.name);
  }
  const Json object = parsed_object(json, "setting", names);
  for (const RenderOption& option : render_options()) {
    const auto read = [&](auto member) {
      using Value = typename ReadAs<std::remove_reference_t<decltype(spec.*member)>>::Type;
      if constexpr (Readable<Value>) {
        read_member(object, option.name,
                    [&](const Json& value) { spec.*member = value_of<Value>(value); });
      }
    };
    if (option.in_settings) std::visit(read, option.member);
  }
  return spec;
}

}  // namespace ajar::c
