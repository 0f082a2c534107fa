#include "transport/kept_directions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "mcmc/primary/gaussian_mutation.h"
#include "mcmc/primary/kelemen_mutation.h"
#include "mcmc/primary/primary_runner.h"
#include "mcmc/testing/toy_target.h"
#include "scene/testing/statistics.h"
#include "transport/subpath.h"

/// A path scatters twice on surfaces that turn with its place x on the picture. Chains that keep
/// directions while x moves must stay in the distribution they start from.
namespace ajar {
namespace {

using testing::Toy;
using testing::ToyValue;

constexpr int kBins = 12;
constexpr float kContrast = 0.9F;
/// From here to there the first surface is a mirror, before it reflects or transmits at random.
constexpr float kMirrorFrom = 0.6F;
constexpr float kMirrorTo = 0.75F;
const Vec3 kFirstLamp(0.6F, 0.F, 0.8F);
const Vec3 kSecondLamp(-0.28F, 0.F, 0.96F);

Vec3 tilted(double degrees) {
  const double angle = degrees * double{kPi} / 180.0;
  return {static_cast<float>(std::sin(angle)), 0.F, static_cast<float>(std::cos(angle))};
}
Vec3 first_normal(double x) { return tilted(120.0 * x - 60.0); }
Vec3 second_normal(double x) { return tilted(80.0 - 150.0 * x); }
double reflected(double x) { return 0.9 - x; }

PathVertex vertex_with(const Vec3& normal, int edges) {
  static const MediumInterface kNothing;
  PathVertex vertex;
  vertex.p = Vec3(0.F);
  vertex.wo = normal;
  vertex.throughput = Spectrum(1.F);
  vertex.roulette = 1.F;
  vertex.medium = nullptr;
  vertex.media = &kNothing;
  vertex.edges = edges;
  vertex.in_medium = false;
  vertex.bsdf = Bsdf(Frame::around(normal), normal);
  return vertex;
}

using LightToward = double (*)(const Vec3& direction, const Vec3& lamp);
/// ∫ over a hemisphere with normal n, cosine-weighted, is 1 + kContrast · ⅔ n·lamp.
double soft(const Vec3& direction, const Vec3& lamp) {
  return 1.0 + double{kContrast} * double{dot(direction, lamp)};
}
/// A lamp of about 4°.
double small_lamp(const Vec3& direction, const Vec3& lamp) {
  return 1e-6 + std::exp((double{dot(direction, lamp)} - 1.0) / 0.003);
}

ToyValue look(SampleSource& numbers, KeptDirections* directions, LightToward light) {
  WalkSettings walk{TransportMode::Radiance, Stream::Camera, Heuristic::Balance, 100, false};
  walk.directions = directions;
  const float x = numbers.get(testing::kCameraX);
  double value = 1.0;
  Flight flight;
  PathVertex first = vertex_with(first_normal(x), 1);
  const bool mirror = x >= kMirrorFrom && x < kMirrorTo;
  if (mirror) {
    first.bsdf.add(Mirror{});
  } else if (x < kMirrorFrom) {
    const auto share = static_cast<float>(reflected(x));
    first.bsdf.add(Lambert{}, Spectrum(share));
    first.bsdf.add(LambertTransmission{}, Spectrum(1.F - share));
  } else {
    first.bsdf.add(OrenNayar(0.3F));
  }
  if (!scatter(walk, first, numbers, flight)) return {0.0, 0};
  if (!mirror) value *= light(flight.ray.direction, kFirstLamp);
  PathVertex second = vertex_with(second_normal(x), 2);
  second.bsdf.add(Lambert{});
  if (!scatter(walk, second, numbers, flight)) return {0.0, 0};
  value *= light(flight.ray.direction, kSecondLamp);
  return {value, testing::bin_of(x, kBins)};
}

class CurvedTarget final : public Target {
 public:
  CurvedTarget(LightToward light, bool follow) : light_(light), follow_(follow) {}
  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override {
    directions_.begin();
    directions_.trace(follow_ && change.raster);
    const ToyValue value = look(numbers, &directions_, light_);
    splats.push_back({Vec2(0.F), value.bin, Spectrum(static_cast<float>(value.scalar))});
    return value.scalar;
  }
  void accepted() override { directions_.accept(); }

 private:
  LightToward light_;
  bool follow_;
  KeptDirections directions_{3};
};

Toy curved() {
  Toy toy{"curved", [](SampleSource& numbers) { return look(numbers, nullptr, soft); },
          (1.0 + kContrast) * (1.0 + kContrast), 0.0, std::vector<double>(kBins)};
  constexpr int kSteps = 24000;
  for (int i = 0; i < kSteps; ++i) {
    const double x = (i + 0.5) / kSteps;
    const auto lit = [](const Vec3& normal, const Vec3& lamp, double share) {
      return 1.0 + double{kContrast} * 2.0 / 3.0 * double{dot(normal, lamp)} * share;
    };
    const bool mirror = x >= double{kMirrorFrom} && x < double{kMirrorTo};
    const double share = x < double{kMirrorFrom} ? 2.0 * reflected(x) - 1.0 : 1.0;
    const double value = (mirror ? 1.0 : lit(first_normal(x), kFirstLamp, share)) *
                         lit(second_normal(x), kSecondLamp, 1.0);
    toy.fractions[static_cast<std::size_t>(i * kBins / kSteps)] += value / kSteps;
    toy.mean += value / kSteps;
  }
  for (double& fraction : toy.fractions) fraction /= toy.mean;
  return toy;
}

struct Nowhere final : DepositSink {
  void deposit(std::span<const Splat>, double) override {}
};

TEST(KeptDirections, ChainsStayInTheirDistribution) {
  // 60,000 chains: a bin, about 8 % of them, is known to 1.4 % of itself. Without the densities of
  // the directions in the acceptance, bins are wrong by up to a fifth.
  const Toy toy = curved();
  constexpr std::uint64_t kChains = 60000;
  std::vector<double> expected;
  for (const double fraction : toy.fractions) expected.push_back(fraction * double{kChains});
  PrimarySettings settings;
  settings.probabilities = {0.0, 0.0, 0.0, 0.0, 0.8};
  settings.sizes.camera_endpoint.fill(3.F);
  const GaussianMutation gaussian(0.02);
  const KelemenMutation kelemen;
  for (const Mutation* mutation :
       {static_cast<const Mutation*>(&gaussian), static_cast<const Mutation*>(&kelemen)}) {
    SCOPED_TRACE(mutation->name());
    CurvedTarget target(soft, true);
    PrimaryRunner runner(settings, *mutation, testing::kToyShape, target);
    Nowhere nowhere;
    std::vector<double> counts(kBins, 0.0);
    for (std::uint64_t i = 0; i < kChains; ++i) {
      PrimaryChain chain = testing::exact_start(toy, 3, i);
      runner.run(chain, 12, nowhere);
      ReplaySource replay(chain.numbers);
      ++counts[static_cast<std::size_t>(toy.function(replay).bin)];
    }
    testing::expect_fits(counts, expected);
  }
}

/// Notes the numbers that are chosen for it.
struct ChosenNumbers final : SampleSource {
  float get(SampleAddress) override { return 0.5F; }
  Vec2 get_pair(SampleAddress) override { return {0.5F, 0.5F}; }
  void replace_pair(SampleAddress, const Vec2& numbers, double) override { chosen = numbers; }
  std::optional<Vec2> chosen;
};

TEST(KeptDirections, AreThoseOfTheLastSubpathTracedAndAccepted) {
  const Vec3 up(0.F, 0.F, 1.F);
  PathVertex vertex = vertex_with(up, 1);
  vertex.bsdf.add(Lambert{});
  const SampleAddress address{Stream::Camera, 1, Slot::BsdfDirectionX};
  KeptDirections directions(3);
  const auto step = [&](double degrees, bool accepted) {
    directions.begin();
    directions.trace(false);
    directions.note(vertex, 0.5F, tilted(degrees));
    if (accepted) directions.accept();
  };
  const auto kept = [&] {
    directions.begin();
    directions.trace(true);
    ChosenNumbers source;
    directions.place(vertex, 0.5F, address, source);
    return source.chosen;
  };
  EXPECT_FALSE(kept()) << "nothing was traced yet";
  step(30.0, true);
  step(50.0, false);
  // The current camera half may stay as it is, in an accepted step of the light half.
  directions.begin();
  directions.accept();
  const std::optional<LobeInverse> current =
      vertex.bsdf.inverse(up, tilted(30.0), 0.5F, Inverted::Diffuse);
  ASSERT_TRUE(kept());
  EXPECT_EQ(kept()->x, current->direction.x);
  EXPECT_EQ(kept()->y, current->direction.y);
}

/// Acceptance of steps of the raster numbers, from states that two small lamps light.
double acceptance(bool follow) {
  PrimarySettings settings;
  settings.probabilities = {0.0, 0.0, 0.0, 0.0, 1.0};
  const GaussianMutation mutation(0.01);
  CurvedTarget target(small_lamp, follow);
  PrimaryRunner runner(settings, mutation, testing::kToyShape, target);
  Nowhere nowhere;
  ChainStatistics statistics;
  Toy lit = curved();
  lit.function = [](SampleSource& numbers) { return look(numbers, nullptr, small_lamp); };
  lit.largest = 0.1;  // brighter ones are fewer than they should be, which does not matter here
  for (std::uint64_t i = 0; i < 40; ++i) {
    PrimaryChain chain = testing::exact_start(lit, 5, i);
    statistics += runner.run(chain, 50, nowhere);
  }
  return statistics.moves[move_of(StepKind::SmallRaster)].acceptances /
         static_cast<double>(statistics.moves[move_of(StepKind::SmallRaster)].proposals);
}

TEST(KeptDirections, StepsAcrossACurvedSurfaceAreAcceptedMoreOften) {
  EXPECT_GT(acceptance(true), 1.4 * acceptance(false));
}

}  // namespace
}  // namespace ajar
