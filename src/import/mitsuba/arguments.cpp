#include "import/mitsuba/arguments.h"

#include <algorithm>
#include <map>

#include "import/common/printable.h"
#include "import/mitsuba/names.h"
#include "import/mitsuba/spectrum_plugins.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kOtherKind{Effect::Surface,
                                 "properties are of another kind than expected and ignored"};
constexpr WarningKind kSameProperty{Effect::Surface, "properties are there twice: the last counts"};
constexpr WarningKind kUnknownProperty{Effect::Slight, "properties are unknown and ignored"};

}  // namespace

Arguments::Arguments(Context& context, const Element& element)
    : context_(context),
      element_(element),
      used_properties_(element.properties.size()),
      used_children_(element.children.size()) {}

const Property* Arguments::find(std::string_view name) {
  if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) asked_.emplace_back(name);
  const Property* found = nullptr;
  for (std::size_t i = 0; i < element_.properties.size(); ++i) {
    if (element_.properties[i].name != name) continue;
    used_properties_[i] = true;
    found = &element_.properties[i];  // of several the last
  }
  return found;
}

void Arguments::warn_kind(const Property& property, const char* expected) const {
  context_.warnings.add(kOtherKind, property.where,
                        "\"" + printable(property.name) + "\" must be " + expected + ": ignored",
                        printable(property.name));
}

template <typename T>
std::optional<T> Arguments::get(std::string_view name, const char* expected) {
  const Property* property = find(name);
  if (property == nullptr) return std::nullopt;
  if (const T* value = std::get_if<T>(&property->value)) return *value;
  warn_kind(*property, expected);
  return std::nullopt;
}

std::optional<bool> Arguments::flag(std::string_view name) { return get<bool>(name, "a boolean"); }

std::optional<std::string> Arguments::text(std::string_view name) {
  return get<std::string>(name, "a string");
}

std::string Arguments::word(std::string_view name, const std::string& fallback) {
  return lower_case(text(name, fallback));
}

std::optional<Vec3d> Arguments::vector(std::string_view name) {
  return get<Vec3d>(name, "a point or a vector");
}

std::optional<Mat4> Arguments::transform(std::string_view name) {
  return get<Mat4>(name, "a transform");
}

std::optional<long long> Arguments::integer(std::string_view name) {
  return get<long long>(name, "an integer");
}

std::optional<double> Arguments::number(std::string_view name) {
  const Property* property = find(name);
  if (property == nullptr) return std::nullopt;
  if (const double* value = std::get_if<double>(&property->value)) return *value;
  if (const long long* value = std::get_if<long long>(&property->value)) {
    return static_cast<double>(*value);
  }
  warn_kind(*property, "a number");
  return std::nullopt;
}

std::optional<desc::Rgb> Arguments::color(std::string_view name, const char* expected) {
  if (const Element* spectrum = child(name, "spectrum")) {
    return evaluate_spectrum(context_, *spectrum);
  }
  const Property* property = find(name);
  if (property == nullptr) return std::nullopt;
  if (const auto* value = std::get_if<desc::Rgb>(&property->value)) return *value;
  if (const double* value = std::get_if<double>(&property->value)) {
    return desc::Rgb(static_cast<float>(*value));
  }
  if (const long long* value = std::get_if<long long>(&property->value)) {
    return desc::Rgb(static_cast<float>(*value));
  }
  warn_kind(*property, expected);
  return std::nullopt;
}

bool Arguments::has(std::string_view name) const {
  const auto is_it = [&](const auto& thing) { return thing.name == name; };
  return std::any_of(element_.properties.begin(), element_.properties.end(), is_it) ||
         std::any_of(element_.children.begin(), element_.children.end(), is_it);
}

bool Arguments::has_text(std::string_view name) const {
  return std::any_of(
      element_.properties.begin(), element_.properties.end(), [&](const Property& property) {
        return property.name == name && std::holds_alternative<std::string>(property.value);
      });
}

const Element* Arguments::child(std::string_view name, std::string_view tag) {
  for (std::size_t i = 0; i < element_.children.size(); ++i) {
    const Child& child = element_.children[i];
    if (child.name != name) continue;
    const Element& element = context_.document.resolve(child);
    if (element.tag != tag) continue;
    used_children_[i] = true;
    return &element;
  }
  return nullptr;
}

std::vector<const Element*> Arguments::children(std::string_view tag) {
  std::vector<const Element*> found;
  for (std::size_t i = 0; i < element_.children.size(); ++i) {
    const Element& element = context_.document.resolve(element_.children[i]);
    if (element.tag != tag) continue;
    used_children_[i] = true;
    found.push_back(&element);
  }
  return found;
}

void Arguments::accept(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    find(name);
    for (std::size_t i = 0; i < element_.children.size(); ++i) {
      if (element_.children[i].name == name) used_children_[i] = true;
    }
  }
}

void Arguments::accept_all() {
  std::fill(used_properties_.begin(), used_properties_.end(), true);
  std::fill(used_children_.begin(), used_children_.end(), true);
}

std::string Arguments::spelled(std::string_view name) const {
  return context_.document.major_version == 0 ? camel_case(name) : std::string(name);
}

void Arguments::report_unused() const {
  std::vector<std::string> valid;
  for (const std::string& name : asked_) valid.push_back(spelled(name));
  const std::string owner =
      "<" + element_.tag +
      (element_.type.empty() ? "" : " type=\"" + printable(element_.type) + "\"") + ">";
  const auto report = [&](const SourceLocation& where, const std::string& name) {
    const std::string shown = printable(spelled(name));
    const std::string nearest = nearest_name(spelled(name), valid);
    context_.warnings.add(kUnknownProperty, where,
                          owner + " has no property \"" + shown + "\"" +
                              (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") +
                              ": ignored",
                          shown);
  };
  std::map<std::string_view, std::size_t> last;
  for (std::size_t i = 0; i < used_properties_.size(); ++i) last[element_.properties[i].name] = i;
  for (std::size_t i = 0; i < used_properties_.size(); ++i) {
    const Property& property = element_.properties[i];
    if (!used_properties_[i]) {
      report(property.where, property.name);
    } else if (last[property.name] != i) {
      const std::string shown = printable(spelled(property.name));
      context_.warnings.add(kSameProperty, property.where,
                            owner + " has another \"" + shown + "\", which counts instead of this",
                            shown);
    }
  }
  for (std::size_t i = 0; i < used_children_.size(); ++i) {
    const Child& child = element_.children[i];
    if (used_children_[i]) continue;
    report(child.where, child.name.empty() ? context_.document.resolve(child).tag : child.name);
  }
}

}  // namespace ajar::mitsuba
