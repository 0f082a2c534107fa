#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/hdr_flip.h"
#include "study/loaded_picture.h"

namespace ajar::study {

/// Conditions of all metrics of a comparison.
struct MetricConditions {
  double pixels_per_degree = kFlipPixelsPerDegree;
  std::optional<ExposureRange> exposures;  ///< exposures of HDR-FLIP; empty for a black reference
};

/// The metric that `estimated_relative_error` is an estimate of.
inline const std::string kRelativeErrorMetric = "relative-error";

/// A distance between a picture and a reference of the same size.
struct Metric {
  std::string name;  ///< on the command line and in JSON
  std::string unit;  ///< "" if none
  bool larger_is_better = false;
  bool of_denoised = false;  ///< measures the layer "denoised", which pictures need not have
  std::string summary;       ///< one line: what it computes, of which values
  /// Empty where the metric has no value (see `summary`); infinite PSNR means equal pictures.
  std::function<std::optional<double>(const LoadedPicture& picture, const LoadedPicture& reference,
                                      const MetricConditions& conditions)>
      measure;
};

/// All metrics, in the order of tables.
const std::vector<Metric>& metrics();
/// Metrics by name, in the order of tables; all for an empty list. Raises UsageError that lists the
/// valid names and the nearest.
std::vector<const Metric*> metrics_by_name(const std::vector<std::string>& names);

}  // namespace ajar::study
