#include "import/pbrt/own_words.h"

#include <set>

namespace ajar::pbrt {

bool is_unknown_to_v3(const desc::Model& model, std::string_view parameter) {
  static const std::set<std::string_view> kUnknown = {"along_normal",
                                                      "between_facets",
                                                      "bounces",
                                                      "channel",
                                                      "clamp",
                                                      "coat",
                                                      "coat_depth",
                                                      "coat_reflectance",
                                                      "coat_roughness",
                                                      "coordinates",
                                                      "decoding_exponent",
                                                      "distribution",
                                                      "falloff",
                                                      "gray",
                                                      "inner_reflections",
                                                      "invert",
                                                      "irradiance",
                                                      "masking",
                                                      "nearest",
                                                      "polarised",
                                                      "power",
                                                      "projection",
                                                      "reflectance",
                                                      "rotation",
                                                      "sheet",
                                                      "specular_strength",
                                                      "blend"};
  if (parameter == "thin") return model.name == "dielectric";
  if (parameter == "eta") return model.name == "coated_diffuse";
  if (parameter == "height") {  // of a cylindrical mapping; cones and disks have one, too
    return model.name != "cone" && model.name != "disk";
  }
  return kUnknown.contains(parameter);
}

}  // namespace ajar::pbrt
