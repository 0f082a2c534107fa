#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vector.h"
#include "session/job/job_state.h"
#include "session/options/display.h"
#include "session/options/limits.h"

/// Values of command-line options. Each function raises UsageError that names the option and shows
/// how to write it.
namespace ajar {

/// `60`, `60s`, `2m`, `1.5h`, `1h30m` → seconds, within `limits::kSeconds`.
double parse_duration(const std::string& option, std::string_view text);

/// A whole number.
int parse_whole(const std::string& option, std::string_view text, const Limits<int>& limits);
std::uint64_t parse_whole(const std::string& option, std::string_view text,
                          const Limits<std::uint64_t>& limits);
/// A number; `what` says of what, such as "stops".
double parse_number(const std::string& option, std::string_view text, const std::string& what,
                    const Limits<double>& limits);
/// A number of stops, or `auto`.
Exposure parse_exposure(const std::string& option, std::string_view text);
/// `0.05` or `5%` → 0.05, above 0 and at most 1.
double parse_relative_error(const std::string& option, std::string_view text);
/// Target error; with "denoised:" it is that of the denoised picture.
struct TargetError {
  double value;
  bool is_denoised;
};
TargetError parse_target_error(const std::string& option, std::string_view text);

/// `640x480` → width and height, each 1…65536.
Vec2i parse_resolution(const std::string& option, std::string_view text);

/// `MIN:MAX`, `MIN:`, `:MAX` or `MAX`: path edges, 1 ≤ MIN ≤ MAX ≤ 1000; what is left out is empty.
struct DepthRange {
  std::optional<int> minimum;
  std::optional<int> maximum;
};
DepthRange parse_depth(const std::string& option, std::string_view text);

/// `x0,y0,x1,y1`, from the top left corner, x1 and y1 exclusive. Fractions of the picture if all
/// four numbers are at most 1, else whole pixels.
struct CropWindow {
  std::array<double, 4> values{};
  bool fractions = true;
};
CropWindow parse_crop(const std::string& option, std::string_view text);
/// Pixels of a picture of that resolution, max inclusive. A pixel belongs to a fractional window if
/// pbrt-v3 would give it to it: from ceil(resolution · min) to ceil(resolution · max) − 1. Raises
/// UsageError if none is inside.
Box2i crop_pixels(const std::string& option, const CropWindow& crop, Vec2i resolution);

inline constexpr std::uint64_t kMostShares = 1000000;
/// `K/N`: the K-th of N shares, 1 ≤ K ≤ N ≤ kMostShares.
WorkSlice parse_share(const std::string& option, std::string_view text);

/// `KEY=VALUE` pairs; a key that is given twice keeps the last value.
std::map<std::string, std::string> parse_assignments(const std::string& option,
                                                     const std::vector<std::string>& texts);

/// `a,b,c` → the names, without empty ones and repetitions.
std::vector<std::string> parse_list(std::string_view text);

}  // namespace ajar
