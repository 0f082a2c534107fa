#pragma once
#include <fmt/format.h>

#include <concepts>
#include <cstdint>
#include <string>

#include "core/error.h"
#include "post/exposure.h"

/// Limits of the numbers of a render, from any source: the command line, a study, a program
/// (include/ajar).
namespace ajar {

/// Numbers from `least` to `most`.
template <typename Number>
struct Limits {
  Number least;
  Number most;
  bool is_open_below = false;  ///< `least` itself is too small

  /// False for what is no number.
  constexpr bool contain(Number value) const {
    return value <= most && (is_open_below ? value > least : value >= least);
  }
  /// "from 1 to 1000".
  std::string text() const {
    return fmt::format("{} {} to {}", is_open_below ? "above" : "from", least, most);
  }
};

/// Pixels along one side of a picture, at most.
inline constexpr int kMaxResolution = 65536;

namespace limits {
inline constexpr Limits<int> kResolution{1, kMaxResolution};
inline constexpr Limits<int> kCropEdge{0, kMaxResolution};  ///< pixels
inline constexpr Limits<double> kScale{1e-5, 65536.0};      ///< factor of the scene's own
                                                            ///< resolution
/// Per pixel: their numbers have 32 bits.
inline constexpr Limits<std::uint64_t> kSamples{1, std::uint64_t{1} << 31U};
/// Thirty years are more than any clock here has to count to.
inline constexpr Limits<double> kSeconds{0.0, 1e9, true};
inline constexpr Limits<double> kRelativeError{0.0, 1.0, true};
inline constexpr Limits<int> kDepth{1, 1000};  ///< edges of a path
/// 0: as many as the machine offers. Each takes a stack, and a machine that has no more of them
/// ends the program.
inline constexpr Limits<int> kThreads{0, 4096};
inline constexpr Limits<float> kStops{-kMostStops, kMostStops};  ///< limits of exposure
inline constexpr Limits<double> kPixelsPerDegree{1.0, 1000.0};
}  // namespace limits

/// Raises UsageError that names what the number is of.
template <typename Number>
void check_within(const Limits<Number>& limits, Number value, const std::string& name) {
  if (limits.contain(value)) return;
  throw UsageError(fmt::format("{}: must be {} {}, not {}", name,
                               std::integral<Number> ? "a whole number" : "a number", limits.text(),
                               value));
}

}  // namespace ajar
