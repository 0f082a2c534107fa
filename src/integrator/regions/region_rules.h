#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

/// The user's assignment of regions to methods (Frolov's "manual fill"), by the names of objects
/// and materials:
///
///     # the lamps are hard, the walls are not
///     object   lamp*         chain
///     material "white paint" omc
///     object   vase          0.3
///     object   vase-foot     auto
///
/// One rule per line; of the rules that match a region, the last one holds. `*` stands for any
/// characters, none included; names with spaces are quoted; `#` begins a comment wherever a word
/// could begin.
namespace ajar {

struct RegionRule {
  enum class Subject { Object, Material };
  enum class Choice {
    Auto,   ///< decided by measurement
    Omc,    ///< ordinary Monte Carlo: σ = ε
    Chain,  ///< Markov chains: σ = 1
    Weight  ///< σ = weight
  };
  Subject subject = Subject::Object;
  std::string pattern;
  Choice choice = Choice::Auto;
  float weight = 0.F;    ///< in [0, 1], for `Choice::Weight`
  SourceLocation where;  ///< place of the pattern
};

/// The rules of a text; `file` is what error messages call it. Raises SceneError with the place of
/// the first word that is wrong, what is allowed there and what may have been meant.
std::vector<RegionRule> parse_region_rules(std::string_view text, const std::string& file);

/// Raises SceneError for the first rule whose pattern matches none of the names, with the nearest.
void check_region_rules(std::span<const RegionRule> rules, std::span<const std::string> objects,
                        std::span<const std::string> materials);

/// True if `*` in `pattern` can be filled in such that it equals `name`.
bool matches_pattern(std::string_view pattern, std::string_view name);

/// The rule that holds for a region; null if none does, which is the same as `Choice::Auto`.
const RegionRule* find_region_rule(std::span<const RegionRule> rules, std::string_view object,
                                   std::string_view material);

/// σ that a rule sets; empty if it leaves it to what is measured.
std::optional<float> fixed_weight(const RegionRule& rule, float epsilon);

}  // namespace ajar
