#pragma once

namespace ajar::cli {

/// What `ajar` returns, beside the codes of errors (core/error.h).
inline constexpr int kExitFailedRuns = 1;
inline constexpr int kExitScene = 3;
inline constexpr int kExitFile = 4;
inline constexpr int kExitInterrupted = 130;

}  // namespace ajar::cli
