#include "import/mitsuba/arguments.h"

#include <algorithm>
#include <exception>
#include <map>

#include "core/printable_text.h"
#include "import/mitsuba/names.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/spectrum_plugins.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kOtherKind{Effect::Surface,
                                 "properties are of another kind than expected and ignored"};
constexpr WarningKind kSameProperty{Effect::Surface, "properties are there twice: the last counts"};
constexpr WarningKind kUnknownProperty{Effect::Slight, "properties are unknown and ignored"};
constexpr WarningKind kOneTooMany{Effect::Surface,
                                  "elements have more elements in them than they may: ignored"};

/// By references any depth could be written, and stacks end.
constexpr std::size_t kDeepestReferences = 200;

}  // namespace

Arguments::Arguments(Context& context, const Element& element)
    : context_(context),
      element_(element),
      used_properties_(element.properties.size()),
      used_children_(element.children.size()),
      exceptions_(std::uncaught_exceptions()) {
  for (const Child& child : element.children) {
    children_.push_back(&context.document.resolve(child));
  }
  if (context.open.size() >= kDeepestReferences) {
    throw SceneError(element.where, "elements are nested too deeply");
  }
  if (!context.open.insert(&element).second) {
    throw SceneError(element.where, "this <" + element.tag + "> refers to itself");
  }
}

Arguments::~Arguments() {
  context_.open.erase(&element_);
  if (std::uncaught_exceptions() > exceptions_) return;
  if (context_.reported.insert(&element_).second) report_unused();
}

void Arguments::ask(std::string_view name) {
  if (!was_asked(name)) asked_.emplace_back(name);
}

bool Arguments::was_asked(std::string_view name) const {
  return std::find(asked_.begin(), asked_.end(), name) != asked_.end();
}

const Property* Arguments::find(std::string_view name) {
  ask(name);
  const Property* found = nullptr;
  for (std::size_t i = 0; i < element_.properties.size(); ++i) {
    if (element_.properties[i].name != name) continue;
    used_properties_[i] = true;
    found = &element_.properties[i];  // the last of several counts
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
  const auto is_even = [](const Element& element) {
    return is_spectrum(element) || (element.tag == "texture" && !is_known(element));
  };
  if (const Element* spectrum = find_child(name, is_even)) {
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
  return find_child(name, [&](const Element& element) { return element.tag == tag; });
}

const Element* Arguments::texture(std::string_view name) {
  return find_child(name, [](const Element& element) {
    return element.tag == "texture" && !is_spectrum(element);
  });
}

const Element* Arguments::find_child(std::string_view name,
                                     const std::function<bool(const Element&)>& is_meant) {
  ask(name);
  for (std::size_t i = 0; i < children_.size(); ++i) {
    if (element_.children[i].name != name || !is_meant(*children_[i])) continue;
    used_children_[i] = Use::Used;
    return children_[i];
  }
  return nullptr;
}

std::vector<const Element*> Arguments::children(std::string_view tag, std::size_t most) {
  std::vector<const Element*> found;
  for (std::size_t i = 0; i < children_.size(); ++i) {
    if (children_[i]->tag != tag) continue;
    used_children_[i] = found.size() < most ? Use::Used : Use::OneTooMany;
    if (found.size() < most) found.push_back(children_[i]);
  }
  return found;
}

const Element* Arguments::only_child(std::string_view tag) {
  const std::vector<const Element*> found = children(tag, 1);
  return found.empty() ? nullptr : found.front();
}

void Arguments::accept(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    find(name);
    for (std::size_t i = 0; i < element_.children.size(); ++i) {
      if (element_.children[i].name == name) used_children_[i] = Use::Used;
    }
  }
}

void Arguments::accept_all() {
  std::fill(used_properties_.begin(), used_properties_.end(), true);
  std::replace(used_children_.begin(), used_children_.end(), Use::None, Use::Used);
}

std::string Arguments::spelled(std::string_view name) const {
  return context_.document.major_version == 0 ? camel_case(name) : std::string(name);
}

std::string Arguments::owner() const {
  return "<" + element_.tag +
         (element_.type.empty() ? "" : " type=\"" + printable(element_.type) + "\"") + ">";
}

void Arguments::report_unused() const {
  std::map<std::string_view, std::size_t> last;
  for (std::size_t i = 0; i < used_properties_.size(); ++i) last[element_.properties[i].name] = i;
  for (std::size_t i = 0; i < used_properties_.size(); ++i) {
    const Property& property = element_.properties[i];
    if (!used_properties_[i]) {
      report(property.where, property.name, "a property");
    } else if (last[property.name] != i) {
      report_twice(property.where, property.name);
    }
  }
  for (std::size_t i = 0; i < used_children_.size(); ++i) {
    const SourceLocation& where = element_.children[i].where;
    const std::string& name = element_.children[i].name;
    const std::string tag = "<" + children_[i]->tag + ">";
    if (used_children_[i] == Use::OneTooMany) {
      context_.warnings.add(kOneTooMany, where,
                            owner() + " has more of " + tag + " than it can use: this is ignored",
                            printable(children_[i]->type));
    } else if (used_children_[i] == Use::None) {
      report(where, name.empty() ? children_[i]->tag : name, tag);
    }
  }
}

bool Arguments::is_used(std::string_view name) const {
  for (std::size_t i = 0; i < used_properties_.size(); ++i) {
    if (used_properties_[i] && element_.properties[i].name == name) return true;
  }
  for (std::size_t i = 0; i < used_children_.size(); ++i) {
    if (used_children_[i] == Use::Used && element_.children[i].name == name) return true;
  }
  return false;
}

void Arguments::report(const SourceLocation& where, const std::string& name,
                       const std::string& kind) const {
  if (!was_asked(name)) return report_unknown(where, name);
  if (is_used(name)) return report_twice(where, name);
  const std::string shown = printable(spelled(name));
  context_.warnings.add(kOtherKind, where,
                        "\"" + shown + "\" of " + owner() + " cannot be " + kind + ": ignored",
                        shown);
}

void Arguments::report_twice(const SourceLocation& where, const std::string& name) const {
  const std::string shown = printable(spelled(name));
  context_.warnings.add(kSameProperty, where,
                        owner() + " has another \"" + shown + "\", which counts instead of this",
                        shown);
}

void Arguments::report_unknown(const SourceLocation& where, const std::string& name) const {
  std::vector<std::string> valid;
  for (const std::string& asked : asked_) valid.push_back(spelled(asked));
  const std::string shown = printable(spelled(name));
  const std::string nearest = nearest_name(spelled(name), valid);
  context_.warnings.add(kUnknownProperty, where,
                        owner() + " has no property \"" + shown + "\"" +
                            (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") +
                            ": ignored",
                        shown);
}

}  // namespace ajar::mitsuba
