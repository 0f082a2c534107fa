#include "apps/cli/render_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/cli/messages.h"
#include "core/error.h"
#include "scene/coordinate_limit.h"
#include "session/exposure_advice.h"
#include "session/progress.h"

namespace ajar::cli {

namespace {

constexpr WarningKind kRaysOutOfRange{Effect::Slight, "renders have lost rays"};
constexpr WarningKind kDropped{Effect::Slight, "renders have dropped contributions"};
constexpr WarningKind kCutShort{Effect::Slight, "renders were cut short"};

}  // namespace

bool report_file(const WrittenFile& file) {
  if (file.error.empty()) return true;
  print_error(file.error);
  if (file.path.empty()) {
    print_error(file.what + " is lost: it could be written nowhere");
  } else {
    print_note(file.what + " is in " + file.path + " instead");
  }
  return false;
}

bool write_statistics(const RenderStatistics& statistics, const std::string& path) {
  if (path.empty()) return true;
  try {
    write_json(to_json(statistics), path);
    return true;
  } catch (const IoError& error) {
    print_error(error.what());
    return false;
  }
}

std::vector<Warning> concerns_about(const RenderResult& result) {
  const Counters& counters = result.counters;
  std::vector<Warning> concerns;
  if (counters.rays_out_of_range > 0) {
    concerns.push_back(
        {kRaysOutOfRange,
         {},
         fmt::format("{} of {} rays could not be traced, because their coordinates are not numbers "
                     "or too large ({:g} at most, less with small instances); what they would have "
                     "brought is missing",
                     counters.rays_out_of_range, counters.rays, kMaxRayCoordinate)});
  }
  const std::uint64_t dropped =
      counters.discarded_nan + counters.discarded_infinite + counters.discarded_negative;
  if (dropped > 0) {
    concerns.push_back(
        {kDropped,
         {},
         fmt::format("{} contributions were dropped ({} NaN, {} infinite, {} negative); the first: "
                     "{}",
                     dropped, counters.discarded_nan, counters.discarded_infinite,
                     counters.discarded_negative, counters.first_discarded)});
  }
  if (!result.complete) {
    concerns.push_back({kCutShort,
                        {},
                        "the last pass was cut short: parts of the picture have fewer samples than "
                        "others, or none"});
  }
  return concerns;
}

void report_end(const RenderResult& result, double preparing) {
  std::string text = fmt::format(
      "{} sample{} per pixel in {}, {} rays/s", result.samples_per_pixel,
      result.samples_per_pixel == 1 ? "" : "s", clock_text(result.seconds),
      short_number(result.seconds > 0.0 ? static_cast<double>(result.counters.rays) / result.seconds
                                        : 0.0));
  // Less nobody has noticed.
  constexpr double kLeastSeconds = 0.05;
  if (preparing >= kLeastSeconds) text += fmt::format(", after {:.1f} s of preparing", preparing);
  if (result.relative_error) {
    text += ", estimated error " + error_text(*result.relative_error);
    if (result.relative_error->has_fireflies) {
      text += fmt::format(" (fireflies: half of it is in {:.2g} % of the pixels)",
                          100.0 * result.relative_error->half_of_it);
    } else if (result.relative_error->misses_light) {
      text += " (without the light that this method cannot see)";
    }
  }
  if (result.stopped_by == StopReason::Interrupted) text += ", interrupted";
  print_note(text);
}

void report_exposure(const Picture& picture, const std::vector<std::string>& outputs,
                     const DisplayOptions& display, bool automatic) {
  if (std::none_of(outputs.begin(), outputs.end(), is_display_file)) return;
  if (automatic) {
    print_note("exposure " + stops_text(display.exposure) + " chosen for this picture");
    return;
  }
  const std::string advice = exposure_advice(picture, display);
  if (!advice.empty()) print_note(advice);
}

}  // namespace ajar::cli
