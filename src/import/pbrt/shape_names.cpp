#include "import/pbrt/shape_names.h"

namespace ajar::pbrt {

// Names and defaults: pbrt-v3, src/shapes/*.cpp; pbrt-v4, src/pbrt/shapes.cpp, has fewer.
const std::vector<ModelName>& shape_names(Dialect dialect) {
  static const ParameterName kPhiMax{"phi_max", {"phimax"}};
  static const ParameterName kZMin{"z_min", {"zmin"}};
  static const ParameterName kZMax{"z_max", {"zmax"}};
  static const std::vector<ModelName> kNames = {
      {"sphere", "sphere", {kZMin, kZMax, kPhiMax}},
      {"disk", "disk", {{"inner_radius", {"innerradius"}}, kPhiMax}},
      {"cylinder", "cylinder", {kZMin, kZMax, kPhiMax}},
      {"cone", "cone", {kPhiMax}},
      {"paraboloid", "paraboloid", {kZMin, kZMax, kPhiMax}},
      {"hyperboloid", "hyperboloid", {kPhiMax}},
      {"trianglemesh", "mesh", {}},
      {"loopsubdiv", "subdivision", {}},
      {"curve", "curves", {}}};
  static const std::vector<ModelName> kNamesOfV4 = [] {
    std::vector<ModelName> names = kNames;
    std::erase_if(names, [](const ModelName& name) {
      return name.theirs == "cone" || name.theirs == "paraboloid" || name.theirs == "hyperboloid";
    });
    return names;
  }();
  return dialect == Dialect::V3 ? kNames : kNamesOfV4;
}

}  // namespace ajar::pbrt
