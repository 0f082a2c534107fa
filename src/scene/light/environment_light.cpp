#include <utility>

#include "scene/light/models.h"

namespace ajar {
namespace {

std::unique_ptr<Light> make_environment(const LightInputs& in) {
  const Spectrum radiance = in.color("radiance");
  if (std::optional<Map> map = in.map("image", MapEdge::Repeat)) {
    return make_environment_map(radiance, std::move(*map), in.at(), in.bounds());
  }
  return make_constant_environment(radiance, in.bounds());
}

}  // namespace

LightModel environment_light() {
  return {{.name = "environment",
           .summary = "light from all around, the same or by an image",
           .source = "",
           .parameters = {declare::emission("radiance", "W/(m2 sr)",
                                            "radiance, or factor of the image"),
                          declare::file("image",
                                        "longitude by latitude, with the pole at z, from above")}},
          make_environment};
}

}  // namespace ajar
