#pragma once
#include <string>
#include <string_view>

#include "scene/desc/node.h"

/// Ajar's own words in files of pbrt-v3. Models and parameters unknown to pbrt have their names
/// here. Where pbrt has only an approximate equivalent, its word has the nearest value, for pbrt,
/// and ours, with a prefix, the exact one, which counts.
namespace ajar::pbrt {

inline constexpr std::string_view kOwnPrefix = "ajar:";
inline std::string own_word(std::string_view parameter) {
  return std::string(kOwnPrefix) + std::string(parameter);
}
inline bool has_own_prefix(std::string_view word) { return word.starts_with(kOwnPrefix); }

/// A model that pbrt does not have goes by one that looks like it, and this says which it is. All
/// of its parameters are words with the prefix then.
inline constexpr std::string_view kOwnModel = "ajar:model";

/// True if pbrt-v3 has nothing of this name, for a model that it has; for parameters that the
/// tables of names do not translate.
bool is_unknown_to_v3(const desc::Model& model, std::string_view parameter);

}  // namespace ajar::pbrt
