#include "import/pbrt/texture_names.h"

namespace ajar::pbrt {
namespace {

// Names and defaults: pbrt-v3, src/textures/*.cpp; pbrt-v4, src/pbrt/textures.cpp.

/// `parameters` and those of a mapping to two coordinates.
std::vector<ParameterName> mapped(std::vector<ParameterName> parameters) {
  const std::vector<ParameterName> mapping = {{"scale_u", {"uscale"}},  {"scale_v", {"vscale"}},
                                              {"offset_u", {"udelta"}}, {"offset_v", {"vdelta"}},
                                              {"axis_u", {"v1"}},       {"axis_v", {"v2"}}};
  parameters.insert(parameters.end(), mapping.begin(), mapping.end());
  return parameters;
}

const ParameterName kFirst{"first", {"tex1"}};
const ParameterName kSecond{"second", {"tex2"}};

}  // namespace

const std::vector<ModelName>& texture_names(Dialect dialect) {
  static const std::vector<ModelName> kNames = {
      {"constant", "constant", {}},
      {"scale", "product", {kFirst, kSecond}},
      {"mix", "mix", {kFirst, kSecond}},
      {"bilerp", "bilinear", mapped({})},
      {"imagemap", "image",
       mapped({{"file", {"filename"}}, {"decode_srgb", {"gamma"}}, {"filter", {"ajar:filter"}}})},
      {"uv", "uv", mapped({})},
      {"checkerboard", "checkerboard", mapped({kFirst, kSecond})},
      // With "integer dimension" 3.
      {"checkerboard", "solid_checkerboard", {kFirst, kSecond}},
      {"dots", "dots", mapped({})},
      {"fbm", "fbm", {}},
      {"wrinkled", "wrinkled", {}},
      {"windy", "windy", {}},
      {"marble", "marble", {}}};
  static const std::vector<ModelName> kNamesOfV4 = [] {
    std::vector<ModelName> names = kNames;
    for (ModelName& name : names) {
      // "encoding" and "filter" are read in textures.cpp; a product is of "tex" and a number.
      if (name.theirs == "imagemap") {
        name.parameters = mapped({{"file", {"filename"}},
                                  {"decode_srgb", {}},
                                  {"decoding_exponent", {}},
                                  {"clamp", {}},
                                  {"filter", {}}});
      } else if (name.theirs == "scale") {
        name.parameters = {{"first", {"tex"}}, {"second", {}}};
      }
    }
    names.push_back({"directionmix", "mix", {kFirst, kSecond, {"amount", {}}}});
    return names;
  }();
  return dialect == Dialect::V3 ? kNames : kNamesOfV4;
}

}  // namespace ajar::pbrt
