#pragma once
#include <string>
#include <vector>

namespace ajar::bench {

/// Command lines of the benchmarks read `OPTIONS SCENE… -- VARIANT…`.
struct SplitArguments {
  std::vector<std::string> before;  ///< options and scenes
  std::vector<std::string> after;   ///< variants
};

/// Splits at the first `--`; without one nothing is after it.
SplitArguments split_arguments(const std::vector<std::string>& arguments);

/// Variants that are compared if none is named.
std::vector<std::string> default_variants();

}  // namespace ajar::bench
