#pragma once
#include <optional>
#include <string>

#include "session/job/render_job.h"

namespace ajar {

/// Seconds until the first limit of the budget is reached, as far as can be told; an error falls
/// with the square root of the samples.
std::optional<double> seconds_left(const RenderSnapshot& snapshot);
/// Part of the render that is done, 0…1; empty without a limit.
std::optional<double> fraction_done(const RenderSnapshot& snapshot);

/// `0:05`, `12:03`, `1:02:03`.
std::string clock_text(double seconds);
/// Number with a unit prefix: `950`, `12.3 k`, `4.56 M`.
std::string short_number(double value);

/// `12 %`, or `≥ 12 %` of what is a lower bound.
std::string error_text(const RelativeError& error);

/// One line without line break, at most `columns` wide.
std::string bar_line(const RenderSnapshot& snapshot, int columns);
std::string plain_line(const RenderSnapshot& snapshot);
/// Keys: event ("progress" or "done"), phase ("prepare", "render" or "denoise"), seconds,
/// samples_per_pixel, total_samples_per_pixel, rays, rays_per_second, estimated_relative_error,
/// fraction, seconds_left, finishing; null where unknown.
std::string json_line(const RenderSnapshot& snapshot, const std::string& event);

}  // namespace ajar
