#include "import/pbrt/parameter_list.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/printable_text.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/own_words.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnused{Effect::Slight, "parameters are unknown here and ignored"};
constexpr WarningKind kTwice{Effect::Slight, "parameters are given twice: the last counts"};
constexpr WarningKind kOneValue{
    Effect::Slight, "parameters do not have the one value that they must have: they are ignored"};

struct KindName {
  std::string_view name;
  ParameterKind kind;
};
/// The first name of each kind is the one used in messages.
constexpr std::array<KindName, 18> kKindNames = {{{"integer", ParameterKind::Integer},
                                                  {"float", ParameterKind::Float},
                                                  {"point2", ParameterKind::Point2},
                                                  {"vector2", ParameterKind::Vector2},
                                                  {"point", ParameterKind::Point3},
                                                  {"point3", ParameterKind::Point3},
                                                  {"vector", ParameterKind::Vector3},
                                                  {"vector3", ParameterKind::Vector3},
                                                  {"normal", ParameterKind::Normal3},
                                                  {"normal3", ParameterKind::Normal3},
                                                  {"bool", ParameterKind::Bool},
                                                  {"string", ParameterKind::String},
                                                  {"texture", ParameterKind::Texture},
                                                  {"rgb", ParameterKind::Rgb},
                                                  {"color", ParameterKind::Rgb},
                                                  {"xyz", ParameterKind::Xyz},
                                                  {"blackbody", ParameterKind::Blackbody},
                                                  {"spectrum", ParameterKind::Spectrum}}};

void warn_unused(const Parameter& p, const std::vector<std::string>& asked, Warnings& warnings) {
  const std::string declaration =
      "\"" + std::string(kind_name(p.kind)) + " " + printable(p.name) + "\"";
  std::string message = "unused parameter " + declaration;
  if (std::find(asked.begin(), asked.end(), p.name) != asked.end()) {
    message += ": it must be of another type here";
  } else if (const std::string near = nearest_name(p.name, asked); !near.empty()) {
    message += "; did you mean \"" + near + "\"?";
  }
  warnings.add(kUnused, p.where, message, declaration);
}

}  // namespace

std::string_view kind_name(ParameterKind kind) {
  const auto found = std::find_if(kKindNames.begin(), kKindNames.end(),
                                  [&](const KindName& entry) { return entry.kind == kind; });
  return found->name;
}

std::optional<ParameterKind> kind_from_name(std::string_view name) {
  const auto found = std::find_if(kKindNames.begin(), kKindNames.end(),
                                  [&](const KindName& entry) { return entry.name == name; });
  if (found == kKindNames.end()) return std::nullopt;
  return found->kind;
}

int numbers_per_value(ParameterKind kind, Dialect dialect) {
  if (kind == ParameterKind::Blackbody && dialect == Dialect::V4) return 1;
  switch (kind) {
    case ParameterKind::Point2:
    case ParameterKind::Vector2:
    case ParameterKind::Blackbody:
    case ParameterKind::Spectrum:
      return 2;
    case ParameterKind::Point3:
    case ParameterKind::Vector3:
    case ParameterKind::Normal3:
    case ParameterKind::Rgb:
    case ParameterKind::Xyz:
      return 3;
    default:
      return 1;
  }
}

std::size_t Parameter::size() const {
  if (kind == ParameterKind::Integer) return integers.size();
  if (!strings.empty()) return strings.size();
  if (kind == ParameterKind::Spectrum) return numbers.empty() ? 0 : 1;  // all pairs are one curve
  return numbers.size() / static_cast<std::size_t>(numbers_per_value(kind, dialect));
}

void ParameterList::add(Parameter parameter, Warnings& warnings) {
  warnings_ = &warnings;
  const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.parameter->name == parameter.name;
  });
  if (same != entries_.end()) {
    warnings.add(kTwice, parameter.where,
                 "parameter \"" + parameter.name + "\" is given twice: the last counts",
                 parameter.name);
    same->parameter = std::make_shared<const Parameter>(std::move(parameter));
  } else {
    entries_.push_back({std::make_shared<const Parameter>(std::move(parameter))});
  }
}

void ParameterList::add_defaults(std::span<const AttributePointer> defaults, Warnings& warnings) {
  warnings_ = &warnings;
  for (const AttributePointer& attribute : defaults) {
    const bool is_given = std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
      return entry.parameter->name == attribute->parameter->name;
    });
    if (is_given) continue;
    attribute->was_offered = true;
    entries_.push_back({attribute->parameter, attribute, true});
  }
}

void ParameterList::Entry::use() const {
  used = true;
  if (attribute) attribute->was_used = true;
}

std::vector<ParameterPointer> ParameterList::parameters() const {
  std::vector<ParameterPointer> result;
  for (const Entry& entry : entries_) result.push_back(entry.parameter);
  return result;
}

const Parameter* ParameterList::find(std::string_view name,
                                     std::span<const ParameterKind> kinds) const {
  if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) asked_.emplace_back(name);
  for (const Entry& entry : entries_) {
    const Parameter& p = *entry.parameter;
    if (p.name != name) continue;
    if (std::find(kinds.begin(), kinds.end(), p.kind) == kinds.end()) continue;
    entry.use();
    return &p;
  }
  return nullptr;
}

const Parameter* ParameterList::find_one(std::string_view name,
                                         std::span<const ParameterKind> kinds) const {
  const Parameter* p = find(name, kinds);
  if (p == nullptr || p->size() == 1) return p;
  warnings_->add(kOneValue, p->where,
                 "parameter \"" + p->name + "\" must have one value, not " +
                     std::to_string(p->size()) + ": ignored",
                 p->name);
  return nullptr;
}

bool ParameterList::get_bool(std::string_view name, bool fallback) const {
  return get_bool(name).value_or(fallback);
}
std::optional<bool> ParameterList::get_bool(std::string_view name) const {
  const Parameter* p = find_one(name, ParameterKind::Bool);
  return p == nullptr ? std::nullopt : std::optional(p->strings.front() == "true");
}
int ParameterList::get_int(std::string_view name, int fallback) const {
  return get_int(name).value_or(fallback);
}
std::optional<int> ParameterList::get_int(std::string_view name) const {
  const Parameter* p = find_one(name, ParameterKind::Integer);
  return p == nullptr ? std::nullopt : std::optional(p->integers.front());
}
float ParameterList::get_float(std::string_view name, float fallback) const {
  return get_float(name).value_or(fallback);
}
std::optional<float> ParameterList::get_float(std::string_view name) const {
  const Parameter* p = find_one(name, ParameterKind::Float);
  return p == nullptr ? std::nullopt : std::optional(p->numbers.front());
}
std::string ParameterList::get_string(std::string_view name, const std::string& fallback) const {
  return get_string(name).value_or(fallback);
}
std::optional<std::string> ParameterList::get_string(std::string_view name) const {
  const Parameter* p = find_one(name, ParameterKind::String);
  return p == nullptr ? std::nullopt : std::optional(p->strings.front());
}

std::vector<std::string> ParameterList::get_strings(std::string_view name) const {
  const Parameter* p = find(name, ParameterKind::String);
  return p == nullptr ? std::vector<std::string>() : p->strings;
}

std::vector<Vec3> ParameterList::get_triples(std::string_view name, ParameterKind kind) const {
  const Parameter* p = find(name, kind);
  if (p == nullptr) return {};
  std::vector<Vec3> result(p->numbers.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = Vec3(p->numbers[3 * i], p->numbers[3 * i + 1], p->numbers[3 * i + 2]);
  }
  return result;
}
std::vector<Vec3> ParameterList::get_points(std::string_view name) const {
  return get_triples(name, ParameterKind::Point3);
}
std::vector<Vec3> ParameterList::get_vectors(std::string_view name) const {
  return get_triples(name, ParameterKind::Vector3);
}
std::vector<Vec3> ParameterList::get_normals(std::string_view name) const {
  return get_triples(name, ParameterKind::Normal3);
}
Vec3 ParameterList::get_point(std::string_view name, const Vec3& fallback) const {
  return get_point(name).value_or(fallback);
}
std::optional<Vec3> ParameterList::get_point(std::string_view name) const {
  if (find_one(name, ParameterKind::Point3) == nullptr) return std::nullopt;
  return get_points(name).front();
}
std::optional<Vec3> ParameterList::get_vector(std::string_view name) const {
  if (find_one(name, ParameterKind::Vector3) == nullptr) return std::nullopt;
  return get_vectors(name).front();
}

std::vector<Vec2> ParameterList::get_point2s(std::string_view name) const {
  static constexpr std::array kKinds = {ParameterKind::Point2, ParameterKind::Vector2,
                                        ParameterKind::Float};
  const Parameter* p = find(name, kKinds);
  if (p == nullptr) return {};
  std::vector<Vec2> result(p->numbers.size() / 2);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = Vec2(p->numbers[2 * i], p->numbers[2 * i + 1]);
  }
  return result;
}

void ParameterList::accept(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names) {
    asked_.emplace_back(name);
    for (const Entry& entry : entries_) {
      if (entry.parameter->name == name) entry.use();
    }
  }
}

std::size_t ParameterList::used_count() const {
  return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(),
                                                [](const Entry& entry) { return entry.used; }));
}

bool ParameterList::has_own_words() const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [](const Entry& entry) { return has_own_prefix(entry.parameter->name); });
}

void ParameterList::report_unused(Warnings& warnings) const {
  const bool has_own = has_own_words();
  for (const Entry& entry : entries_) {
    const bool is_for_pbrt = has_own && !has_own_prefix(entry.parameter->name);
    if (!entry.used && !is_for_pbrt) warn_unused(*entry.parameter, asked_, warnings);
    if (!entry.attribute || entry.attribute->was_used) continue;
    if (entry.attribute->asked.empty()) entry.attribute->asked = asked_;
  }
}

void report_unused(std::span<const AttributePointer> attributes, Warnings& warnings) {
  for (const AttributePointer& attribute : attributes) {
    if (!attribute->was_offered || attribute->was_used) continue;
    warn_unused(*attribute->parameter, attribute->asked, warnings);
  }
}

}  // namespace ajar::pbrt
