#include "study/comparison_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/number_text.h"
#include "core/printable_text.h"
#include "image/metrics.h"

namespace ajar::study {

namespace {
using Json = nlohmann::ordered_json;

Json number_or_null(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

/// Description of a metric in a line.
std::string about(const Metric& metric) {
  return metric.summary + (metric.unit.empty() ? "" : " [" + metric.unit + "]") +
         (metric.larger_is_better ? "; larger is better" : "");
}

/// A line for each metric, a column for each picture: there are more metrics than pictures.
std::string table(const Comparison& comparison) {
  std::vector<std::vector<std::string>> rows{{"metric"}};
  for (const ComparedPicture& compared : comparison.pictures) {
    rows.front().push_back(compared.picture.path);
  }
  for (std::size_t i = 0; i < comparison.metrics.size(); ++i) {
    rows.push_back({comparison.metrics[i]->name});
    for (const ComparedPicture& compared : comparison.pictures) {
      rows.back().push_back(value_text(compared.values[i]));
    }
  }
  const std::string values = aligned_table(rows);
  std::size_t begin = values.find('\n') + 1;
  std::string text = values.substr(0, begin);
  for (const Metric* metric : comparison.metrics) {
    const std::size_t end = values.find('\n', begin);
    text += values.substr(begin, end - begin) + "  " + about(*metric) + "\n";
    begin = end + 1;
  }
  return text;
}

bool measures(const Comparison& comparison, const std::string& name) {
  return std::any_of(comparison.metrics.begin(), comparison.metrics.end(),
                     [&](const Metric* metric) { return metric->name == name; });
}

std::string bias_text(const ComparedPicture& compared) {
  if (!compared.bias) {
    return fmt::format(
        "{}: not tested for bias: the file says nothing of its error (render with --aov "
        "replicates or --aov standard-error)\n",
        printable_line(compared.picture.path));
  }
  const BiasTest& bias = *compared.bias;
  const BlockComparison& r = bias.result;
  std::string text = fmt::format(
      "{}: {}\n  mean {:+.3g} % ± {:.3g} % (z {:+.2f}); worst of {} tests of {}x{} blocks and "
      "channels: z {:+.2f} at {},{}–{},{} in {} (family p {:.2g})\n",
      printable_line(compared.picture.path),
      bias.differs ? "differs from the reference by more than noise" : "no bias found",
      100 * r.mean_relative_difference,
      100 * std::abs(r.mean_error * r.mean_relative_difference / r.mean_difference), r.mean_z,
      r.tests, BiasTest::kBlock, BiasTest::kBlock, r.worst_z, r.worst_block.min.x,
      r.worst_block.min.y, r.worst_block.max.x, r.worst_block.max.y, "RGB"[r.worst_channel],
      r.family_p);
  text += fmt::format(
      "  power: a difference of {} of the mean, or of {} of it in a typical block, "
      "would be found in {:.0f} % of cases (level {:g})\n",
      percent_text(bias.detectable_mean), percent_text(bias.detectable_block),
      100 * BiasTest::kPower, BiasTest::kLevel);
  text += fmt::format(
      "  errors: picture from {}, reference {}{}\n", to_string(bias.picture),
      bias.reference == ErrorSource::None ? "taken as exact"
                                          : fmt::format("from {}", to_string(bias.reference)),
      bias.picture == ErrorSource::StandardError || bias.reference == ErrorSource::StandardError
          ? "; pixels taken as independent, which those of chains and of splats "
            "are not"
          : "");
  return text;
}

Json bias_json(const BiasTest& bias) {
  const BlockComparison& r = bias.result;
  const Box2i& block = r.worst_block;
  return {{"differs", bias.differs},
          {"level", BiasTest::kLevel},
          {"picture_error", to_string(bias.picture)},
          {"reference_error", to_string(bias.reference)},
          {"mean",
           {{"difference", number_or_null(r.mean_difference)},
            {"standard_error", number_or_null(r.mean_error)},
            {"relative_difference", number_or_null(r.mean_relative_difference)},
            {"z", number_or_null(r.mean_z)}}},
          {"blocks",
           {{"pixels", BiasTest::kBlock},
            {"tests", r.tests},
            {"worst_z", number_or_null(r.worst_z)},
            {"worst_p", r.worst_p},
            {"family_p", r.family_p},
            {"worst_block", {block.min.x, block.min.y, block.max.x + 1, block.max.y + 1}},
            {"worst_channel", std::string(1, "RGB"[r.worst_channel])}}},
          {"power",
           {{"probability", BiasTest::kPower},
            {"detectable_mean", number_or_null(bias.detectable_mean)},
            {"detectable_block", number_or_null(bias.detectable_block)}}}};
}

Json conditions_json(const Comparison& comparison) {
  Json json{{"relmse_epsilon", kRelativeMseEpsilon},
            {"smape_epsilon", kSmapeEpsilon},
            {"trimmed", 0.001},
            {"pixels_per_degree", comparison.conditions.pixels_per_degree},
            {"exposures", nullptr}};
  if (const auto& exposures = comparison.conditions.exposures) {
    json["exposures"] = {
        {"start", exposures->start}, {"stop", exposures->stop}, {"count", exposures->count}};
  }
  return json;
}
}  // namespace

std::string conditions_text(const Comparison& comparison) {
  std::string text =
      "a: picture, r: reference; scene-linear RGB, or display values (exposure 0, sRGB, clamped to "
      "0…1) where said\n";
  if (measures(comparison, "flip") || measures(comparison, "hdr-flip")) {
    text += fmt::format("FLIP is seen at {:.2f} pixels per degree\n",
                        comparison.conditions.pixels_per_degree);
  }
  if (measures(comparison, "hdr-flip") && comparison.conditions.exposures) {
    const ExposureRange& exposures = *comparison.conditions.exposures;
    text += fmt::format("HDR-FLIP uses {} exposures from {:+.3f} to {:+.3f} stops (ACES)\n",
                        exposures.count, exposures.start, exposures.stop);
  }
  return text;
}

std::string aligned_table(std::vector<std::vector<std::string>> rows) {
  std::vector<std::size_t> widths;
  for (auto& row : rows) {
    for (std::string& cell : row) cell = printable_line(cell);
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += i == 0 ? fmt::format("{:<{}}", row[i], widths[i])
                     : fmt::format("  {:>{}}", row[i], widths[i]);
    }
    text += "\n";
  }
  return text;
}

std::string value_text(std::optional<double> value) {
  return value ? fmt::format("{:.4g}", *value) : "-";
}

std::string to_text(const Comparison& comparison) {
  std::string text =
      fmt::format("reference: {} ({}x{})\n\n", printable_line(comparison.reference.path),
                  comparison.reference.size.x, comparison.reference.size.y);
  text += table(comparison) + "\n" + conditions_text(comparison) + "\n";
  for (const ComparedPicture& compared : comparison.pictures) text += bias_text(compared);
  return text;
}

Json to_json(const Comparison& comparison) {
  Json pictures = Json::array();
  for (const ComparedPicture& compared : comparison.pictures) {
    Json values = Json::object();
    for (std::size_t i = 0; i < comparison.metrics.size(); ++i) {
      values[comparison.metrics[i]->name] = number_or_null(compared.values[i]);
    }
    pictures.push_back({{"picture", valid_utf8(compared.picture.path)},
                        {"metrics", values},
                        {"bias", compared.bias ? bias_json(*compared.bias) : Json()}});
  }
  const Vec2i size = comparison.reference.size;
  std::vector<std::string> warnings;
  for (const std::string& warning : comparison.warnings) warnings.push_back(valid_utf8(warning));
  return {{"reference", valid_utf8(comparison.reference.path)},
          {"resolution", {size.x, size.y}},
          {"conditions", conditions_json(comparison)},
          {"pictures", pictures},
          {"warnings", warnings}};
}

}  // namespace ajar::study
