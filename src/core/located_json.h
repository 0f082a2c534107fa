#pragma once
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/vector.h"

namespace ajar {

class LocatedJson;

template <typename E>
[[noreturn]] void raise_error(const std::string& message) {
  throw E(message);
}

/// Dialect of a JSON text, and its errors.
struct JsonRules {
  /// In messages. Without it, a value is told by its JSON pointer alone.
  std::string name = {};
  /// Raises the errors of the text and of its values, which begin with their places.
  void (*raise)(const std::string& message) = raise_error<SceneError>;
  /// Most levels of arrays and objects, for recursive users: reading is not recursive.
  std::size_t deepest = std::numeric_limits<std::size_t>::max();
  bool first_counts = false;    ///< the first of several members of a name; else the last
  bool has_extras = false;      ///< comments, and a comma behind the last part
  bool null_is_absent = false;  ///< a member that is null is as if it were not there
  bool may_have_zeros = true;   ///< zero bytes, where names of files end
  /// Place of a value, if it is not that in the text.
  SourceLocation (*place)(const LocatedJson& value) = nullptr;
};

/// A value of a JSON text that knows where it is: `room.gltf:12:5#/materials/3`, that is, line,
/// column, and JSON pointer (RFC 6901). Accessors raise errors with that place for values of other
/// types. It keeps the text, in which a value is a few numbers; copies are cheap.
class LocatedJson {
 public:
  enum class Kind : std::uint8_t { Null, Bool, Number, Text, Array, Object };
  struct Member;
  /// A name that stands in an object again.
  struct Repeated {
    std::string name;
    SourceLocation where;
  };

  /// Raises an error, with line and column, for text that is no JSON, for numbers beyond the range
  /// of doubles, and for values that are nested too deep.
  static LocatedJson parse(std::string text, JsonRules rules);

  Kind kind() const;
  bool is(Kind kind) const { return this->kind() == kind; }
  SourceLocation where() const;
  std::string pointer() const;
  /// Array or object around it; none of the whole.
  std::optional<LocatedJson> parent() const;
  /// Name or number in it.
  std::string name() const;
  const JsonRules& rules() const;
  /// The value as in the text, in one line and shortened, for messages.
  std::string shown() const;
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_type(const std::string& expected) const {
    fail("must be " + expected + ", not " + shown());
  }
  /// Runs `make`, and adds the place to an error that it raises, unless it has one.
  template <typename Make>
  auto located(const Make& make) const -> decltype(make()) {
    try {
      return make();
    } catch (const IoError&) {
      throw;  // names its file
    } catch (const Error& error) {
      add_place(error);
    }
  }

  /// The value as bool, a whole number, a float or double, text, Vec3, a std::vector or std::array
  /// of these, or itself. Whole numbers may be written as 3.0.
  template <typename T>
  T as() const;
  bool flag() const;
  double number() const;
  std::string text() const;
  template <std::integral T>
  T whole(T least, T most) const;
  /// A number of something of which there are `count`.
  std::size_t index(std::size_t count) const;
  /// Text as it is, others as the shortest JSON of their value.
  std::string plain() const;

  /// Parts of an array.
  std::size_t size() const;
  LocatedJson operator[](std::size_t i) const;
  std::vector<LocatedJson> items() const;

  /// Members of an object, in the order of the text.
  std::vector<Member> members() const;
  template <typename T = LocatedJson>
  std::optional<T> find(std::string_view name) const {
    const std::optional<LocatedJson> member = find_member(name);
    return member ? std::optional<T>(member->as<T>()) : std::nullopt;
  }
  bool has(std::string_view name) const { return find_member(name).has_value(); }
  template <typename T = LocatedJson>
  T at(std::string_view name) const {
    return required(name).as<T>();
  }
  template <typename T>
  T value_or(std::string_view name, T fallback) const {
    return find<T>(name).value_or(fallback);
  }
  std::optional<std::size_t> find_index(std::string_view name, std::size_t count) const {
    const std::optional<LocatedJson> member = find_member(name);
    return member ? std::optional(member->index(count)) : std::nullopt;
  }
  /// Parts of the array `name`; none if there is no such member.
  std::vector<LocatedJson> items(std::string_view name) const;
  /// Raises an error, with the nearest name, if this is no object or has other members.
  void check_members(std::string_view kind, const std::vector<std::string>& names) const;

  /// Names that stand in an object again, in all of the text but no more than `most`.
  std::vector<Repeated> repeated(std::size_t most) const;
  std::size_t repeated_count() const;

  /// An object without members, in this place.
  LocatedJson without_members() const;

 private:
  struct Node;
  struct Tree;
  class Builder;

  LocatedJson(std::shared_ptr<const Tree> tree, std::uint32_t node)
      : tree_(std::move(tree)), node_(node) {}
  const Node& node() const;
  std::string_view source() const;
  LocatedJson child(std::size_t i) const;
  std::optional<LocatedJson> find_member(std::string_view name) const;
  LocatedJson required(std::string_view name) const;
  void require(Kind kind, const char* expected) const;
  [[noreturn]] void add_place(const Error& error) const;

  std::shared_ptr<const Tree> tree_;
  std::uint32_t node_;
  bool is_emptied_ = false;
};

struct LocatedJson::Member {
  std::string name;
  LocatedJson key;  ///< the name: its own line and column, and the pointer of the object
  LocatedJson value;
};

template <std::integral T>
T LocatedJson::whole(T least, T most) const {
  const std::string_view digits = source();
  T value{};
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  bool fits = is(Kind::Number) && read.ec == std::errc() && read.ptr == digits.end();
  if (is(Kind::Number) && !fits) {
    constexpr double kExact = 9007199254740992.0;
    const double written = number();
    fits = written == std::floor(written) && std::abs(written) <= kExact &&
           written >= static_cast<double>(least) && written <= static_cast<double>(most);
    if (fits) value = static_cast<T>(written);
  }
  if (!fits || value < least || value > most) {
    fail_type("a whole number from " + std::to_string(least) +
              (std::cmp_equal(most, std::numeric_limits<std::uint64_t>::max())
                   ? " on"
                   : " to " + std::to_string(most)));
  }
  return value;
}

template <typename T>
T LocatedJson::as() const {
  if constexpr (std::same_as<T, LocatedJson>) {
    return *this;
  } else if constexpr (std::same_as<T, bool>) {
    return flag();
  } else if constexpr (std::integral<T>) {
    return whole<T>(std::numeric_limits<T>::min(), std::numeric_limits<T>::max());
  } else if constexpr (std::floating_point<T>) {
    const auto value = static_cast<T>(number());
    if (!std::isfinite(value)) fail_type("a number of at most 3.4e38");
    return value;
  } else if constexpr (std::same_as<T, std::string>) {
    return text();
  } else if constexpr (std::same_as<T, Vec3>) {
    const auto numbers = as<std::array<float, 3>>();
    return {numbers[0], numbers[1], numbers[2]};
  } else {
    T values{};
    if constexpr (requires { values.resize(1); }) {
      values.resize(size());
    } else if (!is(Kind::Array) || size() != values.size()) {
      fail_type(std::to_string(values.size()) + " numbers");
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = (*this)[i].template as<typename T::value_type>();
    }
    return values;
  }
}

}  // namespace ajar
