#include "apps/cli/render_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/cli/messages.h"
#include "imageio/image_file.h"
#include "session/job/progress.h"
#include "session/output/exposure_advice.h"

namespace ajar::cli {

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

std::string end_text(const RenderResult& result, double preparing,
                     const std::optional<double>& denoised_error) {
  std::string text = fmt::format(
      "{} sample{} per pixel in {}, {} rays/s", result.samples_per_pixel,
      result.samples_per_pixel == 1 ? "" : "s", clock_text(result.seconds),
      short_number(result.seconds > 0.0 ? static_cast<double>(result.counters.rays) / result.seconds
                                        : 0.0));
  // Less nobody has noticed.
  constexpr double kLeastSeconds = 0.05;
  if (preparing >= kLeastSeconds) text += fmt::format(", after {:.1f} s of preparing", preparing);
  if (!result.relative_error) {
    text += ", error unknown";
  } else {
    text += ", estimated error " + error_text(*result.relative_error);
    if (result.relative_error->has_fireflies) {
      text += fmt::format(" (fireflies: half of it is in {:.2g} % of the pixels)",
                          100.0 * result.relative_error->half_of_it);
    } else if (result.relative_error->misses_light) {
      text += " (without the light that this method cannot see)";
    }
  }
  if (denoised_error) {
    // Light that replicates have not found is missing there, too.
    RelativeError shown = result.relative_error.value_or(RelativeError());
    shown.value = *denoised_error;
    text += ", denoised " + error_text(shown);
  }
  if (result.stopped_by == StopReason::Interrupted) text += ", interrupted";
  return text;
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
