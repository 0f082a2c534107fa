#include "import/tungsten/object_reader.h"

#include <algorithm>
#include <utility>

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnknownKey{Effect::Slight, "members are unknown and ignored"};

}  // namespace

Vec3 vector_of(const LocatedJson& json) {
  return json.is(LocatedJson::Kind::Number) ? Vec3(json.as<float>()) : json.as<Vec3>();
}

ObjectReader::ObjectReader(const Context& context, const LocatedJson& json, std::string what)
    : context_(context), json_(json), what_(std::move(what)) {
  if (!json.is(LocatedJson::Kind::Object)) json.fail_type(what_ + ", which is an object");
}

std::optional<LocatedJson> ObjectReader::find(Names names) const {
  accept(names);
  for (const std::string_view name : names) {
    if (auto found = json_.find(name)) return found;
  }
  return std::nullopt;
}

void ObjectReader::accept(std::span<const std::string_view> names) const {
  for (const std::string_view name : names) {
    if (std::find(known_.begin(), known_.end(), name) == known_.end()) known_.emplace_back(name);
  }
}

void ObjectReader::report_unknown() const {
  for (const auto& [name, key, value] : json_.members()) {
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    context_.warnings.add(
        kUnknownKey, key.where(),
        unknown_name_message("member of " + what_, printable(name), known_) + ". Ignored",
        printable(name));
  }
}

}  // namespace ajar::tungsten
