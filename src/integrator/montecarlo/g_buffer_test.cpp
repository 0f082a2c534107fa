#include "integrator/montecarlo/g_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "core/warnings.h"
#include "integrator/integrator.h"
#include "scene/desc/models.h"
#include "scene/scene.h"

/// The layers of surfaces as a path integrator fills them.
namespace ajar {
namespace {

constexpr int kWidth = 6;
constexpr int kHeight = 4;

desc::Shape rectangle(float x_min, float x_max, float y_min, float y_max, float z, int material) {
  auto mesh = std::make_shared<desc::Mesh>();
  mesh->positions = {{x_min, y_min, z}, {x_max, y_min, z}, {x_max, y_max, z}, {x_min, y_max, z}};
  mesh->indices.emplace_back(0, 1, 2);
  mesh->indices.emplace_back(0, 2, 3);
  desc::Shape shape;
  shape.node = desc::mesh_node(std::move(mesh));
  shape.material = material;
  return shape;
}

/// A camera that sees one scene unit as one pixel, from (−3, 2) in the upper left corner to (3,
/// −2). Object 1 of material 2 fills the upper right from x = 0.25 on, object 2 of material 1 the
/// lower right from x = −0.25 on; the left is empty.
std::unique_ptr<Scene> two_rectangles(float lens_radius = 0.F) {
  desc::SceneDesc description;
  description.materials.resize(2);
  for (desc::Material& material : description.materials) {
    material.node = desc::material_node("diffuse");
  }
  description.shapes = {rectangle(0.25F, 9.F, 0.F, 9.F, 4.F, 1),
                        rectangle(-0.25F, 9.F, -9.F, 0.F, 4.F, 0)};
  desc::Light light;
  light.node = desc::light_node("point");
  description.lights.push_back(light);
  desc::OrthographicCamera camera;
  camera.window = desc::ScreenWindow{-3, 3, -2, 2};
  camera.lens_radius = lens_radius;
  camera.focal_distance = 1.F;
  description.camera.node = camera;
  description.film.resolution = {kWidth, kHeight};
  Warnings warnings;
  auto scene = std::make_unique<Scene>(std::move(description), BuildOptions{}, warnings);
  EXPECT_EQ(warnings.count(), 0U);
  return scene;
}

/// Sums of a render of all layers, of `samples` per pixel in as many passes as asked for.
struct Sums {
  std::unique_ptr<Film> film;
  double scale;
  std::vector<float> channel(const std::string& name) const {
    const std::vector<float> pixels = film->develop(film->layer(name), scale);
    std::vector<float> result;
    for (std::size_t i = 0; i < pixels.size(); i += 3) result.push_back(pixels[i]);
    return result;
  }
};
Sums render(const Scene& scene, std::uint64_t samples,
            const std::optional<Box2i>& crop = std::nullopt, bool backwards = false,
            const Filter& filter = Filter::box()) {
  RenderSettings settings;
  settings.resolution = {kWidth, kHeight};
  settings.crop = crop.value_or(Box2i({0, 0}, {kWidth - 1, kHeight - 1}));
  settings.aovs.assign(GBuffer::names().begin(), GBuffer::names().end());
  const IntegratorInfo& info = find_integrator("pt");
  const auto integrator = info.make(scene, settings, info.read({}));
  Sums sums{std::make_unique<Film>(settings.resolution, settings.crop, filter, settings.replicates,
                                   integrator->layers()),
            1.0 / static_cast<double>(samples)};
  Counters counters;
  for (std::uint64_t i = 0; i < samples; ++i) {
    const std::uint64_t sample = backwards ? samples - 1 - i : i;
    for (std::uint64_t item = 0; item < integrator->items_in_round(); ++item) {
      integrator->run_item(item, sample, 1, *sums.film, counters);
    }
  }
  return sums;
}

std::vector<PixelIdentity> expected_identities() {
  const PixelIdentity none;
  const PixelIdentity upper{1, 2};
  const PixelIdentity lower{2, 1};
  return {none, none, none, upper, upper, upper,  //
          none, none, none, upper, upper, upper,  //
          none, none, none, lower, lower, lower,  //
          none, none, none, lower, lower, lower};
}

TEST(GBuffer, CoverageIsTheShareOfSamplesThatHitASurface) {
  const auto scene = two_rectangles();
  const std::vector<float> coverage = render(*scene, 256).channel("coverage");
  const std::vector<float> upper = {0.F, 0.F, 0.F, 0.75F, 1.F, 1.F};
  const std::vector<float> lower = {0.F, 0.F, 0.25F, 1.F, 1.F, 1.F};
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const float expected = (i < 2 * kWidth ? upper : lower)[i % kWidth];
    // Four sequences of 64 stratified points: one point of each at most is on the wrong side.
    EXPECT_NEAR(coverage[i], expected, 4.F / 256.F) << i;
    if (expected == 0.F || expected == 1.F) {
      EXPECT_EQ(coverage[i], expected) << i;
    }
  }
}

TEST(GBuffer, IdentitiesAreThoseOfMostSamples) {
  // Three quarters of a pixel show a rectangle on the left border above, one quarter below.
  const auto scene = two_rectangles();
  for (const std::uint64_t samples : {9, 40}) {
    EXPECT_EQ(majority_identities(*render(*scene, samples).film), expected_identities());
  }
}

TEST(GBuffer, IdentitiesOfBlurredBordersAreThoseOfMostSamplesToo) {
  // At 4 units, 3 behind the focus; the lens moves points by up to 0.3 pixels, which leaves each
  // pixel more than half to what it showed before.
  const auto scene = two_rectangles(0.1F);
  const Sums sums = render(*scene, 64);
  EXPECT_EQ(majority_identities(*sums.film), expected_identities());
  EXPECT_LT(sums.channel("coverage")[3], 1.F);
}

TEST(GBuffer, IdentitiesNeedNoMoreThanOneSample) {
  const auto scene = two_rectangles();
  const auto identities = majority_identities(*render(*scene, 1).film);
  for (const std::size_t pixel : {0, 1, 4, 5, 18, 19, 22, 23}) {
    EXPECT_EQ(identities[pixel], expected_identities()[pixel]) << pixel;
  }
}

TEST(GBuffer, OfACropIsThatPartOfTheWhole) {
  const auto scene = two_rectangles();
  const Sums whole = render(*scene, 12);
  const auto identities = majority_identities(*whole.film);
  for (const Box2i& crop : {Box2i({2, 1}, {5, 2}), Box2i({3, 0}, {3, 3}), Box2i({0, 3}, {4, 3})}) {
    const Sums part = render(*scene, 12, crop);
    const auto part_identities = majority_identities(*part.film);
    std::size_t i = 0;
    for (int y = crop.min.y; y <= crop.max.y; ++y) {
      for (int x = crop.min.x; x <= crop.max.x; ++x, ++i) {
        const std::size_t place =
            static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
        EXPECT_EQ(part_identities[i], identities[place]);
        EXPECT_EQ(part.channel("coverage")[i], whole.channel("coverage")[place]);
      }
    }
    EXPECT_EQ(part_identities.size(), i);
  }
}

TEST(GBuffer, DoesNotDependOnTheOrderOfSamples) {
  const auto scene = two_rectangles(0.1F);
  for (const Filter& filter : {Filter::box(), Filter::gaussian({1.5F, 1.5F}, 2.F)}) {
    const Sums forwards = render(*scene, 12, std::nullopt, false, filter);
    const Sums backwards = render(*scene, 12, std::nullopt, true, filter);
    EXPECT_TRUE(std::equal(forwards.film->raw().begin(), forwards.film->raw().end(),
                           backwards.film->raw().begin(), backwards.film->raw().end()));
  }
}

TEST(GBuffer, MakesOnlyRequestedLayers) {
  const auto names = [](const std::vector<std::string>& asked_for) {
    std::vector<std::string> result;
    for (const LayerSpec& spec : GBuffer::layers(asked_for, 1.F)) result.push_back(spec.name);
    return result;
  };
  EXPECT_TRUE(names({"samples"}).empty());
  EXPECT_EQ(names({"coverage", "depth"}), (std::vector<std::string>{"depth", "coverage"}));
  EXPECT_EQ(names({"object-id"}).size(), 3U);
}

}  // namespace
}  // namespace ajar
