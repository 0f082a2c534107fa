#include "integrator/selective/lasting_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/archive.h"

namespace ajar {
namespace {

constexpr std::size_t kPixels = 4000;

/// Four replicates whose chains start from a mean of all samples so far, and add noise of their own
/// in each stretch.
class Chains {
 public:
  /// Standard deviations: of one sample, and of what mutations bring to a stretch.
  Chains(double found, double moved) : found_(found), moved_(moved) {
    for (int r = 0; r < 4; ++r) {
      samples_.emplace_back(kPixels, 0.0);
      sums_.emplace_back(kPixels, 0.0);
    }
  }

  void tell(LastingError& lasting, int stretches) {
    for (int i = 0; i < stretches; ++i) {
      const double samples = behind_ == 0.0 ? 4.0 : behind_ / 2.0;
      behind_ += samples;
      weight_ += behind_;
      std::vector<std::vector<float>> light(4);
      for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t j = 0; j < kPixels; ++j) {
          samples_[r][j] += std::sqrt(samples) * found_ * normal();
          // Even replicates may leave chains another part of the light.
          const double expected = r % 2 == 0 ? 1.0 : 50.0;
          const double stretch = expected + samples_[r][j] / behind_ + moved_ * normal();
          sums_[r][j] += behind_ * stretch;
          light[r].push_back(static_cast<float>(sums_[r][j] / weight_));
        }
      }
      lasting.see(light, weight_, behind_);
    }
  }

 private:
  double normal() { return std::normal_distribution<double>()(random_); }

  double found_;
  double moved_;
  double behind_ = 0.0;
  double weight_ = 0.0;
  std::vector<std::vector<double>> samples_;
  std::vector<std::vector<double>> sums_;
  std::mt19937 random_{7};
};

double share_of(double found, double moved) {
  LastingError lasting(kPixels, 4);
  Chains(found, moved).tell(lasting, 8);
  return lasting.share().value();
}

TEST(LastingError, IsThatOfWhereChainsStart) { EXPECT_GT(share_of(1.0, 0.0), 0.85); }

TEST(LastingError, IsNotThatOfWhatMutationsBring) { EXPECT_LT(share_of(0.0, 1.0), 0.03); }

/// Chains that stay where they were, and then are elsewhere.
TEST(LastingError, IsNotThatOfWhatIsForgotten) {
  LastingError lasting(kPixels, 4);
  std::mt19937 random(3);
  std::vector<std::vector<double>> sums(4, std::vector<double>(kPixels, 0.0));
  std::vector<std::vector<double>> before = sums;
  for (int i = 1; i < 9; ++i) {
    std::vector<std::vector<float>> light(4);
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t j = 0; j < kPixels; ++j) {
        const double now = std::normal_distribution<double>()(random);
        sums[r][j] += before[r][j] + now;
        before[r][j] = now;
        light[r].push_back(static_cast<float>(sums[r][j] / i));
      }
    }
    lasting.see(light, i, 1.0);
  }
  EXPECT_LT(lasting.share().value(), 0.03);
}

TEST(LastingError, IsAShareOfBoth) {
  double before = 0.0;
  for (const double found : {3.0, 6.0, 12.0}) {
    const double share = share_of(found, 1.0);
    EXPECT_GT(share, before + 0.1) << found;
    before = share;
  }
  EXPECT_LT(before, 0.8);
}

TEST(LastingError, IsUnknownUntilStretchesCanBeCompared) {
  LastingError lasting(kPixels, 4);
  Chains chains(1.0, 0.0);
  chains.tell(lasting, 3);
  EXPECT_FALSE(lasting.share());
  chains.tell(lasting, 1);
  EXPECT_TRUE(lasting.share());
  const std::vector<std::vector<float>> dark(4, std::vector<float>(10, 0.F));
  LastingError of_nothing(10, 4);
  for (int i = 1; i < 6; ++i) of_nothing.see(dark, i, i);
  EXPECT_FALSE(of_nothing.share());
}

TEST(LastingError, IsSeenInTwoReplicates) {
  LastingError lasting(2, 2);
  for (int i = 1; i < 5; ++i) lasting.see({{1.F, 2.F}, {2.F, 0.F}}, i, 1.0);
  EXPECT_DOUBLE_EQ(lasting.share().value(), 1.0);
}

TEST(LastingError, RefusesPicturesAndArchivesOfAnotherRender) {
  LastingError lasting(2, 2);
  EXPECT_THROW(lasting.see({{1.F, 2.F}}, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(lasting.see({{1.F, 2.F}, {1.F}}, 1.0, 1.0), std::invalid_argument);
  lasting.see({{1.F, 2.F}, {2.F, 0.F}}, 1.0, 1.0);
  const std::string bytes = archived([&](OutputArchive& out) { lasting.save_state(out); });
  LastingError larger(3, 2);
  InputArchive archive(bytes);
  EXPECT_THROW(larger.load_state(archive), std::runtime_error);
}

TEST(LastingError, GoesOnFromAnArchive) {
  LastingError lasting(kPixels, 4);
  Chains chains(2.0, 1.0);
  chains.tell(lasting, 5);
  const std::string bytes = archived([&](OutputArchive& out) { lasting.save_state(out); });
  LastingError again(kPixels, 4);
  InputArchive archive(bytes);
  again.load_state(archive);
  EXPECT_EQ(again.share().value(), lasting.share().value());
  Chains same = chains;
  chains.tell(lasting, 1);
  same.tell(again, 1);
  EXPECT_EQ(again.share().value(), lasting.share().value());
}

}  // namespace
}  // namespace ajar
