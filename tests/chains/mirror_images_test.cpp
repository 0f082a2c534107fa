#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/random.h"
#include "mcmc/chain_runner.h"
#include "mcmc/moments.h"
#include "mcmc/path_space/make_path_mutations.h"
#include "support/path_samples.h"
#include "support/render.h"

/// A lamp between two mirrors that face each other: to each place on the floor there is one
/// path by each image of a place on it, and chains have to be on each as often as the image gives
/// light.
namespace ajar {
namespace {

constexpr double kReflectance = 0.8;
constexpr int kMostBounces = test::kPathSampleDepth - 2;
const Vec3d kLampMiddle(0.1, 1.2, 0.0);
constexpr double kLampHalf = 0.8;

std::string between_mirrors() {
  return test::pbrt_scene(
      "LookAt 0 1.5 -2  0 0 0.1  0 1 0\nCamera \"perspective\" \"float fov\" [16]", 24, 16, R"(
AttributeBegin
AreaLightSource "diffuse" "rgb L" [1 1 1]
Shape "trianglemesh" "point P" [-0.7 1.2 -0.8  0.9 1.2 -0.8  0.9 1.2 0.8  -0.7 1.2 0.8]
  "integer indices" [0 1 2 0 2 3]
AttributeEnd
Material "matte" "rgb Kd" [0.5 0.5 0.5]
Shape "trianglemesh" "point P" [-1 0 -4  1 0 -4  1 0 4  -1 0 4] "integer indices" [0 2 1 0 3 2]
Material "mirror" "rgb Kr" [0.8 0.8 0.8]
Shape "trianglemesh" "point P" [-1 0 -4  -1 4 -4  -1 4 4  -1 0 4] "integer indices" [0 2 1 0 3 2]
Shape "trianglemesh" "point P" [1 0 -4  1 4 -4  1 4 4  1 0 4] "integer indices" [0 2 1 0 3 2]
)");
}

/// The lamp itself is 0; images by n mirrors are 2n − 1 and 2n, by which comes first.
constexpr std::size_t kImages = 2 * kMostBounces + 1;

/// Empty for other paths: light that comes from the floor.
std::optional<std::size_t> image_of(const Path& path) {
  const int bounces = path.depth() - 2;
  if (bounces < 0) return std::nullopt;
  for (int x = 1; x <= bounces; ++x) {
    if (!path.vertex(x).event.specular()) return std::nullopt;
  }
  if (bounces == 0) return 0;
  return static_cast<std::size_t>(2 * bounces) - (path.vertex(1).p().x < 0.F ? 1U : 0U);
}

/// Mirror image of a place on the lamp.
Vec3d image_of(const Vec3d& on_lamp, std::size_t image) {
  const std::size_t bounces = (image + 1) / 2;
  double mirror = image % 2 == 1 ? -1.0 : 1.0;
  Vec3d place = on_lamp;
  for (std::size_t i = 0; i < bounces; ++i) {
    place.x = 2.0 * mirror - place.x;
    mirror = -mirror;
  }
  return place;
}

/// At a place on the floor, but for a factor. The lamp shines downward, in all of its images.
double irradiance(const Vec3d& p, std::size_t image) {
  constexpr int kParts = 8;
  double sum = 0.0;
  for (int part = 0; part < kParts * kParts; ++part) {
    const auto shift = [](int i) { return ((i + 0.5) / kParts * 2.0 - 1.0) * kLampHalf; };
    const Vec3d on_lamp = kLampMiddle + Vec3d(shift(part % kParts), 0.0, shift(part / kParts));
    const Vec3d d = image_of(on_lamp, image) - p;
    sum += d.y * d.y / std::pow(d.dot(d), 2.0);
  }
  return std::pow(kReflectance, static_cast<double>((image + 1) / 2)) * sum;
}

/// Shares of the light from all images, over the picture.
std::vector<double> shares(const Scene& scene) {
  std::vector<double> light(kImages, 0.0);
  const Vec2i pixels = scene.camera().resolution();
  double sum = 0.0;
  for (int j = 0; j < 2 * pixels.y; ++j) {
    for (int i = 0; i < 2 * pixels.x; ++i) {
      const Vec2 at((static_cast<float>(i) + 0.5F) / static_cast<float>(2 * pixels.x),
                    (static_cast<float>(j) + 0.5F) / static_cast<float>(2 * pixels.y));
      const auto ray = scene.camera().sample_emission({0.F, Vec2(0.5F), at});
      const auto hit = scene.intersect({ray->origin, ray->w});
      const Vec3d p(hit->point.p);
      EXPECT_NEAR(p.y, 0.0, 1e-4) << "the floor is all that is seen";
      for (std::size_t image = 0; image < kImages; ++image) {
        const double own = irradiance(p, image);
        light[image] += own;
        sum += own;
      }
    }
  }
  for (double& share : light) share /= sum;
  return light;
}

/// Counts where a chain is, as often as it is there.
class ImageCounter final : public DepositSink {
 public:
  explicit ImageCounter(const PathChain& chain) : chain_(chain) {}
  void proposed(std::span<const Splat> /*current*/, double /*probability*/) override {
    const auto image = image_of(chain_.path);
    if (image) visits[*image] += 1.0;
    if (image && last_ && *image != *last_) ++changes;
    if (image) last_ = image;
  }
  void deposit(std::span<const Splat> /*splats*/, double /*weight*/) override {}
  std::vector<double> visits = std::vector<double>(kImages, 0.0);
  int changes = 0;  ///< changes of the image

 private:
  const PathChain& chain_;
  std::optional<std::size_t> last_;
};

TEST(MirrorImages, AreVisitedAsOftenAsTheyGiveLight) {
  const auto scene = test::scene_from(between_mirrors());
  const PathBounds bounds = test::path_sample_bounds(*scene);
  const std::vector<double> expected = shares(*scene);
  // Mostly of those that change the number of bounces.
  std::vector<double> weights;
  for (const PathMutationInfo& info : path_mutations()) {
    weights.push_back(info.name == "bidirectional" ? 1.0 : 0.1);
  }
  PathKernel kernel = make_path_kernel(*scene, bounds, weights, [](int) { return 0; });
  ChainRunner runner(kernel);

  // Chains start from paths that are distributed as light is, drawn evenly from them.
  constexpr std::uint32_t kStarts = 12000;
  constexpr double kChainsPerStart = 0.2;
  std::vector<test::WeightedPath> all;
  double light = 0.0;
  test::for_samples(*scene, kStarts,
                    [&](std::uint32_t, const std::vector<test::WeightedPath>& paths) {
                      for (const test::WeightedPath& path : paths) {
                        all.push_back(path);
                        light += path.weight;
                      }
                    });
  const double per_chain = light / (kStarts * kChainsPerStart);
  std::vector<Moments> visits(kImages);
  Moments counted;
  int changes = 0;
  double left = 0.5 * per_chain;
  std::uint64_t number = 0;
  for (const test::WeightedPath& start : all) {
    for (left -= start.weight; left < 0.0; left += per_chain) {
      PathChain chain;
      chain.path = start.path;
      chain.scalar = 1.0;
      chain.seed = hash_numbers(11, number++);
      kernel.start(chain);
      ImageCounter counter(chain);
      runner.go_on(chain, 1000, counter);
      changes += counter.changes;
      double of_images = 0.0;
      for (std::size_t i = 0; i < kImages; ++i) {
        visits[i].add(counter.visits[i]);
        of_images += counter.visits[i];
      }
      counted.add(of_images);
    }
  }
  ASSERT_GT(number, 1000U);
  EXPECT_GT(changes, 2 * static_cast<int>(number))
      << "chains that keep to their images show nothing";
  // Chains hardly ever come to the others.
  constexpr std::size_t kSeen = 5;
  for (std::size_t i = 0; i < kSeen; ++i) {
    const double error = visits[i].standard_error() / counted.mean();
    EXPECT_NEAR(visits[i].mean() / counted.mean(), expected[i], 5.0 * error) << "image " << i;
    EXPECT_LT(5.0 * error, 0.2 * expected[i] + 0.01) << "too noisy to notice what it should, " << i;
  }
}

}  // namespace
}  // namespace ajar
