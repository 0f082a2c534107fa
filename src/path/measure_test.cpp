#include "path/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "path/recorder.h"
#include "path/testing/plain_scene.h"

namespace ajar {
namespace {

TEST(ScaledSpectrum, ExceedsTheRangeOfFloats) {
  ScaledSpectrum product;
  for (int i = 0; i < 40; ++i) product *= Spectrum(1e-6F, 2e-6F, 0.F);
  // A lane that falls behind by more than floats span is nothing beside the others.
  EXPECT_NEAR(std::log10(product.luminance()), 40.0 * std::log10(2e-6) + std::log10(0.715160),
              0.01);
  for (int i = 0; i < 40; ++i) product *= 1e6;
  EXPECT_NEAR(double{product.value()[1]} / std::pow(2.0, 40.0), 1.0, 1e-4);
  product *= Spectrum();
  EXPECT_TRUE(product.is_black());
}

TEST(PathMeasure, ThroughputUnderAPointLightIsTheClosedForm) {
  const auto scene = testing::plain_scene();
  const PathSamplerSettings settings = testing::all_techniques();
  int next_event = 0;
  for (const auto& [path, technique] : testing::recorded(*scene, settings, 200)) {
    if (path.depth() != 2) continue;
    const InnerVertex& vertex = path.vertex(1);
    const Vec3 d = path.light_point.surface.p - vertex.p();
    const double squared = length_squared(d);
    const double cosine = double{abs_dot(d, vertex.hit.point.ng)} / std::sqrt(squared);
    const Spectrum albedo = vertex.bsdf.albedo(path.toward_camera(*scene, 1));
    const double radiance =
        double{testing::kIntensity} * cosine / squared * double{albedo[0]} / M_PI;
    EXPECT_NEAR(double{throughput(*scene, path, {1, 2})[0]} / radiance, 1.0, 1e-4);
    EXPECT_NEAR(technique_pdf(*scene, path, {1, 2}) * radiance /
                    (contribution(*scene, path).luminance() / double{luminance(Spectrum(1.F))}),
                1.0, 1e-4);
    // A point has no surface to run into, and its picture none to be splatted by one edge.
    EXPECT_EQ(technique_pdf(*scene, path, {0, 3}), 0.0);
    EXPECT_EQ(technique_pdf(*scene, path, {3, 0}), 0.0);
    EXPECT_EQ(technique_pdf(*scene, path, {1, 3}), 0.0) << "of another depth";
    EXPECT_NEAR(
        mis_weight(*scene, settings, path, {1, 2}) + mis_weight(*scene, settings, path, {2, 1}),
        1.0, 1e-9);
    next_event += technique == Technique{1, 2} ? 1 : 0;
  }
  EXPECT_GT(next_event, 50);
}

}  // namespace
}  // namespace ajar
