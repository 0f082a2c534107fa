#include "study/bias.h"

#include <cmath>

#include "image/flip.h"

namespace ajar::study {

namespace {
ErrorSource source_of(const LoadedPicture& picture) {
  if (picture.replicates.size() >= 2) return ErrorSource::Replicates;
  return picture.standard_error.empty() ? ErrorSource::None : ErrorSource::StandardError;
}

std::vector<float> variance_of(const LoadedPicture& picture) {
  std::vector<float> variance = source_of(picture) == ErrorSource::Replicates
                                    ? standard_error(picture.replicates)
                                    : picture.standard_error;
  for (float& v : variance) v *= v;
  return variance;
}

BlockComparison compare(const BiasTest& test, const LoadedPicture& picture,
                        const LoadedPicture& reference) {
  const BlockGrid grid{picture.size.x, picture.size.y, 3, BiasTest::kBlock};
  if (test.picture == ErrorSource::Replicates) {
    if (test.reference == ErrorSource::Replicates) {
      return compare_blocks(picture.replicates, reference.replicates, grid);
    }
    return compare_blocks_to_reference(picture.replicates, reference.linear, variance_of(reference),
                                       grid);
  }
  return compare_blocks_by_variance(picture.linear, variance_of(picture), reference.linear,
                                    variance_of(reference), grid);
}
}  // namespace

const char* to_string(ErrorSource source) {
  switch (source) {
    case ErrorSource::None:
      return "none";
    case ErrorSource::StandardError:
      return "standard-error";
    case ErrorSource::Replicates:
      return "replicates";
  }
  return "";
}

std::optional<BiasTest> test_bias(const LoadedPicture& picture, const LoadedPicture& reference) {
  BiasTest test;
  test.picture = source_of(picture);
  test.reference = source_of(reference);
  if (test.picture == ErrorSource::None) return std::nullopt;
  test.result = compare(test, picture, reference);
  test.differs = !test.result.equal(BiasTest::kLevel);
  const BlockComparison& r = test.result;
  const double mean = std::abs(map_mean(reference.linear));
  const double block_level = BiasTest::kLevel / std::max(r.tests, 1);
  test.detectable_mean =
      detectable_difference(r.mean_error, r.mean_freedom, BiasTest::kLevel, BiasTest::kPower) /
      mean;
  test.detectable_block =
      detectable_difference(r.typical_error, r.typical_freedom, block_level, BiasTest::kPower) /
      mean;
  return test;
}

}  // namespace ajar::study
