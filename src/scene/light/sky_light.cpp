// The clear sky as a map of all directions: a sky has no detail that a texel of 0.7 degrees lacks,
// and a map can be sampled.
#include <utility>

#include "color/daylight.h"
#include "scene/light/models.h"

namespace ajar {
namespace {

constexpr int kWidth = 512;
constexpr int kHeight = 256;

/// Radiance 1 for 1 kcd/m²; black below the horizon.
Map sky_map(double turbidity, double elevation, const SphereProjection& projection) {
  const SunnySky sky(turbidity, elevation);
  std::vector<Spectrum> texels(static_cast<std::size_t>(kWidth) * kHeight, Spectrum(0.F));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vec3d w(projection.to_direction(
          Vec2((static_cast<float>(x) + 0.5F) / kWidth, (static_cast<float>(y) + 0.5F) / kHeight)));
      const Vec3 color(sky.color(w));
      texels[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] =
          Spectrum(color.x, color.y, color.z);
    }
  }
  return {kWidth, kHeight, std::move(texels), projection.edge, projection.filter};
}

std::unique_ptr<Light> make_sky(const LightInputs& in) {
  const SphereProjection& projection = sphere_projection("longitude_latitude");
  const desc::Node& node = in.node();
  SphereMap map(sky_map(node.number("turbidity"), node.number("elevation"), projection),
                projection);
  return make_environment_map(Spectrum(node.number("scale")), std::move(map), in.at(), in.bounds());
}

ParameterSpec within(ParameterSpec spec, double minimum, double maximum) {
  spec.minimum = minimum;
  spec.maximum = maximum;
  return spec;
}

}  // namespace

LightModel sky_light() {
  return {{.name = "sky",
           .summary = "the clear sky without its sun, which is over x; up is z",
           .source = "Preetham et al. 1999",
           .parameters =
               {within(declare::number("turbidity", "3", "haze: from clear to fog"), 2.0, 10.0),
                within(declare::number("elevation", "45", "of the sun over the horizon", "degrees"),
                       0.0, 90.0),
                within(declare::number("scale", "1", "radiance for 1 kcd/m2", "W/(m2 sr)"), 0.0,
                       1e30)}},
          make_sky};
}

}  // namespace ajar
