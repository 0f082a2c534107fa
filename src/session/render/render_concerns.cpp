#include "session/render/render_concerns.h"

#include <fmt/format.h>

#include "scene/coordinate_limit.h"

namespace ajar {

namespace {

constexpr WarningKind kRaysOutOfRange{Effect::Slight, "renders have lost rays"};
constexpr WarningKind kDropped{Effect::Slight, "renders have dropped contributions"};
constexpr WarningKind kCutShort{Effect::Slight, "renders were cut short"};

}  // namespace

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

}  // namespace ajar
