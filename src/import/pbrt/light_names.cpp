#include "import/pbrt/light_names.h"

namespace ajar::pbrt {

// Names and defaults: pbrt-v3, src/lights/*.cpp.
const std::vector<ModelName>& light_names() {
  static const ParameterName kIntensity{"intensity", {"I"}};
  static const ParameterName kRadiance{"radiance", {"L"}};
  static const ParameterName kImage{"image", {"mapname"}};
  static const std::vector<ModelName> kNames = {
      {"point", "point", {kIntensity}},
      // "conedeltaangle" says where the falloff starts, relative to the cone.
      {"spot", "spot", {kIntensity, {"cone_angle", {"coneangle"}}, {"falloff_start", {}}}},
      {"distant", "distant", {{"irradiance", {"L"}}}},
      {"infinite", "environment", {kRadiance, kImage}},
      {"exinfinite", "environment", {kRadiance, kImage}},
      {"goniometric", "goniometric", {kIntensity, kImage}},
      {"projection", "projection", {kIntensity, kImage}}};
  return kNames;
}

const std::vector<ModelName>& emission_names() {
  // "area" is what older files say.
  static const std::vector<ParameterName> kArea = {{"radiance", {"L"}},
                                                   {"two_sided", {"twosided"}}};
  static const std::vector<ModelName> kNames = {{"diffuse", "area", kArea},
                                                {"area", "area", kArea}};
  return kNames;
}

}  // namespace ajar::pbrt
