#include "import/tungsten/object_reader.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnknownKey{Effect::Slight, "members are unknown and ignored"};
constexpr WarningKind kTwice{Effect::Slight, "members stand twice: the first counts"};

using Kind = LocatedJson::Kind;

[[noreturn]] void fail_type(const LocatedJson& json, std::string_view expected) {
  throw SceneError(json.where(),
                   "expected " + std::string(expected) + ", not " + std::string(json.kind_name()));
}

void require(const LocatedJson& json, Kind kind, std::string_view expected) {
  if (!json.is(kind)) fail_type(json, expected);
}

}  // namespace

float number_of(const LocatedJson& json) {
  require(json, Kind::Number, "a number");
  const auto value = static_cast<float>(json.number());
  if (!std::isfinite(value)) throw SceneError(json.where(), "the number is too large");
  return value;
}

int integer_of(const LocatedJson& json) {
  require(json, Kind::Number, "a whole number");
  const double value = json.number();
  constexpr double kLargest = 2147483647.0;
  if (std::floor(value) != value || std::abs(value) > kLargest) {
    throw SceneError(json.where(), "expected a whole number of at most 2147483647");
  }
  return static_cast<int>(value);
}

bool flag_of(const LocatedJson& json) {
  require(json, Kind::Bool, "true or false");
  return json.flag();
}

const std::string& text_of(const LocatedJson& json) {
  require(json, Kind::String, "a text");
  return json.text();
}

Vec3 vector_of(const LocatedJson& json) {
  if (json.is(Kind::Number)) return Vec3(number_of(json));
  require(json, Kind::Array, "a number or an array of three numbers");
  if (json.items().size() != 3) {
    throw SceneError(json.where(),
                     "expected three numbers, not " + std::to_string(json.items().size()));
  }
  return {number_of(json.items()[0]), number_of(json.items()[1]), number_of(json.items()[2])};
}

ObjectReader::ObjectReader(const Context& context, const LocatedJson& json, std::string what)
    : context_(context), json_(json), what_(std::move(what)) {
  if (!json.is(Kind::Object)) fail_type(json, what_ + ", which is an object");
}

const LocatedJson* ObjectReader::find(std::initializer_list<std::string_view> names) const {
  accept(names);
  for (const std::string_view name : names) {
    if (const LocatedJson* found = json_.find(name)) return found;
  }
  return nullptr;
}

std::optional<bool> ObjectReader::flag(std::string_view name) const {
  const LocatedJson* found = find(name);
  return found != nullptr ? std::optional(flag_of(*found)) : std::nullopt;
}

std::optional<float> ObjectReader::number(std::string_view name) const {
  const LocatedJson* found = find(name);
  return found != nullptr ? std::optional(number_of(*found)) : std::nullopt;
}

std::optional<int> ObjectReader::integer(std::string_view name) const {
  const LocatedJson* found = find(name);
  return found != nullptr ? std::optional(integer_of(*found)) : std::nullopt;
}

std::optional<std::string> ObjectReader::text(std::initializer_list<std::string_view> names) const {
  const LocatedJson* found = find(names);
  return found != nullptr ? std::optional(text_of(*found)) : std::nullopt;
}

std::optional<Vec3> ObjectReader::vector(std::initializer_list<std::string_view> names) const {
  const LocatedJson* found = find(names);
  return found != nullptr ? std::optional(vector_of(*found)) : std::nullopt;
}

void ObjectReader::accept(std::span<const std::string_view> names) const {
  for (const std::string_view name : names) {
    if (std::find(known_.begin(), known_.end(), name) == known_.end()) known_.emplace_back(name);
  }
}

void ObjectReader::report_unknown() const {
  std::set<std::string_view> seen;
  for (const LocatedJson::Member& member : json_.members()) {
    if (!seen.insert(member.name).second) {
      context_.warnings.add(
          kTwice, member.where,
          "\"" + shown(member.name) + "\" stands twice in " + what_ + ": the first counts",
          shown(member.name));
    } else if (std::find(known_.begin(), known_.end(), member.name) == known_.end()) {
      context_.warnings.add(
          kUnknownKey, member.where,
          unknown_name_message("member of " + what_, shown(member.name), known_) + ". Ignored",
          shown(member.name));
    }
  }
}

}  // namespace ajar::tungsten
