#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/vector.h"
#include "core/warnings.h"
#include "import/pbrt/dialect.h"

namespace ajar::pbrt {

class ColorSpace;

enum class ParameterKind {
  Integer,
  Float,
  Point2,
  Vector2,
  Point3,
  Vector3,
  Normal3,
  Bool,
  String,
  Texture,
  Rgb,
  Xyz,
  Blackbody,
  Spectrum
};
std::string_view kind_name(ParameterKind kind);
std::optional<ParameterKind> kind_from_name(std::string_view name);
/// Numbers per value: 3 for points, 2 for black bodies (temperature, scale; pbrt-v4 has no scale) …
int numbers_per_value(ParameterKind kind, Dialect dialect);

/// `"float fov" [ 30 ]`: a typed, named array.
struct Parameter {
  ParameterKind kind = ParameterKind::Float;
  std::string name;
  SourceLocation where;
  std::vector<int> integers;   ///< values of Integer
  std::vector<float> numbers;  ///< values of all other numeric types
  std::vector<std::string>
      strings;  ///< values of String, Texture, Bool ("true", "false"), and file names of Spectrum
  /// Colour space of Rgb: the one current where it was written; null for linear Rec. 709 (pbrt-v3).
  const ColorSpace* color_space = nullptr;
  Dialect dialect = Dialect::V3;
  std::size_t size() const;  ///< count of values
};

/// Shared, because one may belong to many directives and be large.
using ParameterPointer = std::shared_ptr<const Parameter>;

/// A parameter that an `Attribute` directive gives those after it, and its use.
struct AttributeParameter {
  ParameterPointer parameter;
  bool was_offered = false;
  bool was_used = false;
  std::vector<std::string> asked;  ///< names requested by the first directive that did not use it
};
using AttributePointer = std::shared_ptr<AttributeParameter>;
/// Warns of those that were offered, and that no directive ever asked for.
void report_unused(std::span<const AttributePointer> attributes, Warnings& warnings);

/// The parameters of one directive. Every lookup remembers its name: unused ones are reported by
/// `report_unused`, with the nearest name that was looked up.
class ParameterList {
 public:
  void add(Parameter parameter, Warnings& warnings);
  /// Parameters that `Attribute` directives have set: they count where this list has none of their
  /// name, and may stay unused.
  void add_defaults(std::span<const AttributePointer> defaults, Warnings& warnings);
  std::vector<ParameterPointer> parameters() const;

  /// The parameter, if it was given with one of these kinds. A different kind is a warning and
  /// counts as not given, as in pbrt-v3.
  const Parameter* find(std::string_view name, std::span<const ParameterKind> kinds) const;
  const Parameter* find(std::string_view name, ParameterKind kind) const {
    return find(name, {&kind, 1});
  }
  /// Parameters that must have exactly one value.
  const Parameter* find_one(std::string_view name, std::span<const ParameterKind> kinds) const;
  const Parameter* find_one(std::string_view name, ParameterKind kind) const {
    return find_one(name, {&kind, 1});
  }

  bool get_bool(std::string_view name, bool fallback) const;
  std::optional<bool> get_bool(std::string_view name) const;
  int get_int(std::string_view name, int fallback) const;
  std::optional<int> get_int(std::string_view name) const;
  float get_float(std::string_view name, float fallback) const;
  std::optional<float> get_float(std::string_view name) const;
  std::string get_string(std::string_view name, const std::string& fallback) const;
  std::optional<std::string> get_string(std::string_view name) const;
  std::vector<std::string> get_strings(std::string_view name) const;
  Vec3 get_point(std::string_view name, const Vec3& fallback) const;
  std::optional<Vec3> get_point(std::string_view name) const;
  std::optional<Vec3> get_vector(std::string_view name) const;
  std::vector<Vec3> get_points(std::string_view name) const;
  std::vector<Vec3> get_vectors(std::string_view name) const;
  std::vector<Vec3> get_normals(std::string_view name) const;
  /// Accepts point2, vector2 and plain floats, as exporters write all of them.
  std::vector<Vec2> get_point2s(std::string_view name) const;

  /// Marks parameters that are known and have no meaning for us.
  void accept(std::initializer_list<std::string_view> names) const;
  /// Count of parameters that were found so far.
  std::size_t used_count() const;
  bool all_used() const { return used_count() == entries_.size(); }
  void report_unused(Warnings& warnings) const;
  bool empty() const { return entries_.empty(); }
  /// True if any has the prefix of our own words (own_words.h). Ineffective ones of pbrt's are for
  /// pbrt alone then, and not reported as unused.
  bool has_own_words() const;

 private:
  struct Entry {
    ParameterPointer parameter;
    AttributePointer attribute = nullptr;  ///< attribute that it comes from
    mutable bool used = false;
    void use() const;
  };
  std::vector<Vec3> get_triples(std::string_view name, ParameterKind kind) const;

  std::vector<Entry> entries_;
  mutable std::vector<std::string> asked_;
  Warnings* warnings_ = nullptr;
};

}  // namespace ajar::pbrt
