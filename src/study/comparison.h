#pragma once
#include <optional>
#include <string>
#include <vector>

#include "study/bias.h"
#include "study/loaded_picture.h"
#include "study/metric.h"

/// Pictures against a reference, as `ajar compare` prints and reports show them.
namespace ajar::study {

struct ComparedPicture {
  LoadedPicture picture;
  std::vector<std::optional<double>> values;  ///< values of `Comparison::metrics`, in that order
  std::optional<BiasTest> bias;               ///< empty if the file does not know its error
};

struct Comparison {
  LoadedPicture reference;
  std::vector<const Metric*> metrics;
  MetricConditions conditions;
  std::vector<ComparedPicture> pictures;
  std::vector<std::string> warnings;  ///< one sentence each
};

/// Raises IoError for files that cannot be read, UsageError for pictures that cannot be compared:
/// of different sizes or different parts of the whole picture, or with pixels that are not finite
/// (they would decide every metric, and leaving them out would flatter the picture).
Comparison compare_files(const std::string& reference, const std::vector<std::string>& pictures,
                         const std::vector<const Metric*>& metrics, double pixels_per_degree);

}  // namespace ajar::study
