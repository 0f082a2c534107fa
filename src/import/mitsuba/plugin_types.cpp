#include "import/mitsuba/plugin_types.h"

#include <algorithm>
#include <map>

#include "core/printable_text.h"
#include "import/mitsuba/material_plugins.h"
#include "import/mitsuba/sensor.h"
#include "import/mitsuba/spectrum_plugins.h"

namespace ajar::mitsuba {
namespace {

using Types = std::vector<std::string>;

std::map<std::string_view, Types> all_types() {
  std::map<std::string_view, Types> types = {
      {"emitter",
       {"area", "constant", "envmap", "point", "spot", "directional", "projector", "collimated",
        "sky", "sun", "sunsky"}},
      {"film", {"hdrfilm", "ldrfilm", "tiledhdrfilm", "specfilm", "mfilm"}},
      {"medium", {"homogeneous", "heterogeneous"}},
      {"phase", {"isotropic", "hg"}},
      {"rfilter", {"box", "tent", "gaussian", "mitchell", "catmullrom", "lanczos"}},
      {"sampler",
       {"independent", "stratified", "ldsampler", "halton", "hammersley", "sobol", "multijitter",
        "orthogonal"}},
      {"sensor", {"perspective", "thinlens", "orthographic", "telecentric", "spherical"}},
      {"shape",
       {"obj", "ply", "serialized", "rectangle", "cube", "sphere", "disk", "cylinder", "hair",
        "linearcurve", "bsplinecurve", "instance", "shapegroup", "merge"}},
      {"texture", {"bitmap", "checkerboard", "scale"}},
      {"volume", {"gridvolume", "grid", "constvolume", "uniform", "srgb", "volcache"}}};
  for (const std::string_view type : spectrum_types()) types["texture"].emplace_back(type);
  for (const MaterialPlugin& plugin : material_plugins()) types["bsdf"].emplace_back(plugin.type);
  for (const IntegratorName& name : integrator_names())
    types["integrator"].emplace_back(name.theirs);
  return types;
}

}  // namespace

const std::vector<std::string>& plugin_types(std::string_view tag) {
  static const std::map<std::string_view, Types> kTypes = all_types();
  static const Types kNone;
  const auto found = kTypes.find(tag);
  return found == kTypes.end() ? kNone : found->second;
}

bool is_known(const Element& element) {
  const Types& types = plugin_types(element.tag);
  return std::find(types.begin(), types.end(), element.type) != types.end();
}

std::string unknown_type_message(const Element& element) {
  return unknown_name_message(element.tag, printable(element.type), plugin_types(element.tag));
}

}  // namespace ajar::mitsuba
