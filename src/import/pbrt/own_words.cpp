#include "import/pbrt/own_words.h"

#include <map>
#include <set>

namespace ajar::pbrt {

namespace {

using Words = std::set<std::string_view>;

/// Words of both dialects, by our models. Transforms and meshes, which are written in a way of
/// their own, are included. Source: the file format of pbrt-v3.
const std::map<std::string_view, Words>& words_of_both() {
  static const std::map<std::string_view, Words> kWords = {
      {"projection", {"fov"}},
      {"area", {"scale"}},
      {"sphere", {"radius"}},
      {"disk", {"height", "radius"}},
      {"cylinder", {"radius"}},
      {"cone", {"height", "radius"}},
      {"paraboloid", {"radius"}},
      {"hyperboloid", {"p1", "p2"}},
      {"mesh", {"mesh"}},
      {"subdivision", {"levels", "control"}},
      {"curves", {"type", "curves"}},
      {"constant", {"value"}},
      {"mix", {"amount"}},
      {"bilinear", {"v00", "v01", "v10", "v11", "mapping", "world_to_texture"}},
      {"image", {"wrap", "scale", "mapping", "world_to_texture"}},
      {"uv", {"mapping", "world_to_texture"}},
      {"checkerboard", {"mapping", "world_to_texture"}},
      {"solid_checkerboard", {"world_to_texture"}},
      {"dots", {"inside", "outside", "mapping", "world_to_texture"}},
      {"fbm", {"octaves", "roughness", "world_to_texture"}},
      {"wrinkled", {"octaves", "roughness", "world_to_texture"}},
      {"windy", {"world_to_texture"}},
      {"marble", {"octaves", "roughness", "scale", "variation", "world_to_texture"}},
      {"diffuse", {"sigma"}},
      {"dielectric", {"eta"}},
      {"conductor", {"eta", "k"}},
      {"plastic", {"roughness"}},
      {"composite", {"eta", "opacity"}},
      {"translucent", {"roughness"}},
      {"principled",
       {"metallic", "eta", "roughness", "anisotropic", "sheen", "clearcoat", "flatness", "thin"}}};
  return kWords;
}

}  // namespace

bool is_unknown_to_v3(const desc::Model& model, std::string_view parameter) {
  const auto words = words_of_both().find(model.name);
  return words == words_of_both().end() || !words->second.contains(parameter);
}

}  // namespace ajar::pbrt
