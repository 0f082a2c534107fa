#include "measuring/split_arguments.h"

#include <algorithm>

namespace ajar::bench {

SplitArguments split_arguments(const std::vector<std::string>& arguments) {
  const auto dashes = std::find(arguments.begin(), arguments.end(), "--");
  SplitArguments split{{arguments.begin(), dashes}, {}};
  if (dashes != arguments.end()) split.after.assign(dashes + 1, arguments.end());
  return split;
}

std::vector<std::string> default_variants() { return {"pt", "lt", "ibpt", "bdpt"}; }

}  // namespace ajar::bench
