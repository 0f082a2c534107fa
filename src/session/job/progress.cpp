#include "session/job/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/number_text.h"
#include "session/heuristics.h"

namespace ajar {

namespace {

double samples_per_second(const RenderSnapshot& s) {
  return s.seconds > 0.0 ? s.samples_done / s.seconds : 0.0;
}

double rays_per_second(const RenderSnapshot& s) {
  return s.seconds > 0.0 ? static_cast<double>(s.rays) / s.seconds : 0.0;
}

/// Seconds the whole render will have taken when `limit` (a part of the budget) is reached.
std::vector<double> expected_totals(const RenderSnapshot& s) {
  std::vector<double> totals;
  if (s.budget.seconds) totals.push_back(*s.budget.seconds);
  const double rate = samples_per_second(s);
  if (rate <= 0.0) return totals;
  if (s.total_samples > 0) totals.push_back(static_cast<double>(s.total_samples) / rate);
  std::optional<double> error = s.denoised_error;
  if (!s.budget.denoised_target && s.relative_error && !s.relative_error->is_lower_bound()) {
    error = s.relative_error->value;
  }
  if (s.budget.target_error && error && *s.budget.target_error > 0.0) {
    const double ratio = *error / *s.budget.target_error;
    totals.push_back(static_cast<double>(s.error_samples) * ratio * ratio / rate);
  }
  return totals;
}

std::string samples_text(const RenderSnapshot& s) {
  if (s.phase == RenderPhase::Prepare) return "preparing";
  if (s.phase == RenderPhase::Denoise) return "denoising";
  const auto done = static_cast<std::uint64_t>(s.samples_done);
  return s.total_samples > 0 ? fmt::format("{}/{} spp", done, s.total_samples)
                             : fmt::format("{} spp", done);
}

std::string text_of_error(const RenderSnapshot& s) {
  if (!s.renders() || !s.relative_error) return {};
  const std::string text = "error " + error_text(*s.relative_error);
  return s.denoised_error ? text + ", denoised " + error_text({.value = *s.denoised_error}) : text;
}

std::string left_text(const RenderSnapshot& s) {
  const std::optional<double> left = seconds_left(s);
  // A pass may take longer than what was left, and an error is held against its target at
  // milestones alone; nobody should wait for "0:00".
  RenderSnapshot without_target = s;
  without_target.budget.target_error.reset();
  const std::optional<double> left_at_most = seconds_left(without_target);
  if (s.finishing || (left_at_most && *left_at_most < 0.5)) return "finishing the pass";
  if (left && *left < 0.5) return "checking the error";
  return left ? clock_text(*left) + " left" : std::string();
}

std::string rays_text(const RenderSnapshot& s) {
  return !s.renders() ? std::string() : short_number(rays_per_second(s)) + " rays/s";
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
  std::string text;
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    if (!text.empty()) text += separator;
    text += part;
  }
  return text;
}

nlohmann::ordered_json optional_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

std::optional<double> seconds_left(const RenderSnapshot& snapshot) {
  if (!snapshot.renders()) {
    const double done = snapshot.phase_done;
    if (done < SessionHeuristics::kLeastDone) return std::nullopt;
    return snapshot.seconds * (1.0 - done) / done;
  }
  const std::vector<double> totals = expected_totals(snapshot);
  if (totals.empty()) return std::nullopt;
  return std::max(0.0, *std::min_element(totals.begin(), totals.end()) - snapshot.seconds);
}

std::optional<double> fraction_done(const RenderSnapshot& snapshot) {
  const std::optional<double> left = seconds_left(snapshot);
  if (!left) return std::nullopt;
  const double total = snapshot.seconds + *left;
  return total > 0.0 ? snapshot.seconds / total : 1.0;
}

std::string clock_text(double seconds) {
  const auto whole = std::llround(std::clamp(seconds, 0.0, 1e12));
  const long long hours = whole / 3600;
  const long long minutes = whole / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                   : fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string short_number(double value) {
  const std::pair<double, const char*> units[] = {
      {1e12, " T"}, {1e9, " G"}, {1e6, " M"}, {1e3, " k"}};
  for (const auto& [size, name] : units) {
    if (value >= size) return fmt::format("{:.3g}{}", value / size, name);
  }
  return fmt::format("{:.3g}", value);
}

std::string error_text(const RelativeError& error) {
  return (error.is_lower_bound() ? "≥ " : "") + percent_text(error.value);
}

std::string bar_line(const RenderSnapshot& snapshot, int columns) {
  const std::optional<double> fraction = fraction_done(snapshot);
  const std::string percent =
      fraction ? fmt::format("{:3.0f} %", std::floor(100.0 * *fraction)) : std::string();
  const std::string numbers =
      joined({percent, samples_text(snapshot), rays_text(snapshot), text_of_error(snapshot),
              clock_text(snapshot.seconds), left_text(snapshot)},
             " · ");
  // "·" and "≥" are one column, but several bytes, of which all but the first begin with 10.
  const auto width = static_cast<int>(std::count_if(
      numbers.begin(), numbers.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80U; }));
  const int room = columns - width - 4;
  if (!fraction || room < 8) {
    return width < columns ? numbers
                           : joined({percent, samples_text(snapshot)}, " ")
                                 .substr(0, static_cast<std::size_t>(std::max(0, columns)));
  }
  const int length = std::min(room, 40);
  const int filled = std::clamp(static_cast<int>(*fraction * length), 0, length);
  return fmt::format("[{}{}]  {}", std::string(static_cast<std::size_t>(filled), '#'),
                     std::string(static_cast<std::size_t>(length - filled), '-'), numbers);
}

std::string plain_line(const RenderSnapshot& snapshot) {
  return joined({clock_text(snapshot.seconds), samples_text(snapshot), rays_text(snapshot),
                 text_of_error(snapshot), left_text(snapshot)},
                ", ");
}

std::string json_line(const RenderSnapshot& snapshot, const std::string& event) {
  nlohmann::ordered_json line;
  line["event"] = event;
  line["phase"] = to_string(snapshot.phase);
  line["seconds"] = snapshot.seconds;
  line["samples_per_pixel"] = snapshot.samples_done;
  line["total_samples_per_pixel"] = snapshot.total_samples > 0
                                        ? nlohmann::ordered_json(snapshot.total_samples)
                                        : nlohmann::ordered_json();
  line["rays"] = snapshot.rays;
  line["rays_per_second"] = rays_per_second(snapshot);
  const std::optional<RelativeError>& error = snapshot.relative_error;
  line["estimated_relative_error"] =
      optional_json(error ? std::optional(error->value) : std::nullopt);
  line["estimated_error_is_lower_bound"] = !error || error->is_lower_bound();
  line["fraction"] = optional_json(fraction_done(snapshot));
  line["seconds_left"] = optional_json(seconds_left(snapshot));
  line["finishing"] = snapshot.finishing;
  return line.dump();
}

}  // namespace ajar
