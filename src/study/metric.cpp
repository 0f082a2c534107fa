#include "study/metric.h"

#include <algorithm>

#include "core/error.h"
#include "image/flip.h"
#include "image/metrics.h"
#include "image/relative_error.h"
#include "image/ssim.h"
#include "image/tone_curve.h"

namespace ajar::study {

namespace {
using Measure = decltype(Metric::measure);
using LinearMetric = double (*)(std::span<const float>, std::span<const float>);

Measure of_linear(LinearMetric metric) {
  return [metric](const LoadedPicture& a, const LoadedPicture& r, const MetricConditions&) {
    return std::optional(metric(a.linear, r.linear));
  };
}

double trimmed(std::span<const float> image, std::span<const float> reference) {
  return relative_mse_trimmed(image, reference);
}

std::optional<double> measure_quantile(const LoadedPicture& a, const LoadedPicture& r,
                                       const MetricConditions&) {
  return relative_mse_quantile(a.linear, r.linear);
}

Measure at_scale(double sigma) {
  return [sigma](const LoadedPicture& a, const LoadedPicture& r, const MetricConditions&) {
    return std::optional(relative_mse_at_scale(a.linear, r.linear, r.size, sigma));
  };
}

/// Measures the denoised layer.
Measure of_denoised(LinearMetric metric) {
  return [metric](const LoadedPicture& a, const LoadedPicture& r,
                  const MetricConditions&) -> std::optional<double> {
    if (a.denoised.empty()) return std::nullopt;
    return metric(a.denoised, r.linear);
  };
}

std::optional<double> measure_denoised_flip(const LoadedPicture& a, const LoadedPicture& r,
                                            const MetricConditions& conditions) {
  if (a.denoised.empty()) return std::nullopt;
  return map_mean(flip_map(to_ldr(a.denoised), r.display, r.size, conditions.pixels_per_degree));
}

std::optional<double> measure_psnr(const LoadedPicture& a, const LoadedPicture& r,
                                   const MetricConditions&) {
  return psnr(a.display, r.display);
}

std::optional<double> measure_ssim(const LoadedPicture& a, const LoadedPicture& r,
                                   const MetricConditions&) {
  return ssim(a.display, r.display, r.size);
}

std::optional<double> measure_flip(const LoadedPicture& a, const LoadedPicture& r,
                                   const MetricConditions& conditions) {
  return map_mean(flip_map(a.display, r.display, r.size, conditions.pixels_per_degree));
}

std::optional<double> measure_hdr_flip(const LoadedPicture& a, const LoadedPicture& r,
                                       const MetricConditions& conditions) {
  if (!conditions.exposures) return std::nullopt;
  return map_mean(hdr_flip_map(a.linear, r.linear, r.size, *conditions.exposures,
                               conditions.pixels_per_degree));
}

std::optional<double> measure_relative_error(const LoadedPicture& a, const LoadedPicture& r,
                                             const MetricConditions&) {
  return relative_error(a.linear, r.linear);
}
}  // namespace

const std::vector<Metric>& metrics() {
  static const std::vector<Metric> list{
      {"mse", "radiance^2", false, false, "mean of (a - r)^2", of_linear(mse)},
      {"rmse", "radiance", false, false, "square root of mse", of_linear(rmse)},
      {"mae", "radiance", false, false, "mean of |a - r|", of_linear(mae)},
      {"relmse", "", false, false, "mean of (a - r)^2 / (r^2 + 0.01)", of_linear(relative_mse)},
      {"relmse-trimmed", "", false, false, "relmse without the 0.1 % of the pixels that are worst",
       of_linear(trimmed)},
      {"relmse-p999", "", false, false, "what the relmse of 99.9 % of the pixels does not exceed",
       measure_quantile},
      {"e1", "", false, false, "relmse of both pictures after a Gaussian of 1 pixel",
       at_scale(1.0)},
      {"e2", "", false, false, "relmse after 2 pixels", at_scale(2.0)},
      {"e4", "", false, false, "relmse after 4 pixels, about what a filter cannot remove",
       at_scale(4.0)},
      {"e8", "", false, false, "relmse after 8 pixels", at_scale(8.0)},
      {"smape", "", false, false, "mean of |a - r| / (|a| + |r| + 0.01)", of_linear(smape)},
      {"psnr", "dB", true, false, "-10 log10 of the mse of display values; inf if they are equal",
       measure_psnr},
      {"ssim", "", true, false,
       "structural similarity of display values (Wang 2004: 11x11 Gaussian windows, sigma 1.5); "
       "none below 11x11 pixels",
       measure_ssim},
      {"flip", "", false, false, "mean FLIP of display values (Andersson 2020)", measure_flip},
      {"hdr-flip", "", false, false,
       "mean HDR-FLIP (Andersson 2021) over exposures chosen from the reference; none if that is "
       "black",
       measure_hdr_flip},
      {"denoised-relmse", "", false, true,
       "relmse of the layer \"denoised\"; as those below, none if there is no such layer",
       of_denoised(relative_mse)},
      {"denoised-relmse-trimmed", "", false, true, "relmse-trimmed of that layer",
       of_denoised(trimmed)},
      {"denoised-flip", "", false, true, "flip of that layer", measure_denoised_flip},
      {kRelativeErrorMetric, "", false, false,
       "square root of the relmse of pictures exposed so that the reference's median is 1, which "
       "is "
       "what renders estimate; none if the reference is black",
       measure_relative_error},
  };
  return list;
}

std::vector<const Metric*> metrics_by_name(const std::vector<std::string>& names) {
  std::vector<std::string> valid;
  for (const Metric& metric : metrics()) valid.push_back(metric.name);
  for (const std::string& name : names) {
    if (std::find(valid.begin(), valid.end(), name) == valid.end()) {
      throw UsageError(unknown_name_message("metric", name, valid));
    }
  }
  std::vector<const Metric*> chosen;
  for (const Metric& metric : metrics()) {
    const bool named = std::find(names.begin(), names.end(), metric.name) != names.end();
    if (names.empty() || named) chosen.push_back(&metric);
  }
  return chosen;
}

}  // namespace ajar::study
