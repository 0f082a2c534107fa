#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ajar/namespace.h"

namespace ajar::AJAR_INTERFACE {
/// Measures files of pictures against a reference, and gives what `ajar compare --json` prints.
/// `metrics`: names of docs/compare.md, all if empty; `pixels_per_degree`: of sight, for FLIP.
/// Raises Error.
std::string compare(const std::string& reference, const std::vector<std::string>& pictures,
                    const std::vector<std::string>& metrics = {},
                    std::optional<double> pixels_per_degree = {});
}  // namespace ajar::AJAR_INTERFACE
