#pragma once
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/tungsten/context.h"

namespace ajar::tungsten {

/// Looks up the members of a JSON object, and reports members that were never looked up. Where
/// several names are given, the first that the object has counts: older files have other names.
/// Values of the wrong type raise SceneError at their place.
class ObjectReader {
 public:
  /// `what` is its kind in messages, as in "a quad". Raises SceneError if `json` is no object.
  ObjectReader(const Context& context, const LocatedJson& json, std::string what);

  const Context& context() const { return context_; }
  const SourceLocation& where() const { return json_.where(); }
  const std::string& what() const { return what_; }

  /// Null if the object has none.
  const LocatedJson* find(std::initializer_list<std::string_view> names) const;
  const LocatedJson* find(std::string_view name) const { return find({name}); }
  std::optional<bool> flag(std::string_view name) const;
  std::optional<float> number(std::string_view name) const;
  std::optional<int> integer(std::string_view name) const;
  std::optional<std::string> text(std::initializer_list<std::string_view> names) const;
  std::optional<std::string> text(std::string_view name) const { return text({name}); }
  /// A number for all lanes, or three numbers.
  std::optional<Vec3> vector(std::initializer_list<std::string_view> names) const;
  std::optional<Vec3> vector(std::string_view name) const { return vector({name}); }

  /// Names that have no meaning for us but are no mistakes.
  void accept(std::span<const std::string_view> names) const;
  void accept(std::initializer_list<std::string_view> names) const {
    accept(std::span(names.begin(), names.size()));
  }
  /// Warns of each member that was not asked for, and of each that stands there twice.
  void report_unknown() const;

 private:
  const Context& context_;
  const LocatedJson& json_;
  std::string what_;
  mutable std::vector<std::string> known_;
};

/// The values of single members. Raise SceneError if they are of another type or not finite as
/// floats.
float number_of(const LocatedJson& json);
int integer_of(const LocatedJson& json);
bool flag_of(const LocatedJson& json);
const std::string& text_of(const LocatedJson& json);
Vec3 vector_of(const LocatedJson& json);

}  // namespace ajar::tungsten
