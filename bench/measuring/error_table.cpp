#include "measuring/error_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "image/metrics.h"

namespace ajar::bench {

namespace {

double mean(const std::vector<Measurement>& runs, auto value) {
  double sum = 0.0;
  for (const Measurement& run : runs) sum += static_cast<double>(value(run));
  return sum / static_cast<double>(runs.size());
}

double trimmed(const Measurement& run) { return run.trimmed; }

std::string ratio_text(const std::vector<Measurement>& runs,
                       const std::vector<Measurement>& first) {
  const double base = mean(first, trimmed);
  if (!(base > 0.0)) return "–";
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(runs.size(), first.size()); ++i) {
    if (first[i].trimmed > 0.0) ratios.push_back(runs[i].trimmed / first[i].trimmed);
  }
  std::string text = fmt::format("{:.3g}", mean(runs, trimmed) / base);
  if (ratios.size() > 1) {
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    text += fmt::format(" ({:.3g}–{:.3g})", *least, *most);
  }
  return text;
}

}  // namespace

Measurement measure(std::span<const float> picture, std::uint64_t samples, double cpu_seconds,
                    const Reference& reference, double wanted_seconds) {
  const double scale = cpu_seconds / wanted_seconds;
  return {samples, cpu_seconds,
          scale * (relative_mse(picture, reference.picture) - reference.floor.plain),
          scale * (relative_mse_trimmed(picture, reference.picture) - reference.floor.trimmed)};
}

std::string error_table(std::span<const VariantMeasurements> variants, double wanted_seconds) {
  std::string text = fmt::format(
      "| variant | samples per pixel | CPU-seconds | relMSE trimmed @{0:g} s | relMSE @{0:g} s | "
      "ratio to the first |\n|---|---|---|---|---|---|\n",
      wanted_seconds);
  for (const VariantMeasurements& variant : variants) {
    if (variant.runs.empty()) continue;
    text += fmt::format("| {} | {:.0f} | {:.1f} | {:.3g} | {:.3g} | {} |\n", variant.variant,
                        mean(variant.runs, [](const Measurement& run) { return run.samples; }),
                        mean(variant.runs, [](const Measurement& run) { return run.cpu_seconds; }),
                        mean(variant.runs, trimmed),
                        mean(variant.runs, [](const Measurement& run) { return run.plain; }),
                        ratio_text(variant.runs, variants.front().runs));
  }
  return text;
}

}  // namespace ajar::bench
