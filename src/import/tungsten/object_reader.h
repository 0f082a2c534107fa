#pragma once
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/tungsten/context.h"

namespace ajar::tungsten {

/// A number for all lanes, or three numbers.
Vec3 vector_of(const LocatedJson& json);

/// Looks up the members of a JSON object, and reports members that were never looked up. Where
/// several names are given, the first that the object has counts: older files have other names.
/// Values of the wrong type raise SceneError at their place.
class ObjectReader {
 public:
  using Names = std::initializer_list<std::string_view>;

  /// `what` is its kind in messages, as in "a quad". Raises SceneError if `json` is no object.
  ObjectReader(const Context& context, const LocatedJson& json, std::string what);

  const Context& context() const { return context_; }
  SourceLocation where() const { return json_.where(); }
  const std::string& what() const { return what_; }

  std::optional<LocatedJson> find(Names names) const;
  std::optional<LocatedJson> find(std::string_view name) const { return find({name}); }
  bool has(Names names) const { return find(names).has_value(); }
  bool has(std::string_view name) const { return has({name}); }
  std::optional<bool> flag(std::string_view name) const { return get<bool>({name}); }
  std::optional<float> number(std::string_view name) const { return get<float>({name}); }
  std::optional<int> integer(std::string_view name) const { return get<int>({name}); }
  std::optional<std::string> text(Names names) const { return get<std::string>(names); }
  std::optional<std::string> text(std::string_view name) const { return text({name}); }
  std::optional<Vec3> vector(Names names) const {
    const auto found = find(names);
    return found ? std::optional(vector_of(*found)) : std::nullopt;
  }
  std::optional<Vec3> vector(std::string_view name) const { return vector({name}); }

  /// Names that have no meaning for us but are no mistakes.
  void accept(std::span<const std::string_view> names) const;
  void accept(Names names) const { accept(std::span(names.begin(), names.size())); }
  /// Warns of each member that was not asked for.
  void report_unknown() const;

 private:
  template <typename T>
  std::optional<T> get(Names names) const {
    const auto found = find(names);
    return found ? std::optional(found->as<T>()) : std::nullopt;
  }

  const Context& context_;
  LocatedJson json_;
  std::string what_;
  mutable std::vector<std::string> known_;
};

}  // namespace ajar::tungsten
