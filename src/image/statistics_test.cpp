#include "image/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace ajar {
namespace {

/// Normal noise of the given relative size around `truth`; each replicate alone has √R times that.
Replicates noisy(const std::vector<float>& truth, double relative, int count, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Replicates replicates(static_cast<std::size_t>(count), truth);
  for (auto& image : replicates) {
    for (float& v : image) {
      v = static_cast<float>(v * (1.0 + relative * std::sqrt(count) * normal(generator)));
    }
  }
  return replicates;
}

TEST(StandardError, MatchesTheValueByHand) {
  const Replicates replicates = {{1.F, 5.F}, {2.F, 5.F}, {6.F, 5.F}};
  EXPECT_FLOAT_EQ(replicate_mean(replicates)[0], 3.F);
  // Squares 4 + 1 + 9 = 14, over 3 · 2.
  EXPECT_FLOAT_EQ(standard_error(replicates)[0], std::sqrt(14.F / 6.F));
  EXPECT_EQ(standard_error(replicates)[1], 0.F);
}

TEST(ReplicateMedian, HasNoFireflyOfASingleReplicate) {
  const Replicates replicates = {{1.F, 900.F}, {900.F, 3.F}, {2.F, 2.F}, {3.F, 4.F}};
  EXPECT_EQ(replicate_median(replicates), (std::vector<float>{2.F, 3.F})) << "the lower of two";
  EXPECT_EQ(replicate_median({{5.F}, {9.F}, {7.F}}), std::vector<float>{7.F});
  EXPECT_EQ(replicate_median({{5.F}}), std::vector<float>{5.F});
  EXPECT_THROW(replicate_median({}), std::invalid_argument);
}

TEST(StandardError, ItsSquareIsUnbiased) {
  const std::vector<float> truth(100000, 2.F);
  for (const int count : {2, 4, 16}) {
    double sum = 0.0;
    for (const float e : standard_error(noisy(truth, 0.1, count, 3))) sum += double{e} * e;
    // Relative standard deviation of the mean of χ²(R−1): at most √2/√100000 = 0.45 %.
    EXPECT_NEAR(sum / 1e5 / (0.2 * 0.2), 1.0, 5 * 0.0045) << count << " replicates";
  }
}

TEST(StandardError, NeedsTwoReplicatesOfOneSize) {
  EXPECT_THROW(standard_error({{1.F}}), std::invalid_argument);
  EXPECT_THROW(standard_error({{1.F}, {1.F, 2.F}}), std::invalid_argument);
}

TEST(ImageMean, ErrorCoversCorrelatedPixels) {
  // Every pixel of a replicate has the same error: the mean is no better than one pixel.
  std::mt19937 generator(8);
  std::normal_distribution<float> normal(3.F, 0.5F);
  Replicates replicates;
  for (int r = 0; r < 400; ++r) replicates.emplace_back(1000, normal(generator));
  const Estimate mean = image_mean(replicates);
  EXPECT_NEAR(mean.standard_error, 0.5 / std::sqrt(400.0), 0.025 * 5 * 0.036);
  EXPECT_NEAR(mean.value, 3.0, 5 * mean.standard_error);
  EXPECT_EQ(mean.degrees_of_freedom, 399);
}

TEST(Replicates, OfAFilmAreSumsOfItsLayers) {
  Film film({1, 1}, Box2i({0, 0}, {0, 0}), Filter::box(), 2,
            {{"direct"}, {"albedo", false}, {"indirect"}});
  film.add(0, 0, {0, 0}, Spectrum(3.F));
  film.add(2, 0, {0, 0}, Spectrum(1.F));
  film.add(0, 1, {0, 0}, Spectrum(1.F));
  const std::vector<ScaledLayer> layers = {{0, {1.0, 2.0}}, {2, {1.0, 2.0}}};
  EXPECT_EQ(develop_replicates(film, layers), (Replicates{{4.F, 4.F, 4.F}, {2.F, 2.F, 2.F}}));
}

}  // namespace
}  // namespace ajar
