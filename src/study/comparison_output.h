#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "study/comparison.h"

namespace ajar::study {

/// The table that `ajar compare` prints, the legend of its columns, and the tests for bias.
std::string to_text(const Comparison& comparison);

/// The comparison as one object, keys as in docs/compare.md. Missing values are null; so is
/// the infinite PSNR of equal pictures.
nlohmann::ordered_json to_json(const Comparison& comparison);

/// Legend of the columns and conditions of the metrics; lines that end in a newline.
std::string conditions_text(const Comparison& comparison);

/// Columns as wide as their longest cell, the first to the left, the others to the right, two
/// spaces between them. All rows have the same number of cells.
std::string aligned_table(std::vector<std::vector<std::string>> rows);

/// Four digits, "inf", or "-" without a value.
std::string value_text(std::optional<double> value);

}  // namespace ajar::study
