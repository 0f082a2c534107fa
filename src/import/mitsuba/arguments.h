#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/mitsuba/context.h"

namespace ajar::mitsuba {

/// The properties and children of one plugin, looked up by name; remembers what was looked up, so
/// that the rest can be reported. A property of another kind than is asked for counts as not given,
/// with a warning.
class Arguments {
 public:
  Arguments(Context& context, const Element& element);

  const Element& element() const { return element_; }
  const SourceLocation& where() const { return element_.where; }
  Context& context() const { return context_; }

  std::optional<bool> flag(std::string_view name);
  /// Numbers may be written as <integer> or <float>.
  std::optional<double> number(std::string_view name);
  std::optional<long long> integer(std::string_view name);
  std::optional<std::string> text(std::string_view name);
  /// A colour or a number, which is grey; or a child <spectrum>.
  /// `expected` is what a warning calls it.
  std::optional<desc::Rgb> color(std::string_view name, const char* expected = "a colour");
  std::optional<Vec3d> vector(std::string_view name);
  std::optional<Mat4> transform(std::string_view name);
  /// The same for what has a default.
  bool flag(std::string_view name, bool fallback) { return flag(name).value_or(fallback); }
  float number(std::string_view name, float fallback) {
    return static_cast<float>(number(name).value_or(static_cast<double>(fallback)));
  }
  std::string text(std::string_view name, const std::string& fallback) {
    return text(name).value_or(fallback);
  }
  /// One of some words, in small letters: capitals make no difference.
  std::string word(std::string_view name, const std::string& fallback);

  /// Whether a property or a child of this name is there, of whatever kind.
  bool has(std::string_view name) const;
  /// Whether a property of this name is there and is a string.
  bool has_text(std::string_view name) const;
  /// The child that is `name` to this plugin; null if there is none.
  const Element* child(std::string_view name, std::string_view tag);
  /// All children of this tag, in their order.
  std::vector<const Element*> children(std::string_view tag);

  /// Marks what is known and has no meaning for us.
  void accept(std::initializer_list<std::string_view> names);
  void accept_all();
  /// Warns of all that nothing asked for, with the nearest name that was.
  void report_unused() const;

 private:
  const Property* find(std::string_view name);
  /// The property as `T`; a warning if it is something else.
  template <typename T>
  std::optional<T> get(std::string_view name, const char* expected);
  void warn_kind(const Property& property, const char* expected) const;
  std::string spelled(std::string_view name) const;

  Context& context_;
  const Element& element_;
  std::vector<bool> used_properties_;
  std::vector<bool> used_children_;
  std::vector<std::string> asked_;
};

}  // namespace ajar::mitsuba
