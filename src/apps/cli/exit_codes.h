#pragma once

namespace ajar::cli {

/// Exit codes of `ajar`, beside those of errors (core/error.h).
inline constexpr int kExitFailedRuns = 1;
inline constexpr int kExitScene = 3;
inline constexpr int kExitFile = 4;
inline constexpr int kExitInterrupted = 130;

}  // namespace ajar::cli
