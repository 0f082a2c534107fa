#pragma once
#include <optional>

#include "image/compare_blocks.h"
#include "study/loaded_picture.h"

/// Is a picture the reference but for noise? Answered where the files know their own error.
namespace ajar::study {

/// Where the error of a picture comes from.
enum class ErrorSource {
  None,           ///< taken as exact
  StandardError,  ///< a number per pixel; pixels are taken as independent
  Replicates      ///< independent estimates; holds for splats and chains as well
};
const char* to_string(ErrorSource source);

struct BiasTest {
  static constexpr int kBlock = 16;  ///< pixels
  /// A pair of equal pictures is called different with a probability of at most 2·kLevel.
  static constexpr double kLevel = 1e-3;
  static constexpr double kPower = 0.9;

  ErrorSource picture = ErrorSource::None;
  ErrorSource reference = ErrorSource::None;
  BlockComparison result;
  bool differs = false;
  /// Relative difference of the mean of the whole picture, and of a typical block, that the test
  /// finds with probability `kPower`. The latter is divided by the mean of the whole reference.
  double detectable_mean = 0;
  double detectable_block = 0;
};

/// Empty if the picture says nothing of its error. Both have the same size. If one of two pictures
/// with errors has only standard errors, the other's replicates are reduced to theirs, for Welch's
/// test wants both of a kind; a reference without errors is taken as exact.
std::optional<BiasTest> test_bias(const LoadedPicture& picture, const LoadedPicture& reference);

}  // namespace ajar::study
