#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/warnings.h"

namespace ajar {

/// Warnings as a terminal shows them.
struct WarningDigest {
  /// One for each kind that can be seen in the picture, those with the most effect first.
  std::vector<std::string> lines;
  /// Number of warnings without visible effect, and where to see all one by one; empty if nothing
  /// is left to say.
  std::string note;
};

/// `most_lines`: where there are more kinds, those of an effect share a line, of the least effect
/// first, so that none is left out; at least as many as there are effects. `where_all`: command
/// that lists them all, one by one; may be empty.
WarningDigest digest(const Warnings& warnings, std::size_t most_lines,
                     const std::string& where_all);

}  // namespace ajar
