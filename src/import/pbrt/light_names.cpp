#include "import/pbrt/light_names.h"

namespace ajar::pbrt {

namespace {

// Names and defaults: pbrt-v3, src/lights/*.cpp.
const std::vector<ModelName>& lights_of_v3() {
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

// Names and defaults: pbrt-v4, src/pbrt/lights.cpp. The targets of their scale, "power" and
// "illuminance", are in lights.cpp.
const std::vector<ModelName>& lights_of_v4() {
  static const ParameterName kIntensity{"intensity", {"I"}};
  static const ParameterName kImage{"image", {"filename"}};
  static const ParameterName kSquare{"projection", {}, "equal_area"};
  static const ParameterName kPower{"power", {}};
  static const std::vector<ModelName> kNames = {
      {"point", "point", {kIntensity}},
      {"spot",
       "spot",
       {kIntensity,
        {"cone_angle", {"coneangle"}},
        {"falloff_start", {}},
        {"falloff", {}, "smoothstep"}}},
      {"distant", "distant", {{"irradiance", {"L"}}}},
      {"infinite",
       "environment",
       {{"radiance", {"L"}},
        kImage,
        kSquare,
        {"irradiance", {}},
        {"decoding_exponent", {}},
        {"nearest", {}},
        {"rows_at_poles", {}}}},
      {"goniometric", "goniometric", {kIntensity, kImage, {"gray", {}, "true"}, kSquare, kPower}},
      {"projection", "projection", {{"intensity", {}}, kImage, {"fov", {"fov"}, "90"}, kPower}}};
  return kNames;
}

}  // namespace

const std::vector<ModelName>& light_names(Dialect dialect) {
  return dialect == Dialect::V3 ? lights_of_v3() : lights_of_v4();
}

const std::vector<ModelName>& emission_names(Dialect dialect) {
  // "scale" is a number there.
  static const std::vector<ModelName> kNamesOfV4 = {
      {"diffuse", "area", {{"radiance", {"L"}}, {"two_sided", {"twosided"}}, {"scale", {}}}}};
  if (dialect == Dialect::V4) return kNamesOfV4;
  // "area" is the name in older files.
  static const std::vector<ParameterName> kArea = {{"radiance", {"L"}},
                                                   {"two_sided", {"twosided"}}};
  static const std::vector<ModelName> kNames = {{"diffuse", "area", kArea},
                                                {"area", "area", kArea}};
  return kNames;
}

}  // namespace ajar::pbrt
