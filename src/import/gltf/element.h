#pragma once
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/vector.h"
#include "import/gltf/json_places.h"

namespace ajar::gltf {

using Json = nlohmann::json;

/// The file that elements are of.
struct Origin {
  std::string name;  ///< for messages
  JsonPlaces places;
};

/// A value in the JSON of a file that knows where it is. Accessors raise SceneError, located, for
/// values of another type.
class Element {
 public:
  /// `pointer`: JSON pointer (RFC 6901) of the value; empty for the whole.
  Element(const Json& value, std::shared_ptr<const Origin> origin, std::string pointer)
      : value_(&value), origin_(std::move(origin)), pointer_(std::move(pointer)) {}

  /// Line and column, and the JSON pointer as the fragment of a URI: `room.gltf:12:5#/materials/3`.
  /// Places in a .glb count from its JSON.
  SourceLocation where() const;
  const std::string& pointer() const { return pointer_; }
  [[noreturn]] void fail(const std::string& message) const;
  /// Runs `make`, and adds the place to the SceneError that it raises without one.
  template <typename Make>
  auto located(const Make& make) const -> decltype(make()) {
    try {
      return make();
    } catch (const SceneError& error) {
      fail(error.what());
    }
  }

  /// Elements of an array.
  std::size_t size() const;
  Element operator[](std::size_t i) const;
  /// The value itself.
  std::string text() const;
  double number() const;
  std::uint64_t whole() const;
  /// A number of something of which there are `count`.
  std::size_t index(std::size_t count) const;

  /// The element of the array `name` of `root` that this is the number of.
  Element referred(const Element& root, std::string_view name) const;

  /// A member of an object, if there is one.
  std::optional<Element> find(std::string_view name) const;
  Element at(std::string_view name) const;
  /// The elements of the array `name`; none if there is no such member.
  std::vector<Element> elements(std::string_view name) const;
  /// The member `name` of the member `extensions`.
  std::optional<Element> extension(std::string_view name) const;
  bool has(std::string_view name) const { return find(name).has_value(); }
  /// The names of the members of an object; none of anything else.
  std::vector<std::string> names() const;
  bool is_array() const { return value_->is_array(); }
  /// True if it, or anything in it, has a member whose name ends with this.
  bool mentions(std::string_view end_of_name) const;

  std::optional<double> find_number(std::string_view name) const;
  std::optional<std::string> find_text(std::string_view name) const;
  std::optional<std::size_t> find_index(std::string_view name, std::size_t count) const;
  /// All numbers of an array that must have `count`.
  std::optional<std::vector<double>> find_numbers(std::string_view name, std::size_t count) const;

  float number_or(std::string_view name, double fallback) const;
  std::uint64_t whole_or(std::string_view name, std::uint64_t fallback) const;
  bool flag_or(std::string_view name, bool fallback) const;
  std::string text_or(std::string_view name, const std::string& fallback) const;
  Vec3 vector_or(std::string_view name, const Vec3& fallback) const;

 private:
  void check_object() const;
  [[noreturn]] void fail_type(const char* expected) const;

  const Json* value_;
  std::shared_ptr<const Origin> origin_;
  std::string pointer_;
};

}  // namespace ajar::gltf
