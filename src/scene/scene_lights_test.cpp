#include <gtest/gtest.h>

#include "core/warnings.h"
#include "scene/desc/models.h"
#include "scene/scene.h"
#include "scene/testing/endpoint_checks.h"
#include "scene/testing/small_world.h"

/// Tests of the scene's properties that lights receive.
namespace ajar {
namespace {

using namespace testing;

TEST(SceneLights, FarLampsAreAimedAtTheScene) {
  desc::SceneDesc description;
  description.materials.emplace_back().node = desc::material_node("diffuse");
  description.shapes = {mesh_shape(cube()), mesh_shape(square(0.3F), translation(0, 0, -90))};
  for (desc::Shape& shape : description.shapes) shape.material = 0;
  description.shapes.back().emission = desc::Emission{{}, desc::emission_node("area")};
  desc::Light& point = description.lights.emplace_back();
  point.node = desc::light_node("point");
  point.to_world = translation(0, 90, 0);
  Warnings warnings;
  const Scene scene(std::move(description), {}, warnings);
  ASSERT_EQ(scene.lights().size(), 2U);
  for (const std::unique_ptr<Light>& light : scene.lights()) {
    Rng rng(3);
    int met = 0;
    constexpr int kRays = 1000;
    for (int i = 0; i < kRays; ++i) {
      const auto ray = light->sample_emission(emission_uniforms(rng));
      if (ray && length(cross(ray->w, ray->origin)) < 1.75F) ++met;
    }
    // Not aimed, one in 11 000 of the point's and one in 2700 of the square's would.
    EXPECT_GT(met, 0.9 * kRays);
  }
}

}  // namespace
}  // namespace ajar
