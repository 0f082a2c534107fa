#pragma once
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

/// Types after `Choice` are only for the nodes of a scene (`scene/desc/node.h`).
enum class ParameterType {
  Bool,
  Int,
  Float,
  Text,
  Choice,
  Color,
  Vector,
  Point,
  Transform,
  File,
  Material,
  Mesh,
  Curves
};

/// Declaration of a parameter: of an integrator, which users can set with `--set name=value`, or of
/// a model that scenes are described with. `ajar list`, error messages and the manual are made from
/// it.
struct ParameterSpec {
  std::string name;
  ParameterType type;
  std::string default_value;
  std::string unit;                  ///< "" if none
  std::string help;                  ///< one line
  std::vector<std::string> choices;  ///< for Choice; for Float, words that may stand for a number
  double minimum = -1e300;
  double maximum = 1e300;
  bool expert = false;  ///< for experts; lists show it below the others
  /// For Float and Color in scenes: a texture may replace the value. Values of a texture are
  /// clamped to the range by the model that reads it; other values beyond it are errors.
  bool textured = false;
  /// If it matters only while another parameter, a Choice declared before it, has one of some
  /// values: the name of that parameter, and the values.
  std::string depends_on = {};
  std::vector<std::string> matters_for = {};
  /// True if this parameter has an effect while the other has this value.
  bool matters_with(const std::string& value) const;
  bool open_range = false;  ///< minimum and maximum themselves are not allowed
};

bool in_range(const ParameterSpec& spec, double value);

/// "between 0 and 64", "at least 0", "at most 1", or empty: the values that a spec allows.
std::string range_text(const ParameterSpec& spec);

/// A number from 0 on, without unit, or one of `words`.
ParameterSpec number_parameter(std::string name, std::string value, std::string help,
                               double maximum = 1e9, std::vector<std::string> words = {});
/// One of `choices`; the first is the default.
ParameterSpec choice_parameter(std::string name, std::vector<std::string> choices,
                               std::string help);

/// Marks all but those named in `basic` as for experts. Raises std::logic_error for a name that no
/// spec has.
void mark_experts(std::span<ParameterSpec> specs, std::initializer_list<std::string_view> basic);

/// Values for a list of specs; every declared parameter has a value, checked for type and range.
class Parameters {
 public:
  /// Raises UsageError for unknown names (nearest name suggested), bad values and values out of
  /// range.
  Parameters(std::span<const ParameterSpec> specs, const std::map<std::string, std::string>& given);
  bool get_bool(std::string_view name) const;
  int get_int(std::string_view name) const;
  double get_float(std::string_view name) const;
  /// Empty if a word stands in place of the number.
  std::optional<double> get_number(std::string_view name) const;
  const std::string& get_text(std::string_view name) const;
  const std::map<std::string, std::string, std::less<>>& values() const { return values_; }
  /// False for parameters that have no effect because of the value of another.
  bool matters(const ParameterSpec& spec) const {
    return spec.depends_on.empty() || spec.matters_with(get_text(spec.depends_on));
  }
  /// Parameters that were not left at their default.
  const std::map<std::string, std::string>& given() const { return given_; }

 private:
  std::map<std::string, std::string, std::less<>> values_;
  std::map<std::string, std::string> given_;
};

}  // namespace ajar
