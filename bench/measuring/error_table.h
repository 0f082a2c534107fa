#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "measuring/reference.h"

namespace ajar::bench {

/// One render of one variant with one seed. Errors are relMSE without the reference's noise floor,
/// scaled to the time that was asked for.
struct Measurement {
  std::uint64_t samples = 0;  ///< per pixel
  double cpu_seconds = 0.0;   ///< really used
  double plain = 0.0;
  double trimmed = 0.0;  ///< without the worst 0.1 % of pixels
};

/// Compares a picture that took `cpu_seconds` with a reference. Variance is inverse to time, so the
/// error at `wanted_seconds` is the error times cpu_seconds / wanted_seconds.
Measurement measure(std::span<const float> picture, std::uint64_t samples, double cpu_seconds,
                    const Reference& reference, double wanted_seconds);

struct VariantMeasurements {
  std::string variant;
  std::vector<Measurement> runs;  ///< run i of every variant has the same seed
};

/// Markdown: a line per variant with the means over its runs; the ratio of trimmed errors to the
/// first variant has in brackets its range over seeds. Variants without runs are left out.
std::string error_table(std::span<const VariantMeasurements> variants, double wanted_seconds);

}  // namespace ajar::bench
