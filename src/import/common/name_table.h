#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

/// A file format's names of our models and their parameters. A format has one table for each kind
/// of models, from which its importer and its writer, if it has one, are driven.
namespace ajar {

/// A parameter that a format calls otherwise, or gives another default.
struct ParameterName {
  std::string_view ours;
  /// In the order in which they are looked for; the first is written. None: the format cannot say
  /// it.
  std::vector<std::string_view> theirs;
  /// The format's default, if it is not ours.
  std::string_view fallback = {};
  /// Values for false and true if ours is a choice and theirs a flag.
  std::array<std::string_view, 2> words = {};
  /// Fallback of a parameter that may be left out, where the format has a default: another of ours,
  /// of which the value is written then.
  std::string_view if_absent = {};
};

/// A model of ours that the format has, too. Parameters that are not listed have the same name in
/// both.
struct ModelName {
  std::string_view theirs;
  std::string_view ours;
  std::vector<ParameterName> parameters;

  const ParameterName* find(std::string_view parameter_of_ours) const {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(),
                     [&](const ParameterName& name) { return name.ours == parameter_of_ours; });
    return found == parameters.end() ? nullptr : &*found;
  }
};

/// Null if the format has no model of this name; then one of ours may go by its own.
inline const ModelName* find_theirs(std::span<const ModelName> table, std::string_view theirs) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const ModelName& name) { return name.theirs == theirs; });
  return found == table.end() ? nullptr : &*found;
}
/// Null if the format has no name for our model.
inline const ModelName* find_ours(std::span<const ModelName> table, std::string_view ours) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const ModelName& name) { return name.ours == ours; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace ajar
