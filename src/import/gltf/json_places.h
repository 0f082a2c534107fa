#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ajar::gltf {

/// Where the values of a JSON text are.
class JsonPlaces {
 public:
  /// Lines and columns count from 1, 0 means unknown.
  struct Place {
    int line = 0;
    int column = 0;
  };
  /// A member that stands twice in the object at `pointer`.
  struct Repeated {
    std::string pointer;
    std::string name;
  };

  /// Place of the value at a JSON pointer (RFC 6901); for numbers in arrays, of the array; for
  /// missing values, of the nearest around.
  Place at(std::string_view pointer) const;
  /// The first hundred or fewer.
  const std::vector<Repeated>& repeated() const { return repeated_; }
  std::size_t more_repeated() const { return more_repeated_; }

 private:
  friend class JsonReader;

  struct Children {
    std::map<std::string, std::uint32_t, std::less<>> members;
    std::vector<std::uint32_t> items;
  };
  struct Value {
    Place place;
    std::unique_ptr<Children> children;  ///< null if there are none
  };
  /// Nesting may be as deep as the text is long, so that none owns another.
  std::vector<Value> values_;
  std::vector<Repeated> repeated_;
  std::size_t more_repeated_ = 0;
};

/// A JSON text, and where its values are.
struct PlacedJson {
  nlohmann::json value;
  JsonPlaces places;
};

/// Parses a text. The last of several members of a name counts. Raises SceneError, with line and
/// column; `name` stands in its message.
PlacedJson parse_placed_json(std::string_view text, const std::shared_ptr<const std::string>& name);

/// The part of a JSON pointer for a member: with ~ and / escaped.
std::string pointer_part(std::string_view name);

}  // namespace ajar::gltf
