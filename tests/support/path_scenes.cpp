#include "support/path_scenes.h"

#include <map>

#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar::test {
namespace {

const std::string kLamp = R"(AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 7 6]
  Shape "trianglemesh" "point P" [-0.4 1.9 -0.4  0.4 1.9 -0.4  0.4 1.9 0.4  -0.4 1.9 0.4]
    "integer indices" [0 1 2 0 2 3] "normal N" [0 -1 0  0 -1 0  0 -1 0  0 -1 0]
AttributeEnd
)";
const std::string kSmallLamp = R"(AttributeBegin
  AreaLightSource "diffuse" "rgb L" [80 70 60]
  Shape "trianglemesh" "point P" [-0.2 2.2 0  0.1 2.2 0  0.1 2.2 0.3  -0.2 2.2 0.3]
    "integer indices" [0 1 2 0 2 3] "normal N" [0 -1 0  0 -1 0  0 -1 0  0 -1 0]
AttributeEnd
)";
const std::string kFloor = R"(Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
)";

}  // namespace

std::string lamp_over_floor() { return kLamp + kFloor; }

namespace {

/// A lamp over water, seen from above: all that reaches the floor, and all that
/// is seen of it, is refracted once, by a surface whose normals turn, so that
/// no factor of refraction cancels.
std::string pool() {
  return pbrt_scene(
      "LookAt 0 1.6 -3  0 0.4 0.3  0 1 0\nCamera "
      "\"perspective\" \"float fov\" [45]",
      24, 16,
      lamp_over_floor() +
          R"(Shape "trianglemesh" "point P" [-2 0 1.5  2 0 1.5  2 4 1.5  -2 4 1.5] "integer indices" [0 2 1 0 3 2]
Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.5 -2  2 0.5 -2  2 0.6 2  -2 0.4 2] "integer indices" [0 2 1 0 3 2]
  "normal N" [0.2 1 0  -0.2 1 0.1  0.1 1 -0.2  0 1 0.1]
)");
}

/// A lens between a lamp and the floor, another one before the camera. Each shows light through the
/// other.
std::string lenses() {
  return pbrt_scene(
      "LookAt 0 1.2 -3  0 0.1 0.2  0 1 0\nCamera "
      "\"perspective\" \"float fov\" [40]",
      24, 16, R"(
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 7 6]
  Shape "trianglemesh" "point P" [-0.5 2.2 -0.3  0.5 2.2 -0.3  0.5 2.2 0.7  -0.5 2.2 0.7]
    "integer indices" [0 1 2 0 2 3] "normal N" [0 -1 0  0 -1 0  0 -1 0  0 -1 0]
AttributeEnd
)" + kFloor + R"(Material "glass" "float index" [1.3]
AttributeBegin
  Translate 0 1.1 0.2 Scale 0.8 0.3 0.8
  Shape "sphere"
AttributeEnd
AttributeBegin
  Translate 0 0.75 -1.6 Scale 0.7 0.5 0.2
  Shape "sphere"
AttributeEnd
)");
}

/// Light of a lamp through a strong lens, which shines on nothing else: only its direction tells it
/// from other light, in a spot that is bright in places.
const std::string kSpotOnGlass = R"(
LightSource "spot" "point from" [0.1 2.3 0.2] "point to" [0 1.1 0.1] "rgb I" [8 7 6]
  "float coneangle" [22] "float conedeltaangle" [2]
)";
std::string burning_glass(const std::string& lamp,
                          const std::string& camera = "\"perspective\" \"float fov\" [24]") {
  return pbrt_scene("LookAt 0 0.7 -2  0.15 0 0.1  0 1 0\nCamera " + camera, 24, 16,
                    lamp + kFloor + R"(Material "glass" "float index" [1.5]
Translate 0 1.1 0.1 Scale 0.5 0.3 0.5
Shape "sphere"
)");
}

std::string burning_glass_in_fog() {
  return R"(
MakeNamedMedium "fog" "string type" "homogeneous" "rgb sigma_a" [0.05 0.1 0.1]
  "rgb sigma_s" [0.06 0.04 0.08] "float g" [0.4]
MediumInterface "" "fog"
)" + burning_glass("MediumInterface \"fog\" \"fog\"\n" + kSpotOnGlass);
}

/// Water and lenses that are placed twice: by the object's transformation, and by the instance's.
std::string instances() {
  return pbrt_scene("LookAt 0 1.6 -3  0 0.4 0.3  0 1 0\nCamera \"perspective\" \"float fov\" [40]",
                    24, 16, lamp_over_floor() + R"(ObjectBegin "water"
  Material "glass" "float index" [1.33]
  Translate 0 0.2 0
  Shape "trianglemesh" "point P" [-1 0.1 -1  1 0.1 -1  1 0.2 1  -1 0 1] "integer indices" [0 2 1 0 3 2]
    "normal N" [0.2 1 0  -0.2 1 0.1  0.1 1 -0.2  0 1 0.1]
ObjectEnd
ObjectBegin "lens"
  Material "glass" "float index" [1.3]
  Scale 1 0.5 1
  Shape "sphere" "float radius" [0.4]
ObjectEnd
AttributeBegin Scale 2 1 1 Translate 0 0 -1 ObjectInstance "water" AttributeEnd
AttributeBegin Rotate 20 0 1 0 Scale 1 1.2 1 Translate 0 0 1.2 ObjectInstance "water" AttributeEnd
AttributeBegin Translate -0.5 1 0.2 Rotate 30 1 0 1 ObjectInstance "lens" AttributeEnd
AttributeBegin Translate 0.6 0.9 0.3 Scale 0.6 1.4 0.8 ObjectInstance "lens" AttributeEnd
)");
}

/// A lamp, a floor and water on which light and looks all but glide.
std::string grazing() {
  return pbrt_scene("LookAt 0 0.23 -3  0 0.05 0  0 1 0\nCamera \"perspective\" \"float fov\" [20]",
                    24, 16, R"(
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 7 6] "bool twosided" "true"
  Shape "trianglemesh" "point P" [-2.2 0.2 -1  -2.2 0.2 1  -2.2 0.5 1  -2.2 0.5 -1]
    "integer indices" [0 2 1 0 3 2]
AttributeEnd
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Shape "trianglemesh" "point P" [-2 0 -4  2 0 -4  2 0 3  -2 0 3] "integer indices" [0 2 1 0 3 2]
Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.1 -4  2 0.1 -4  2 0.1 3  -2 0.1 3] "integer indices" [0 2 1 0 3 2]
  "normal N" [0.01 1 0  -0.01 1 0.01  0.01 1 -0.01  0 1 0.01]
Material "metal" "float roughness" [0.05] "bool remaproughness" "false"
Translate 0.4 0.2 0.3 Scale 0.2 0.2 0.2
Shape "sphere"
)");
}

/// Reliefs on all that scatters: on a floor, a ball of brushed metal, and glass, smooth and
/// frosted.
std::string bumps_and_normal_maps() {
  return pbrt_scene(
      "LookAt 0 1.1 -2.4  0 0.3 0.2  0 1 0\nCamera \"perspective\" \"float fov\" [38]", 24, 16,
      R"(
Texture "waves" "float" "wrinkled" "integer octaves" [2]
Texture "low" "float" "scale" "texture tex1" "waves" "float tex2" [0.02]
Texture "tilts" "color" "checkerboard" "float uscale" [6] "float vscale" [6]
  "rgb tex1" [0.6 0.5 0.9] "rgb tex2" [0.45 0.58 0.95]
)" + kSmallLamp +
          R"(Material "matte" "rgb Kd" [0.7 0.6 0.5] "texture bumpmap" "low"
Shape "trianglemesh" "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2] "integer indices" [0 2 1 0 3 2]
  "float uv" [0 0  1 0  1 1  0 1]
AttributeBegin
  Material "glass" "float index" [1.3] "texture normal_map" "tilts"
  Translate -0.5 0.9 0.2 Scale 0.4 0.25 0.4
  Shape "sphere"
AttributeEnd
AttributeBegin
  Material "glass" "float index" [1.3] "float uroughness" [0.15] "float vroughness" [0.15]
    "bool remaproughness" "false" "texture bumpmap" "low"
  Translate 0.3 1 0.1 Scale 0.3 0.2 0.3
  Shape "sphere"
AttributeEnd
Material "metal" "float uroughness" [0.2] "float vroughness" [0.1] "bool remaproughness" "false"
  "texture normal_map" "tilts"
Translate 0.5 0.4 0.3 Scale 0.4 0.4 0.4
Shape "sphere"
)");
}

/// A ball of frosted glass between a small lamp and the floor, and a brushed metal ball, in which
/// that is seen.
std::string gloss() {
  return pbrt_scene(
      "LookAt 0 1.1 -2.4  0 0.3 0.2  0 1 0\nCamera "
      "\"perspective\" \"float fov\" [38]",
      24, 16, kSmallLamp + kFloor + R"(AttributeBegin
  Material "glass" "float index" [1.3] "float uroughness" [0.12] "float vroughness" [0.12]
    "bool remaproughness" "false"
  Translate -0.2 1 0.2 Scale 0.5 0.3 0.5
  Shape "sphere"
AttributeEnd
Material "metal" "float uroughness" [0.2] "float vroughness" [0.1] "bool remaproughness" "false"
Translate 0.5 0.4 0.3 Scale 0.4 0.4 0.4
Shape "sphere"
)");
}

/// A ball of rough metal throws the light of a spot on a floor under water, whose surface refracts
/// it smoothly, as it does the view.
std::string gloss_over_water() {
  return pbrt_scene("LookAt 0 1.5 -0.6  0 0 0.1  0 1 0\nCamera \"perspective\" \"float fov\" [60]",
                    24, 16, R"(
LightSource "spot" "point from" [0.9 0.5 -0.4] "point to" [0 0.6 0.1] "rgb I" [8 7 6]
  "float coneangle" [15] "float conedeltaangle" [2]
)" + kFloor + R"(Material "glass" "float index" [1.33]
Shape "trianglemesh" "point P" [-2 0.1 -2  2 0.1 -2  2 0.1 2  -2 0.1 2] "integer indices" [0 2 1 0 3 2]
  "normal N" [0.2 1 0  -0.2 1 0.1  0.1 1 -0.2  0 1 0.1]
Material "metal" "float roughness" [0.25] "bool remaproughness" "false"
Translate 0 0.6 0.1 Scale 0.3 0.3 0.3
Shape "sphere"
)");
}

/// Frosted glass in the sun, seen by a lens.
std::string gloss_in_the_sun() {
  return pbrt_scene(
      "LookAt 0 0.9 -2  0.15 0 0.1  0 1 0\nCamera \"perspective\" \"float fov\" [30] "
      "\"float lensradius\" [0.02] \"float focaldistance\" [2.2]",
      24, 16,
      R"(
LightSource "distant" "point from" [0.3 1 0.1] "point to" [0 0 0]
)" + kFloor +
          R"(Material "glass" "float index" [1.5] "float uroughness" [0.1] "float vroughness" [0.1]
  "bool remaproughness" "false"
Translate 0 1.1 0.1 Scale 0.5 0.3 0.5
Shape "sphere"
)");
}

}  // namespace

std::string path_scene(const std::string& name) {
  static const std::map<std::string, std::string> kScenes = {
      {"BumpsAndNormalMaps", bumps_and_normal_maps()},
      {"BurningGlass", burning_glass(kSpotOnGlass)},
      {"BurningGlassByALens",
       burning_glass(kSpotOnGlass,
                     "\"perspective\" \"float fov\" [24] \"float lensradius\" [0.03] "
                     "\"float focaldistance\" [2]")},
      {"BurningGlassInFog", burning_glass_in_fog()},
      {"BurningGlassInTheSun",
       burning_glass(
           "LightSource \"distant\" \"point from\" [0.05 1 0.05] \"point to\" [0 0 0]\n")},
      {"BurningGlassOrthographic",
       burning_glass(kSpotOnGlass,
                     "\"orthographic\" \"float screenwindow\" [-0.45 0.45 -0.3 0.3]")},
      {"BurningGlassUnderASky", burning_glass("LightSource \"infinite\" \"rgb L\" [1 1.2 1.5]\n")},
      {"Gloss", gloss()},
      {"GlossInTheSun", gloss_in_the_sun()},
      {"GlossOverWater", gloss_over_water()},
      {"Grazing", grazing()},
      {"Instances", instances()},
      {"Lenses", lenses()},
      {"Pool", pool()}};
  const auto found = kScenes.find(name);
  return found == kScenes.end() ? small_scene(name).text : found->second;
}

}  // namespace ajar::test
