#pragma once
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/mitsuba/context.h"

namespace ajar::mitsuba {

/// The properties and children of one plugin, looked up by name. Remembers what was looked up, and
/// at its end warns of the rest, with the nearest name that was, once for each element. A property
/// of another kind than is asked for counts as not given, with a warning.
class Arguments {
 public:
  static constexpr std::size_t kAll = static_cast<std::size_t>(-1);

  /// Raises SceneError for elements that are within themselves by reference or too deep within
  /// others, and for references to nothing.
  Arguments(Context& context, const Element& element);
  ~Arguments();
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  const Element& element() const { return element_; }
  const SourceLocation& where() const { return element_.where; }
  Context& context() const { return context_; }

  std::optional<bool> flag(std::string_view name);
  /// Numbers may be written as <integer> or <float>.
  std::optional<double> number(std::string_view name);
  std::optional<long long> integer(std::string_view name);
  std::optional<std::string> text(std::string_view name);
  /// A colour or a number, which is grey; or a constant texture. `expected` is its name in
  /// warnings.
  std::optional<desc::Rgb> color(std::string_view name, const char* expected = "a colour");
  std::optional<Vec3d> vector(std::string_view name);
  std::optional<Mat4> transform(std::string_view name);
  /// Values with a default.
  bool flag(std::string_view name, bool fallback) { return flag(name).value_or(fallback); }
  float number(std::string_view name, float fallback) {
    return static_cast<float>(number(name).value_or(static_cast<double>(fallback)));
  }
  std::string text(std::string_view name, const std::string& fallback) {
    return text(name).value_or(fallback);
  }
  /// One of some words, in small letters: capitals make no difference.
  std::string word(std::string_view name, const std::string& fallback);

  /// True if a property or a child of this name is there, of whatever kind.
  bool has(std::string_view name) const;
  /// True if a property of this name is there and is a string.
  bool has_text(std::string_view name) const;
  /// The child that is `name` to this plugin; null if there is none.
  const Element* child(std::string_view name, std::string_view tag);
  /// The texture that is `name` to this plugin, unless it is the same everywhere, as `color` has
  /// it; null if there is none.
  const Element* texture(std::string_view name);
  /// All children of this tag, in their order; of more than `most` only the first, with a warning.
  std::vector<const Element*> children(std::string_view tag, std::size_t most = kAll);
  /// The first child of this tag, with a warning if there are more; null if there is none.
  const Element* only_child(std::string_view tag);

  /// Marks properties that are known and have no meaning for us.
  void accept(std::initializer_list<std::string_view> names);
  void accept_all();

 private:
  enum class Use { None, Used, OneTooMany };

  void ask(std::string_view name);
  bool was_asked(std::string_view name) const;
  const Property* find(std::string_view name);
  const Element* find_child(std::string_view name,
                            const std::function<bool(const Element&)>& is_meant);
  /// The property as `T`; a warning if it is something else.
  template <typename T>
  std::optional<T> get(std::string_view name, const char* expected);
  void warn_kind(const Property& property, const char* expected) const;
  std::string spelled(std::string_view name) const;
  /// The element as messages call it.
  std::string owner() const;
  void report_unused() const;
  bool is_used(std::string_view name) const;
  /// Reports an unused property or child, which is `kind`.
  void report(const SourceLocation& where, const std::string& name, const std::string& kind) const;
  void report_twice(const SourceLocation& where, const std::string& name) const;
  void report_unknown(const SourceLocation& where, const std::string& name) const;

  Context& context_;
  const Element& element_;
  std::vector<bool> used_properties_;
  std::vector<const Element*> children_;  ///< elements that children are, or refer to
  std::vector<Use> used_children_;
  std::vector<std::string> asked_;
  int exceptions_;  ///< at the beginning
};

}  // namespace ajar::mitsuba
