// Every material of every format where all that shines has the radiance 1: nothing is brighter,
// from outside, from behind and after a hundred bounces. A new material is a row.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "import/import.h"
#include "import/testing/temporary_folder.h"
#include "scene/desc/models.h"
#include "scene/material/registry.h"
#include "support/render.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

/// A material as a format writes it, with `'` for `"`.
struct FurnaceRow {
  std::string material;
  /// Declares whether both sides look the same.
  enum class Sides { Differ, Alike } sides = Sides::Differ;
  /// The most that a ball of it shows. Above 1, the material gains energy in its own renderer, so
  /// that closed rooms of it have no end.
  double most = 1.0;
};

/// Mean over some pixels, and its standard error from replicates.
struct FurnaceMean {
  double mean = 0.0;
  double error = 0.0;
};
FurnaceMean mean_of_parts(const std::vector<double>& parts) {
  const auto count = static_cast<double>(parts.size());
  FurnaceMean result;
  for (const double part : parts) result.mean += part / count;
  for (const double part : parts) {
    result.error += (part - result.mean) * (part - result.mean) / (count * (count - 1.0));
  }
  result.error = std::sqrt(result.error);
  return result;
}

/// The material of the first shape, on a sphere of radius 1 around the origin.
desc::SceneDesc ball_of(const desc::SceneDesc& imported, bool from_behind) {
  desc::SceneDesc scene = imported;
  desc::Shape shape =
      !imported.shapes.empty() ? imported.shapes.front() : imported.objects.at(0).shapes.at(0);
  shape.node = desc::shape_node("sphere");
  shape.to_world = Mat4();
  shape.reverse_orientation = from_behind;
  shape.emission.reset();
  scene.shapes = {shape};
  scene.objects.clear();
  scene.instances.clear();
  scene.lights.clear();
  scene.film = {};
  return scene;
}

desc::PerspectiveCamera lens(float fov) {
  desc::PerspectiveCamera camera;
  camera.fov = fov;
  return camera;
}

constexpr int kFurnacePixels = 16;
constexpr float kBallDistance = 5.F;

test::Render render_furnace(desc::SceneDesc scene, int pixels, int samples,
                            const std::string& what) {
  Warnings warnings;
  const Scene built(std::move(scene), BuildOptions{Vec2i(pixels)}, warnings);
  test::RenderOptions options;
  options.samples = samples;
  test::Render result = test::render(built, options);
  EXPECT_EQ(result.counters.first_discarded, "") << what;
  return result;
}

/// A ball that fills the picture, in an environment of radiance 1: its middle, the ring around it,
/// and its edge.
using Zones = std::array<FurnaceMean, 3>;
Zones ball(const desc::SceneDesc& imported, bool from_behind, const std::string& what,
           int samples = 32) {
  desc::SceneDesc scene = ball_of(imported, from_behind);
  scene.lights.emplace_back().node = desc::light_node("environment", {{"radiance", Vec3(1.F)}});
  scene.camera.to_world = Mat4();
  scene.camera.to_world[3][2] = -kBallDistance;
  const float fov = 2.F * std::asin(1.F / kBallDistance) * 180.F / std::numbers::pi_v<float>;
  scene.camera.node = lens(fov);
  const test::Render picture = render_furnace(std::move(scene), kFurnacePixels, samples, what);
  Zones zones;
  constexpr std::array<std::pair<double, double>, 3> kRadii{{{0.0, 0.5}, {0.5, 0.8}, {0.8, 0.91}}};
  for (std::size_t zone = 0; zone < zones.size(); ++zone) {
    const auto [inner, outer] = kRadii[zone];
    std::vector<double> parts;
    for (int r = 0; r < picture.film->replicates(); ++r) {
      const std::vector<float> pixels = picture.replicate(r);
      double sum = 0.0;
      int count = 0;
      for (int y = 0; y < kFurnacePixels; ++y) {
        for (int x = 0; x < kFurnacePixels; ++x) {
          const double half = kFurnacePixels / 2.0;
          const double radius = std::hypot(x + 0.5 - half, y + 0.5 - half) / half;
          if (radius < inner || radius > outer) continue;
          for (int lane = 0; lane < 3; ++lane) {
            sum += static_cast<double>(
                pixels[static_cast<std::size_t>(3 * (y * kFurnacePixels + x) + lane)]);
            ++count;
          }
        }
      }
      parts.push_back(sum / count);
    }
    zones[zone] = mean_of_parts(parts);
  }
  return zones;
}

/// From the middle of a closed room whose walls shine a hundredth: a hundred bounces that gain
/// nothing are no more than 1.
FurnaceMean room(const desc::SceneDesc& imported, bool from_behind, const std::string& what) {
  desc::SceneDesc scene = ball_of(imported, !from_behind);
  scene.shapes[0].emission = desc::Emission{
      {}, desc::emission_node("area", {{"radiance", Vec3(0.01F)}, {"two_sided", true}})};
  scene.camera.to_world = Mat4();
  scene.camera.node = lens(90.F);
  const test::Render picture = render_furnace(std::move(scene), 8, 8, what);
  std::vector<double> parts;
  for (int r = 0; r < picture.film->replicates(); ++r) {
    double sum = 0.0;
    const std::vector<float> pixels = picture.replicate(r);
    for (const float value : pixels) sum += static_cast<double>(value);
    parts.push_back(sum / static_cast<double>(pixels.size()));
  }
  return mean_of_parts(parts);
}

constexpr double kPower = 0.25;  ///< power: a gain of this much is noticed
/// For comparisons with a number: a hundredth is noticed.
constexpr int kManySamples = 512;

void expect_same(const FurnaceMean& seen, const FurnaceMean& expected, const std::string& what) {
  EXPECT_NEAR(seen.mean, expected.mean,
              5.0 * std::hypot(seen.error, expected.error) + 0.004 * expected.mean)
      << what;
}

void expect_at_most(const Zones& zones, double most, const std::string& what) {
  for (const FurnaceMean& zone : zones) {
    EXPECT_LE(zone.mean, most + 5.0 * zone.error + 0.004) << what;
    EXPECT_LE(5.0 * zone.error, kPower * most) << what << ": too noisy";
  }
}

void expect_no_gain(const desc::SceneDesc& imported, const FurnaceRow& row) {
  std::array<Zones, 2> balls;
  std::array<FurnaceMean, 2> rooms;
  for (const bool from_behind : {false, true}) {
    const std::string what = row.material + (from_behind ? ", from behind" : ", from the front");
    balls[from_behind] = ball(imported, from_behind, what);
    expect_at_most(balls[from_behind], row.most, what);
    if (row.most > 1.0) continue;
    rooms[from_behind] = room(imported, from_behind, what);
    EXPECT_LE(rooms[from_behind].mean, 1.0 + 5.0 * rooms[from_behind].error + 0.004)
        << "room of " << what;
  }
  if (row.sides != FurnaceRow::Sides::Alike) return;
  expect_same(rooms[1], rooms[0], "room of " + row.material);
  for (std::size_t zone = 0; zone < balls[0].size(); ++zone) {
    expect_same(balls[1][zone], balls[0][zone], row.material);
  }
}

/// Text of a scene file; `write` puts one together and returns its name.
template <typename Write>
desc::SceneDesc imported(const std::string& material, const Write& write) {
  const TemporaryFolder folder;
  const auto put = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name) << test::with_quotes(text);
    return (folder.path() / name).string();
  };
  Warnings warnings;
  return import_scene(write(material, put), warnings);
}

template <typename Write>
void expect_no_gain(const std::vector<FurnaceRow>& rows, const Write& write) {
  for (const FurnaceRow& row : rows) {
    SCOPED_TRACE(row.material);
    expect_no_gain(imported(row.material, write), row);
  }
}
constexpr FurnaceRow::Sides kAlike = FurnaceRow::Sides::Alike;

/// A default model, and each of its choices, flags and bounded numbers by itself at either end.
std::vector<std::pair<std::string, desc::Node>> nodes_of(const desc::Model& model) {
  std::vector<std::pair<std::string, desc::Node>> nodes;
  const desc::Node plain = desc::material_node(model.name);
  nodes.emplace_back(model.name, plain);
  const auto with = [&](ParameterSpec spec, const std::string& value) {
    spec.default_value = value;
    desc::Node node = plain;
    node.set(spec.name, desc::default_value(spec));
    if (node.get(spec.name) == plain.get(spec.name)) return;
    nodes.emplace_back(model.name + ", " + spec.name + " " + value, node);
  };
  for (const ParameterSpec& spec : model.parameters) {
    constexpr double kLargest = 1e3;
    if (spec.type == ParameterType::Bool) with(spec, "true");
    for (const std::string& choice : spec.choices) {
      if (spec.type == ParameterType::Choice) with(spec, choice);
    }
    if (spec.type == ParameterType::Float && spec.maximum < kLargest) {
      for (const double value : {spec.minimum, spec.maximum}) {
        if (!(value > -kLargest)) continue;
        if (in_range(spec, value)) with(spec, std::to_string(value));
      }
    }
  }
  return nodes;
}

TEST(MaterialFurnace, ModelsOfTheRegistry) {
  for (const MaterialModel& model : material_models()) {
    if (model.model.name == "mix") continue;  // made of others, which the formats have
    for (const auto& [name, node] : nodes_of(model.model)) {
      SCOPED_TRACE(name);
      desc::SceneDesc scene;
      scene.materials.emplace_back().node = node;
      scene.shapes.emplace_back().material = 0;
      // Burley's diffuse light is beside the gloss, in addition to its reflection.
      const double most = name == "principled, eta 20.000000" ? 1.3 : 1.0;
      for (const bool from_behind : {false, true}) {
        expect_at_most(ball(scene, from_behind, name), most, name);
      }
    }
  }
}

/// Materials that a row may name: two.
const char* const kPbrtParts =
    "MakeNamedMaterial 'red' 'string type' 'matte' 'rgb Kd' [1 0.5 0]\n"
    "MakeNamedMaterial 'clear' 'string type' 'glass'\n";

TEST(MaterialFurnace, Pbrt3) {
  const std::string white = " 'rgb Kd' [1 1 1]";
  const std::string disney = "Material 'disney' 'rgb color' [0.8 0.8 0.8] 'float roughness' ";
  expect_no_gain({{"Material 'matte'" + white},
                  {"Material 'matte' 'float sigma' 30" + white},
                  {"Material 'mirror' 'rgb Kr' [1 1 1]"},
                  {"Material 'glass'"},
                  {"Material 'glass' 'float uroughness' 0.3 'float vroughness' 0.3"},
                  {"Material 'metal'"},
                  {"Material 'plastic'"},
                  {"Material 'substrate'"},
                  {"Material 'uber' 'rgb opacity' [0.5 0.5 0.5]"},
                  {"Material 'translucent'"},
                  {disney + "1"},
                  {disney + "0.3"},
                  {disney + "0.5 'float metallic' 0.5"},
                  {disney + "0.3 'float spectrans' 0.5"},
                  {disney + "0.3 'float spectrans' 0.1"},
                  {disney + "0.3 'float spectrans' 0.9 'float clearcoat' 1"},
                  {disney + "0.3 'float spectrans' 0.5 'float metallic' 0.5"},
                  {disney + "0.3 'float eta' 1 'float spectrans' 0.5"},
                  {disney + "0.5 'bool thin' 'true' 'float difftrans' 1 'float flatness' 0.5"},
                  {disney + "0.5 'bool thin' 'true' 'float metallic' 1"},
                  {"Material 'mix' 'string namedmaterial1' 'red' 'string namedmaterial2' 'clear'"},
                  {"Material 'none'"}},
                 [](const std::string& material, const auto& put) {
                   return put("ball.pbrt", std::string("Camera 'perspective'\nWorldBegin\n") +
                                               kPbrtParts + material +
                                               "\nShape 'sphere'\nWorldEnd\n");
                 });
}

TEST(MaterialFurnace, Pbrt4) {
  const std::string white = " 'rgb reflectance' [1 1 1]";
  expect_no_gain({{"Material 'diffuse'" + white},
                  {"Material 'conductor' 'float roughness' 0.3"},
                  {"Material 'dielectric'"},
                  {"Material 'dielectric' 'float roughness' 0.3"},
                  {"Material 'thindielectric'"},
                  {"Material 'coateddiffuse'" + white},
                  {"Material 'coateddiffuse' 'float roughness' 0.5" + white},
                  {"Material 'coatedconductor' 'float conductor.roughness' 0.3"},
                  {"Material 'diffusetransmission' 'rgb reflectance' [0.5 0.5 0.5] 'rgb "
                   "transmittance' [0.5 0.5 0.5]"},
                  {"MakeNamedMaterial 'a' 'string type' 'conductor'\nMakeNamedMaterial 'b' 'string "
                   "type' 'dielectric'\nMaterial 'mix' 'string materials' ['a' 'b']"},
                  {"Material 'interface'"}},
                 [](const std::string& material, const auto& put) {
                   return put("ball.pbrt", "Film 'rgb'\nCamera 'perspective'\nWorldBegin\n" +
                                               material + "\nShape 'sphere'\n");
                 });
}

const auto write_mitsuba_ball = [](const std::string& material, const auto& put) {
  return put("ball.xml",
             "<scene version='3.0.0'><sensor type='perspective'/><shape type='sphere'>" + material +
                 "</shape></scene>");
};

TEST(MaterialFurnace, Mitsuba) {
  const auto number = [](const std::string& name, const std::string& value) {
    return "<float name='" + name + "' value='" + value + "'/>";
  };
  const auto color = [](const std::string& name, const std::string& value) {
    return "<rgb name='" + name + "' value='" + value + "'/>";
  };
  const auto bsdf = [](const std::string& type, const std::string& inside = "") {
    return "<bsdf type='" + type + "'>" + inside + "</bsdf>";
  };
  const auto principled = [&](const std::string& inside) {
    return bsdf("principled", color("base_color", "0.8") + inside);
  };
  const auto thin = [&](const std::string& inside) {
    return bsdf("principledthin", color("base_color", "0.8") + inside);
  };
  const std::string white = color("reflectance", "1");
  const std::string matte = bsdf("diffuse", white);
  expect_no_gain({{matte},
                  {bsdf("twosided", matte)},
                  {bsdf("roughdiffuse", white)},
                  {bsdf("difftrans", color("transmittance", "1"))},
                  {bsdf("dielectric")},
                  {bsdf("thindielectric")},
                  {bsdf("roughdielectric", number("alpha", "0.3"))},
                  {bsdf("conductor")},
                  {bsdf("roughconductor", number("alpha", "0.3"))},
                  {bsdf("plastic", color("diffuse_reflectance", "0.8"))},
                  {bsdf("roughplastic", color("diffuse_reflectance", "0.8"))},
                  {bsdf("coating", matte)},
                  {bsdf("roughcoating", matte)},
                  {bsdf("phong")},
                  {bsdf("ward")},
                  {bsdf("mask", number("opacity", "0.5") + matte)},
                  {bsdf("blendbsdf", number("weight", "0.5") + matte + bsdf("dielectric"))},
                  {bsdf("mixturebsdf", "<string name='weights' value='0.5 0.5'/>" + matte + matte)},
                  {bsdf("null")},
                  {principled(number("roughness", "1")), kAlike},
                  {bsdf("twosided", principled(number("metallic", "0.5"))), kAlike},
                  {principled(number("spec_trans", "0.5"))},
                  {principled(number("spec_trans", "0.1") + number("roughness", "0.2"))},
                  {principled(number("spec_trans", "0.5") + number("metallic", "0.5"))},
                  {principled(number("spec_trans", "0.9") + number("clearcoat", "1"))},
                  {principled(number("spec_trans", "0.5") + number("spec_tint", "1"))},
                  {principled(number("flatness", "0.5"))},
                  {thin(number("diff_trans", "1")), kAlike},
                  {thin(number("spec_trans", "0.5") + number("diff_trans", "0.6")), kAlike}},
                 write_mitsuba_ball);
}

TEST(MaterialFurnace, PrincipledMatchesMitsuba) {
  // Numbers by Mitsuba 3.9.
  struct Known {
    const char* base;
    std::vector<std::pair<const char*, const char*>> numbers;
    std::array<double, 3> zones;
  };
  const std::vector<Known> known{
      {"0.8", {{"spec_trans", "0.5"}, {"roughness", "0.3"}}, {0.6229, 0.6211, 0.6221}},
      {"0.8", {{"spec_trans", "0.1"}, {"roughness", "0.2"}}, {0.7591, 0.7675, 0.8002}},
      {"0.8", {{"spec_trans", "0.5"}, {"metallic", "0.5"}}, {0.6238, 0.6133, 0.6023}},
      {"0.8", {{"spec_trans", "0.5"}, {"spec_tint", "1"}}, {0.6019, 0.5794, 0.5584}},
      {"1", {{"roughness", "1"}}, {1.0487, 1.0502, 1.0783}},
      {"1", {{"roughness", "0.5"}}, {1.0416, 1.0497, 1.0715}}};
  for (const Known& row : known) {
    std::string material =
        "<bsdf type='principled'><rgb name='base_color' value='" + std::string(row.base) + "'/>";
    for (const auto& [name, value] : row.numbers) {
      material += "<float name='" + std::string(name) + "' value='" + value + "'/>";
    }
    const Zones zones =
        ball(imported(material + "</bsdf>", write_mitsuba_ball), false, material, kManySamples);
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
      EXPECT_NEAR(zones[zone].mean, row.zones[zone], 5.0 * zones[zone].error + 0.004)
          << material << ' ' << zone;
    }
  }
}

TEST(MaterialFurnace, Tungsten) {
  const std::string white = ", 'albedo': 1";
  const std::string matte = "{'type': 'lambert', 'albedo': 1}";
  expect_no_gain({{"'type': 'lambert'" + white},
                  {"'type': 'oren_nayar', 'roughness': 1" + white},
                  {"'type': 'diffuse_transmission', 'transmittance': 0.5" + white},
                  {"'type': 'mirror'" + white},
                  {"'type': 'conductor', 'material': 'Ag'"},
                  {"'type': 'rough_conductor', 'material': 'Ag', 'roughness': 0.3"},
                  {"'type': 'dielectric', 'ior': 1.5"},
                  {"'type': 'rough_dielectric', 'ior': 1.5, 'roughness': 0.3"},
                  {"'type': 'thinsheet', 'ior': 1.5"},
                  {"'type': 'plastic', 'ior': 1.5, 'albedo': 0.8"},
                  {"'type': 'rough_plastic', 'ior': 1.5, 'roughness': 0.3, 'albedo': 0.8"},
                  {"'type': 'smooth_coat', 'ior': 1.5, 'substrate': " + matte},
                  {"'type': 'rough_coat', 'ior': 1.5, 'roughness': 0.3, 'substrate': " + matte},
                  {"'type': 'transparency', 'alpha': 0.5, 'base': " + matte},
                  {"'type': 'mixed', 'ratio': 0.5, 'bsdf0': " + matte +
                   ", 'bsdf1': {'type': 'dielectric', 'ior': 1.5}"},
                  {"'type': 'phong', 'exponent': 20, 'albedo': 0.8"},
                  {"'type': 'null'"},
                  {"'type': 'forward'"}},
                 [](const std::string& material, const auto& put) {
                   return put("ball.json",
                              "{'camera': {'type': 'pinhole'}, 'primitives': "
                              "[{'type': 'sphere', 'bsdf': {" +
                                  material + "}}]}");
                 });
}

const std::string kTriangle =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
const std::string kTwoGreys =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR4nGMwNjY+c+YMAAfMA"
    "v6E4qb1AAAAAElFTkSuQmCC";

const auto write_gltf_ball = [](const std::string& material, const auto& put) {
  return put("ball.gltf",
             "{'asset': {'version': '2.0'}, 'buffers': [{'byteLength': 36, 'uri': '" + kTriangle +
                 "'}], 'bufferViews': [{'buffer': 0, 'byteLength': 36}], 'accessors': "
                 "[{'bufferView': 0, 'componentType': 5126, 'count': 3, 'type': 'VEC3'}], "
                 "'images': [{'uri': '" +
                 kTwoGreys + "'}], 'textures': [{'source': 0}], 'materials': [{" + material +
                 "}], 'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'material': "
                 "0}]}], 'nodes': [{'mesh': 0}], 'scenes': [{'nodes': [0]}], 'scene': 0}");
};

/// A dielectric of a grey.
std::string gltf_surface(const std::string& base, const std::string& roughness,
                         const std::string& extensions = "", const std::string& others = "") {
  return "'pbrMetallicRoughness': {'baseColorFactor': [" + base + ", " + base + ", " + base +
         ", 0.5], 'metallicFactor': 0, 'roughnessFactor': " + roughness + "}, 'extensions': {" +
         extensions + "}" + others;
}

TEST(MaterialFurnace, Gltf) {
  const auto transmission = [](const std::string& share) {
    return "'KHR_materials_transmission': {'transmissionFactor': " + share + "}";
  };
  const std::string solid = ", 'KHR_materials_volume': {'thicknessFactor': 1}";
  const std::string coat = "'KHR_materials_clearcoat': {'clearcoatFactor': 1";
  const std::string leaf = "'KHR_materials_diffuse_transmission': {'diffuseTransmissionFactor': ";
  expect_no_gain(
      {{gltf_surface("1", "1"), kAlike},
       {gltf_surface("1", "0.5"), kAlike},
       {gltf_surface("1", "0.1"), kAlike},
       {gltf_surface("1", "0"), kAlike},
       {gltf_surface("1", "0.3", "'KHR_materials_ior': {'ior': 2.4}"), kAlike},
       {gltf_surface("1", "0.3", "'KHR_materials_specular': {'specularFactor': 0.5}"), kAlike},
       {gltf_surface("1", "0.5", "'KHR_materials_sheen': {'sheenColorFactor': [1, 1, 1]}"), kAlike},
       {gltf_surface("1", "0.3", coat + "}"), kAlike},
       {gltf_surface("1", "0.3", coat + ", 'clearcoatRoughnessFactor': 0.5}"), kAlike},
       {gltf_surface("1", "0.5", leaf + "0.5}"), kAlike},
       {gltf_surface("1", "0.5", leaf + "1}"), kAlike},
       {gltf_surface("1", "0.5", leaf + "0.5}, " + coat + "}"), kAlike},
       {gltf_surface("1", "0.5", transmission("0.5")), kAlike},
       {gltf_surface("1", "0.3", transmission("0.2") + solid)},
       {gltf_surface("1", "0.3", transmission("0.5") + solid)},
       {gltf_surface("0.3", "0.1", transmission("0.5") + solid)},
       {gltf_surface("1", "0.3", transmission("1") + solid)},
       {gltf_surface(
           "1", "0.3",
           "'KHR_materials_transmission': {'transmissionFactor': 1, 'transmissionTexture': "
           "{'index': 0}}" +
               solid)},
       {gltf_surface("1", "0.3", transmission("0.5") + solid + ", " + coat + "}")},
       {gltf_surface("1", "0.5", "", ", 'alphaMode': 'BLEND', 'doubleSided': true"), kAlike},
       {"'pbrMetallicRoughness': {'metallicFactor': 0.5, 'roughnessFactor': 0.5}", kAlike},
       {"'pbrMetallicRoughness': {'metallicFactor': 1, 'roughnessFactor': 0.5}", kAlike},
       {"'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [0.5, 0.5, 0.5, "
        "1], 'specularFactor': [0.1, 0.1, 0.1]}}"}},
      write_gltf_ball);
}

TEST(MaterialFurnace, GltfMatchesAppendixB) {
  // Closed integrals of its formulas for a roughness of 1, and the radiance in a room of that.
  for (const auto& [base, seen] : {std::pair("1", 0.973), {"0.8", 0.783}}) {
    const desc::SceneDesc scene = imported(gltf_surface(base, "1"), write_gltf_ball);
    for (const FurnaceMean& zone : ball(scene, false, base, kManySamples)) {
      EXPECT_NEAR(zone.mean, seen, 5.0 * zone.error + 0.004) << base;
      EXPECT_LE(5.0 * zone.error, 0.01) << "too noisy";
    }
  }
  const desc::SceneDesc scene = imported(gltf_surface("0.8", "1"), write_gltf_ball);
  EXPECT_NEAR(room(scene, false, "room").mean, 0.01 / (1.0 - 0.783), 0.002);
}

TEST(MaterialFurnace, Obj) {
  expect_no_gain({{"Kd 1 1 1", kAlike},
                  {"Kd 0.5 0.5 0.5\nKs 0.3 0.3 0.3\nNs 50\nillum 2"},
                  {"Kd 1 1 1\nPr 1", kAlike},
                  {"Kd 1 1 1\nPr 0.3", kAlike},
                  {"Kd 1 1 1\nPr 0.5\nPm 0.5", kAlike},
                  {"Kd 1 1 1\nPm 1", kAlike},
                  {"Kd 1 1 1\nPr 0.5\nd 0.5", kAlike},
                  {"Kd 0 0 0\nKs 1 1 1\nillum 3", kAlike},
                  {"Kd 1 1 1\nd 0.5\nillum 4"},
                  {"Kd 1 1 1\nTf 1 1 1\nNi 1.5\nillum 7"}},
                 [](const std::string& material, const auto& put) {
                   put("ball.mtl", "newmtl m\n" + material + "\n");
                   return put("ball.obj",
                              "mtllib ball.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
                 });
}

}  // namespace
}  // namespace ajar
