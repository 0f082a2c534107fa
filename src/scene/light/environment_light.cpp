#include <utility>

#include "scene/light/models.h"

namespace ajar {
namespace {

std::unique_ptr<Light> make_environment(const LightInputs& in) {
  const Spectrum radiance = in.color("radiance");
  const TexelTreatment texels{.nearest = in.node().flag("nearest"),
                              .decoding_exponent = in.decoding_exponent(),
                              .rows_at_edges = in.node().flag("rows_at_poles")};
  if (std::optional<SphereMap> map = in.sphere_map(texels)) {
    const float scale = in.scale_to("irradiance", luminance(map->irradiance()));
    return make_environment_map(radiance * scale, std::move(*map), in.at(), in.bounds());
  }
  return make_constant_environment(radiance * in.scale_to("irradiance", kPi), in.bounds());
}

}  // namespace

LightModel environment_light() {
  return {{.name = "environment",
           .summary = "light from all around, the same or by an image",
           .source = "",
           .parameters = {declare::emission("radiance", "W/(m2 sr)",
                                            "radiance, or factor of the image"),
                          declare::file("image", "all directions, with the pole at z, from above"),
                          sphere_projection_input(), declare::decoding(),
                          declare::flag("nearest",
                                        "take the nearest texel of the image, as of all that are "
                                        "equal_area, and do not interpolate"),
                          declare::flag("rows_at_poles",
                                        "the first and the last row of an image of latitudes are "
                                        "its poles, as in Mitsuba 3, and not half a row away"),
                          declare::target("irradiance", "W/m2",
                                          "if given, what a light of radiance 1 is scaled to: its "
                                          "luminance on a surface that faces z")}},
          make_environment};
}

}  // namespace ajar
