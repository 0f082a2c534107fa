#include "api/c/settings_json.h"

#include <functional>

#include "api/c/json_text.h"
#include "core/error.h"

namespace ajar::c {

namespace {

/// Reads a member into a setting; null leaves it as it is.
template <typename T>
std::function<void(v0::Settings&, const Json&)> to(T v0::Settings::*setting) {
  return [setting](v0::Settings& settings, const Json& json) {
    if constexpr (requires {
                    typename T::value_type;
                    requires std::is_same_v<T, std::optional<typename T::value_type>>;
                  }) {
      settings.*setting = value_of<typename T::value_type>(json);
    } else {
      settings.*setting = value_of<T>(json);
    }
  };
}

struct Member {
  const char* name;
  std::function<void(v0::Settings&, const Json&)> read;
};

const std::vector<Member>& members() {
  using v0::Settings;
  static const std::vector<Member> kMembers = {
      {"integrator", to(&Settings::integrator)},
      {"parameters",
       [](Settings& settings, const Json& json) {
         if (!json.is_object()) throw UsageError("must be an object, not " + code::shown(json));
         for (const auto& [name, value] : json.items()) {
           settings.parameters[name] =
               value.is_string() ? value_of<std::string>(value) : json_text(value);
         }
       }},
      {"samples_per_pixel", to(&Settings::samples_per_pixel)},
      {"seconds", to(&Settings::seconds)},
      {"target_error", to(&Settings::target_error)},
      {"denoised_target", to(&Settings::denoised_target)},
      {"resolution", to(&Settings::resolution)},
      {"scale", to(&Settings::scale)},
      {"min_depth", to(&Settings::min_depth)},
      {"max_depth", to(&Settings::max_depth)},
      {"crop", to(&Settings::crop)},
      {"filter", to(&Settings::filter)},
      {"layers", to(&Settings::layers)},
      {"denoise", to(&Settings::denoise)},
      {"seed", to(&Settings::seed)},
      {"threads", to(&Settings::threads)},
      {"checkpoint", to(&Settings::checkpoint)},
      {"checkpoint_every", to(&Settings::checkpoint_every)},
      {"resume", to(&Settings::resume)}};
  return kMembers;
}

}  // namespace

v0::Settings settings_from_json(std::string_view json) {
  v0::Settings settings;
  std::vector<std::string> names;
  for (const Member& member : members()) names.emplace_back(member.name);
  const Json object = parsed_object(json, "setting", names);
  for (const Member& member : members()) {
    read_member(object, member.name, [&](const Json& value) { member.read(settings, value); });
  }
  return settings;
}

}  // namespace ajar::c
