#include "integrator/montecarlo/sample_sink.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

constexpr Vec2i kSinkSize{4, 4};
const Box2i kSinkCrop({0, 0}, {3, 3});

/// Light of a long path that a camera subpath has found in the middle of a pixel.
Contribution long_path(float light) {
  return {.value = Spectrum(light), .technique = {1, 3}, .mis_weight = 1.0};
}

/// Light that roulette learns of a path that chains make half of.
double brought(bool learns_from_all) {
  constexpr float kSinkThreshold = 2.F;
  Film film(kSinkSize, kSinkCrop, Filter::box(), 1, light_layers(1.0));
  const ImportanceMap importance(kSinkCrop, std::vector<float>(16, 1.F));
  const Divisions divisions(Division(kSinkThreshold, importance));
  Counters counters;
  const GBuffer g_buffer(film);
  const TechniqueLayers techniques(film);
  SampleSink sink(film, &divisions, nullptr, 1.0, g_buffer, techniques, 0, counters);
  if (learns_from_all) sink.learn_from_all();
  sink.begin_pixel({1, 1}, 0);
  sink.begin_sample({1.5F, 1.5F}, 1.F, 0);
  sink.add(long_path(kSinkThreshold));
  return sink.brought();
}

/// Rays bring all of their light as long as nobody knows whether chains pay.
TEST(SampleSink, TellsRouletteOfItsOwnLightOrOfAll) {
  EXPECT_NEAR(brought(false), 1.0, 1e-5);
  EXPECT_NEAR(brought(true), 2.0, 1e-5);
}

}  // namespace
}  // namespace ajar
