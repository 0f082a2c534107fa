#include "mcmc/path_space/path_kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mcmc/chain_statistics.h"
#include "support/path_samples.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Records of a kernel of paths on steps without a proposal.
namespace ajar {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

std::int32_t same_layer(int /*depth*/) { return 0; }

/// Claims of a mutation of these tests.
struct Claims {
  bool suits_old = true;
  bool suits_new = true;
  double log_forth = 0.0;
  double log_back = 0.0;
};

/// Proposes one path from any current one.
class OnePathMutation final : public PathMutation {
 public:
  OnePathMutation(Path path, const Claims& claims) : path_(std::move(path)), claims_(claims) {}
  std::string_view name() const override { return "one-path"; }
  bool suitable(const Path& path) const override {
    return is_new(path) ? claims_.suits_new : claims_.suits_old;
  }
  std::optional<Kept> propose(const Path& /*x*/, std::uint64_t /*key*/, Path& y) override {
    y = path_;
    return Kept{0, 0};
  }
  double log_density(const Path& /*x*/, const Path& y, const Kept& /*kept*/) const override {
    return is_new(y) ? claims_.log_forth : claims_.log_back;
  }
  const RayCounts& ray_counts() const override { return rays_; }

 private:
  bool is_new(const Path& path) const {
    return path.raster == path_.raster && path.depth() == path_.depth();
  }
  Path path_;
  Claims claims_;
  RayCounts rays_;
};

/// Records the light on new paths that it receives.
class ToldWeight final : public PathWeight {
 public:
  double part(const Path& /*path*/, double /*log_light*/) override {
    return asked_++ == 0 ? 1.0 : of_new;
  }
  float importance(const Vec2& /*raster*/) const override { return 1.F; }
  double of_new = 1.0;

 private:
  int asked_ = 0;
};

/// One step from a lit path to another one.
class PathKernelStep : public ::testing::Test {
 protected:
  PathKernelStep()
      : scene_(test::scene_from(test::small_scene("Room").text)),
        bounds_(test::path_sample_bounds(*scene_)) {
    test::for_samples(
        *scene_, 200, [&](std::uint32_t, const std::vector<test::WeightedPath>& paths) {
          SplatBuffer splats;
          for (const test::WeightedPath& weighted : paths) {
            const bool is_lit = std::isfinite(light_on(*scene_, weighted.path, bounds_, 0, splats));
            if (is_lit && found_.size() < 2) found_.push_back(weighted.path);
          }
        });
  }

  struct Result {
    ChainStatistics statistics;
    double probability;
  };
  Result step(const Claims& claims, double weight_of_new = 1.0) {
    ToldWeight weight;
    weight.of_new = weight_of_new;
    std::vector<MixedMutation> mutations;
    mutations.push_back({std::make_unique<OnePathMutation>(found_.at(1), claims), 1.0});
    PathKernel kernel(*scene_, bounds_, std::move(mutations), same_layer, &weight);
    PathChain chain;
    chain.path = found_.at(0);
    chain.scalar = 1.0;
    kernel.start(chain);
    const Proposal proposal = kernel.propose(1);
    Result result{{}, proposal.candidates.front().probability};
    result.statistics.moves.resize(1);
    result.statistics.steps = 1;
    if (proposal.move) {
      result.statistics.moves.at(*proposal.move).count(proposal, result.probability);
      result.statistics.count(proposal.candidates.front(), {});
    }
    return result;
  }

  std::unique_ptr<Scene> scene_;
  PathBounds bounds_;
  std::vector<Path> found_;
};

TEST_F(PathKernelStep, AcceptsSymmetricProposals) {
  const Result result = step({});
  EXPECT_GT(result.probability, 0.0);
  EXPECT_EQ(result.statistics.idle_steps(), 0U);
  EXPECT_EQ(result.statistics.moves[0].proposals, 1U);
  EXPECT_EQ(result.statistics.moves[0].dark, 0U);
  EXPECT_EQ(result.statistics.moves[0].without_density, 0U);
}

TEST_F(PathKernelStep, WithoutASuitableMutationIsIdle) {
  Claims claims;
  claims.suits_old = false;
  const Result result = step(claims);
  EXPECT_EQ(result.probability, 0.0);
  EXPECT_EQ(result.statistics.moves[0].proposals, 0U);
  EXPECT_EQ(result.statistics.idle_steps(), 1U);
}

TEST_F(PathKernelStep, ToALitPathThatDoesNotSuitIsNotDark) {
  Claims claims;
  claims.suits_new = false;
  const Result result = step(claims);
  EXPECT_EQ(result.probability, 0.0);
  EXPECT_EQ(result.statistics.moves[0].proposals, 1U);
  EXPECT_EQ(result.statistics.moves[0].dark, 0U);
  EXPECT_EQ(result.statistics.zero, 0U);
}

TEST_F(PathKernelStep, WithoutAReverseIsRejectedAndNoError) {
  Claims claims;
  claims.log_back = kNever;
  const Result result = step(claims);
  EXPECT_EQ(result.probability, 0.0);
  EXPECT_EQ(result.statistics.moves[0].without_density, 0U);
}

TEST_F(PathKernelStep, OfNanDensityIsRejectedAndCounted) {
  for (const auto& [forth, back] :
       {std::pair(kNever, 0.0), std::pair(kEndless, 0.0), std::pair(kNoNumber, 0.0),
        std::pair(0.0, kEndless), std::pair(0.0, kNoNumber), std::pair(kNoNumber, kNever)}) {
    Claims claims;
    claims.log_forth = forth;
    claims.log_back = back;
    const Result result = step(claims);
    EXPECT_EQ(result.probability, 0.0) << forth << ", " << back;
    EXPECT_EQ(result.statistics.moves[0].without_density, 1U) << forth << ", " << back;
    EXPECT_EQ(result.statistics.moves[0].dark, 0U) << forth << ", " << back;
  }
}

TEST_F(PathKernelStep, ToNanLightIsRejectedAndCounted) {
  const Result not_a_number = step({}, kNoNumber);
  EXPECT_EQ(not_a_number.probability, 0.0);
  EXPECT_EQ(not_a_number.statistics.discarded_nan, 1U);
  EXPECT_TRUE(not_a_number.statistics.first_discarded);
  const Result endless = step({}, kEndless);
  EXPECT_EQ(endless.probability, 0.0);
  EXPECT_EQ(endless.statistics.discarded_infinite, 1U);
  const Result dark = step({}, 0.0);
  EXPECT_EQ(dark.probability, 0.0);
  EXPECT_EQ(dark.statistics.discarded_nan + dark.statistics.discarded_infinite, 0U);
  EXPECT_EQ(dark.statistics.moves[0].dark, 1U);
}

TEST(MoveRecord, IsSummable) {
  MoveRecord record;
  const std::array<Candidate, 1> candidates{};
  Proposal proposal{0, candidates};
  proposal.without_density = true;
  proposal.walk = WalkEnd::OneWay;
  record.count(proposal, 0.0);
  record += MoveRecord(record);
  EXPECT_EQ(record.without_density, 2U);
  EXPECT_EQ(record.one_way_walks, 2U);
  EXPECT_EQ(record.lost_walks, 0U);
}

}  // namespace
}  // namespace ajar
