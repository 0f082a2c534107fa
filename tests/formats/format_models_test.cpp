// Materials of other renderers against their own values: on a ball under a lamp, and in a furnace.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "import/gltf/gltf_import.h"
#include "import/mitsuba/mitsuba_import.h"
#include "import/pbrt/pbrt_import.h"
#include "import/tungsten/tungsten_import.h"
#include "scene/testing/materials.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

enum FormatOfModel { kMitsuba3, kMitsuba06, kTungsten, kPbrt3, kPbrt4, kGltf };
constexpr std::array kHeadings = {"Mitsuba 3", "Mitsuba 0.6", "Tungsten",
                                  "pbrt-v3",   "pbrt-v4",     "glTF"};

/// A material as its format has it, and its values in its renderer: for Mitsuba 3 by its bsdfs
/// (3.9, `eval` and `sample`), for pbrt-v4's layers by a random walk as there, for others by the
/// formulas that they publish. Numbers are those of `lit` and `furnace` below; of single lanes.
struct ModelCase {
  FormatOfModel format;
  const char* name;
  const char* text;  ///< with ' in place of "
  double lit;        ///< −1: not known
  double furnace;
  double error = 0.01;    ///< the most that ours may be from it, as a share
  bool stand_in = false;  ///< another model, with a warning
};

const std::vector<ModelCase>& model_cases() {
  static const std::vector<ModelCase> kCases = {
      {kMitsuba3, "diffuse", "<bsdf type='diffuse'></bsdf>", 0.252, 0.5},
      {kMitsuba3, "conductor",
       "<bsdf type='conductor'><rgb name='eta' value='0.2'/><rgb name='k' value='3.9'/>"
       "</bsdf>",
       0.0, 0.9486},
      {kMitsuba3, "roughconductor, GGX, α 0.3",
       "<bsdf type='roughconductor'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.3'/><rgb name='eta' value='0.2'/>"
       "<rgb name='k' value='3.9'/></bsdf>",
       0.2545, 0.7994},
      {kMitsuba3, "roughconductor, Beckmann, α 0.3",
       "<bsdf type='roughconductor'><float name='alpha' value='0.3'/>"
       "<rgb name='eta' value='0.2'/><rgb name='k' value='3.9'/></bsdf>",
       0.2489, 0.9089},
      {kMitsuba3, "dielectric", "<bsdf type='dielectric'></bsdf>", 0.0, 1.0},
      {kMitsuba3, "thindielectric", "<bsdf type='thindielectric'></bsdf>", 0.0, 1.0},
      {kMitsuba3, "roughdielectric, GGX, α 0.3",
       "<bsdf type='roughdielectric'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.3'/></bsdf>",
       0.01096, 0.961},
      {kMitsuba3, "plastic", "<bsdf type='plastic'></bsdf>", 0.2388, 0.5422},
      {kMitsuba3, "plastic, nonlinear",
       "<bsdf type='plastic'><boolean name='nonlinear' value='true'/></bsdf>", 0.1388, 0.3499},
      {kMitsuba3, "roughplastic, GGX, α 0.1",
       "<bsdf type='roughplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.1'/></bsdf>",
       0.2257, 0.4912},
      {kMitsuba3, "roughplastic, GGX, α 0.2",
       "<bsdf type='roughplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.2'/></bsdf>",
       0.198, 0.4247},
      {kMitsuba3, "roughplastic, GGX, α 0.4",
       "<bsdf type='roughplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.4'/></bsdf>",
       0.1521, 0.3168},
      {kMitsuba3, "roughplastic, GGX, α 1",
       "<bsdf type='roughplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='1'/></bsdf>",
       0.08107, 0.1538},
      {kMitsuba3, "roughplastic, Beckmann, α 0.1",
       "<bsdf type='roughplastic'><string name='distribution' value='beckmann'/>"
       "<float name='alpha' value='0.1'/></bsdf>",
       0.2401, 0.5241},
      {kMitsuba3, "roughplastic, Beckmann, α 0.4",
       "<bsdf type='roughplastic'><string name='distribution' value='beckmann'/>"
       "<float name='alpha' value='0.4'/></bsdf>",
       0.2009, 0.4296},
      {kMitsuba3, "roughplastic, Beckmann, α 1",
       "<bsdf type='roughplastic'><string name='distribution' value='beckmann'/>"
       "<float name='alpha' value='1'/></bsdf>",
       0.1311, 0.2641},
      {kMitsuba3, "roughplastic, GGX, α 0.4, nonlinear",
       "<bsdf type='roughplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.4'/><boolean name='nonlinear' value='true'/></bsdf>",
       0.1228, 0.2603},
      {kMitsuba3, "roughplastic, Beckmann, α 0.1, nonlinear",
       "<bsdf type='roughplastic'><float name='alpha' value='0.1'/>"
       "<boolean name='nonlinear' value='true'/></bsdf>",
       0.1473, 0.3453},
      {kMitsuba3, "pplastic, α 0.1", "<bsdf type='pplastic'></bsdf>", 0.2268, 0.5013},
      {kMitsuba3, "pplastic, GGX, α 0.4",
       "<bsdf type='pplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.4'/></bsdf>",
       0.2273, 0.4621},
      {kMitsuba3, "principled", "<bsdf type='principled'></bsdf>", 0.2679, 0.5595},
      {kMitsuba3, "principled, metallic",
       "<bsdf type='principled'><float name='metallic' value='1'/></bsdf>", 0.1331, 0.448},
      {kMitsuba3, "principled, clearcoat, gloss 0",
       "<bsdf type='principled'><float name='clearcoat' value='1'/></bsdf>", 0.275, 0.5776},
      {kMitsuba3, "principled, clearcoat, gloss 0.7",
       "<bsdf type='principled'><float name='clearcoat' value='1'/>"
       "<float name='clearcoat_gloss' value='0.7'/></bsdf>",
       0.2749, 0.5793},
      {kMitsuba3, "principled, sheen",
       "<bsdf type='principled'><float name='sheen' value='1'/></bsdf>", 0.2679, 0.5707},
      {kMitsuba3, "principledthin", "<bsdf type='principledthin'></bsdf>", 0.2572, 0.5042},
      {kMitsuba3, "blendbsdf",
       "<bsdf type='blendbsdf'><float name='weight' value='0.25'/><bsdf type='diffuse'>"
       "</bsdf><bsdf type='plastic'></bsdf></bsdf>",
       0.2487, 0.5093},
      {kMitsuba3, "mask",
       "<bsdf type='mask'><float name='opacity' value='0.25'/><bsdf type='diffuse'></bsdf>"
       "</bsdf>",
       0.06299, 0.8751},
      {kMitsuba06, "coating of diffuse",
       "<bsdf type='coating'><float name='int_ior' value='1.5'/>"
       "<float name='ext_ior' value='1'/><bsdf type='diffuse'></bsdf></bsdf>",
       0.09612, 0.2695},
      {kMitsuba06, "coating of roughconductor, GGX, α 0.3",
       "<bsdf type='coating'><float name='int_ior' value='1.5'/>"
       "<float name='ext_ior' value='1'/><bsdf type='roughconductor'>"
       "<string name='distribution' value='ggx'/><float name='alpha' value='0.3'/>"
       "<rgb name='eta' value='0.2'/><rgb name='k' value='3.9'/>"
       "<float name='ext_eta' value='1'/></bsdf></bsdf>",
       0.1668, 0.496},
      {kMitsuba06, "coating of diffuse, sigma_a 0.3",
       "<bsdf type='coating'><float name='int_ior' value='1.5'/>"
       "<float name='ext_ior' value='1'/><bsdf type='diffuse'></bsdf>"
       "<rgb name='sigma_a' value='0.3'/></bsdf>",
       0.04923, 0.1781},
      {kMitsuba06, "roughcoating of diffuse, Beckmann, α 0.3",
       "<bsdf type='roughcoating'><float name='alpha' value='0.3'/>"
       "<float name='int_ior' value='1.5'/><float name='ext_ior' value='1'/>"
       "<bsdf type='diffuse'></bsdf></bsdf>",
       0.1074, 0.2547},
      {kMitsuba06, "roughcoating of roughconductor, Beckmann, α 0.3",
       "<bsdf type='roughcoating'><float name='alpha' value='0.3'/>"
       "<float name='int_ior' value='1.5'/><float name='ext_ior' value='1'/>"
       "<bsdf type='roughconductor'><float name='alpha' value='0.3'/>"
       "<rgb name='eta' value='0.2'/><rgb name='k' value='3.9'/>"
       "<float name='ext_eta' value='1'/></bsdf></bsdf>",
       0.2131, 0.583},
      {kMitsuba06, "roughplastic, GGX, α 0.4",
       "<bsdf type='roughplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.4'/><boolean name='nonlinear' value='false'/>"
       "<float name='int_ior' value='1.5'/><float name='ext_ior' value='1'/></bsdf>",
       0.2421, 0.4912},
      {kMitsuba06, "roughplastic, GGX, α 0.4, nonlinear",
       "<bsdf type='roughplastic'><string name='distribution' value='ggx'/>"
       "<float name='alpha' value='0.4'/><boolean name='nonlinear' value='true'/>"
       "<float name='int_ior' value='1.5'/><float name='ext_ior' value='1'/></bsdf>",
       0.142, 0.298},
      {kMitsuba06, "phong", "<bsdf type='phong'></bsdf>", 0.2991, 0.634, 0.25, true},
      {kTungsten, "lambert", "'type': 'lambert', 'albedo': 0.5", 0.252, 0.5},
      {kTungsten, "plastic", "'type': 'plastic', 'albedo': 0.5", 0.137, 0.348},
      {kTungsten, "plastic, sigma_a 0.3", "'type': 'plastic', 'albedo': 0.5, 'sigma_a': 0.3",
       0.05668, 0.1845},
      {kTungsten, "rough_plastic, GGX, roughness 0.3",
       "'type': 'rough_plastic', 'albedo': 0.5, 'roughness': 0.3, 'distribution': 'ggx'", 0.1478,
       0.3161},
      {kTungsten, "rough_plastic, Beckmann, roughness 0.3",
       "'type': 'rough_plastic', 'albedo': 0.5, 'roughness': 0.3, 'distribution': 'beckmann'",
       0.1475, 0.3301},
      {kTungsten, "rough_conductor, GGX, roughness 0.3",
       "'type': 'rough_conductor', 'roughness': 0.3, 'eta': [0.2, 0.2, 0.2], 'k': [3.9, "
       "3.9, 3.9], 'material': ''",
       0.2545, 0.7995},
      {kTungsten, "smooth_coat of lambert",
       "'type': 'smooth_coat', 'ior': 1.5, 'substrate': {'type': 'lambert', 'albedo': 0.5}",
       0.09612, 0.2695},
      {kTungsten, "smooth_coat of rough_conductor",
       "'type': 'smooth_coat', 'ior': 1.5, 'substrate': {'type': 'rough_conductor', "
       "'roughness': 0.3, 'eta': [0.2, 0.2, 0.2], 'k': [3.9, 3.9, 3.9], 'material': ''}",
       0.1668, 0.496},
      {kTungsten, "rough_coat of lambert, GGX, roughness 0.3",
       "'type': 'rough_coat', 'ior': 1.5, 'roughness': 0.3, 'distribution': 'ggx', "
       "'substrate': {'type': 'lambert', 'albedo': 0.5}",
       0.1069, 0.2376},
      {kTungsten, "rough_coat of lambert, Beckmann, roughness 0.3",
       "'type': 'rough_coat', 'ior': 1.5, 'roughness': 0.3, 'distribution': 'beckmann', "
       "'substrate': {'type': 'lambert', 'albedo': 0.5}",
       0.1067, 0.2517},
      {kTungsten, "rough_coat of rough_conductor",
       "'type': 'rough_coat', 'ior': 1.5, 'roughness': 0.3, 'substrate': {'type': "
       "'rough_conductor', 'roughness': 0.3, 'eta': [0.2, 0.2, 0.2], 'k': [3.9, 3.9, 3.9], "
       "'material': ''}",
       0.1776, 0.4642},
      {kTungsten, "phong", "'type': 'phong', 'albedo': 0.5, 'exponent': 64, 'diffuse_ratio': 0.2",
       0.1438, 0.3677, 0.16, true},
      {kPbrt3, "matte, sigma 20", "Material 'matte' 'rgb Kd' [.5 .5 .5] 'float sigma' 20", 0.237,
       0.4602},
      {kPbrt3, "plastic, roughness 0.3",
       "Material 'plastic' 'rgb Kd' [.5 .5 .5] 'rgb Ks' [.25 .25 .25] 'float roughness' .3 "
       "'bool remaproughness' 'false'",
       0.2548, 0.6058},
      {kPbrt3, "substrate, roughness 0.3",
       "Material 'substrate' 'rgb Kd' [.5 .5 .5] 'rgb Ks' [.04 .04 .04] 'float uroughness' "
       ".3 'float vroughness' .3 'bool remaproughness' 'false'",
       0.2259, 0.4394},
      {kPbrt3, "uber, roughness 0.3",
       "Material 'uber' 'rgb Kd' [.5 .5 .5] 'rgb Ks' [.25 .25 .25] 'float roughness' .3 "
       "'bool remaproughness' 'false'",
       0.2547, 0.5134},
      {kPbrt3, "metal, roughness 0.3",
       "Material 'metal' 'rgb eta' [.2 .2 .2] 'rgb k' [3.9 3.9 3.9] 'float roughness' .3 "
       "'bool remaproughness' 'false'",
       0.2547, 0.8027},
      {kPbrt3, "disney", "Material 'disney' 'rgb color' [.5 .5 .5]", 0.2679, 0.5618},
      {kPbrt3, "disney, clearcoat, gloss 0",
       "Material 'disney' 'rgb color' [.5 .5 .5] 'float clearcoat' 1 'float clearcoatgloss' "
       "0",
       0.2707, 0.5739},
      {kPbrt4, "diffuse", "Material 'diffuse' 'rgb reflectance' [.5 .5 .5]", 0.252, 0.5},
      {kPbrt4, "conductor, α 0.3",
       "Material 'conductor' 'rgb eta' [.2 .2 .2] 'rgb k' [3.9 3.9 3.9] 'float roughness' "
       ".09",
       0.2547, 0.8027},
      {kPbrt4, "coateddiffuse, smooth",
       "Material 'coateddiffuse' 'rgb reflectance' [.5 .5 .5] 'float roughness' 0", -1.0, 0.3365},
      {kPbrt4, "coateddiffuse, α 0.3",
       "Material 'coateddiffuse' 'rgb reflectance' [.5 .5 .5] 'float roughness' 0.09", -1.0,
       0.2775},
      {kPbrt4, "coatedconductor, coat smooth, metal smooth",
       "Material 'coatedconductor' 'rgb conductor.eta' [.2 .2 .2] 'rgb conductor.k' [3.9 "
       "3.9 3.9] 'float interface.roughness' 0 'float conductor.roughness' 0",
       -1.0, 0.913},
      {kPbrt4, "coatedconductor, coat smooth, metal α 0.3",
       "Material 'coatedconductor' 'rgb conductor.eta' [.2 .2 .2] 'rgb conductor.k' [3.9 "
       "3.9 3.9] 'float interface.roughness' 0 'float conductor.roughness' 0.09",
       -1.0, 0.6284, 0.06},
      {kPbrt4, "coatedconductor, coat α 0.3, metal α 0.3",
       "Material 'coatedconductor' 'rgb conductor.eta' [.2 .2 .2] 'rgb conductor.k' [3.9 "
       "3.9 3.9] 'float interface.roughness' 0.09 'float conductor.roughness' 0.09",
       -1.0, 0.4932, 0.09},
      {kGltf, "metallic 0, roughness 1", "'metallicFactor': 0", 0.2489, 0.4951},
      {kGltf, "metallic 0, roughness 0.5", "'metallicFactor': 0, 'roughnessFactor': 0.5", 0.2525,
       0.5299},
      {kGltf, "metallic 0.5, roughness 0.5", "'metallicFactor': 0.5, 'roughnessFactor': 0.5",
       0.1928, 0.4889},
      {kGltf, "metallic 1, roughness 0.5", "'roughnessFactor': 0.5", 0.1331, 0.4479},
      {kGltf, "`KHR_materials_ior` 1.8",
       "'metallicFactor': 0, 'roughnessFactor': 0.5}, 'extensions': {'KHR_materials_ior': {'ior': "
       "1.8}",
       0.2531, 0.545},
      {kGltf, "`KHR_materials_specular` 0.5",
       "'metallicFactor': 0, 'roughnessFactor': 0.5}, 'extensions': {'KHR_materials_specular': "
       "{'specularFactor': 0.5}",
       0.2522, 0.515},
      {kGltf, "`KHR_materials_clearcoat`, roughness 0.5",
       "'metallicFactor': 0, 'roughnessFactor': 0.5}, 'extensions': {'KHR_materials_clearcoat': "
       "{'clearcoatFactor': 1, 'clearcoatRoughnessFactor': 0.5}",
       0.2485, 0.5539, 0.02},
  };
  return kCases;
}

desc::SceneDesc scene_of(const ModelCase& model) {
  Warnings warnings;
  const std::string text = model.text;
  switch (model.format) {
    case kMitsuba3:
    case kMitsuba06: {
      const char* version = model.format == kMitsuba3 ? "3.0.0" : "0.6.0";
      const std::string scene = fmt::format(
          "<scene version='{}'><sensor type='perspective'/><shape type='sphere'>{}</shape></scene>",
          version, text);
      return import_mitsuba_text(test::with_quotes(scene), "test.xml", ".", warnings);
    }
    case kTungsten:
      return import_tungsten_text(
          test::with_quotes("{'camera': {}, 'primitives': [{'type': 'sphere', 'bsdf': {" + text +
                            "}}]}"),
          "test.json", "", warnings);
    case kGltf: {
      const std::string triangle =
          "{'asset': {'version': '2.0'}, 'nodes': [{'mesh': 0}], 'scenes': [{'nodes': [0]}],"
          "'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'material': 0}]}],"
          "'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 3, 'type': 'VEC3'}],"
          "'bufferViews': [{'buffer': 0, 'byteLength': 36}], 'buffers': [{'byteLength': 36,"
          "'uri': 'data:application/octet-stream;base64,"
          "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA'}],"
          "'materials': [{'pbrMetallicRoughness': {'baseColorFactor': [0.5, 0.5, 0.5, 1], ";
      return import_gltf_bytes(test::with_quotes(triangle + text + "}}]}"), "test.gltf", "",
                               warnings, {});
    }
    case kPbrt3:
    case kPbrt4:
      break;
  }
  return import_pbrt_text(
      test::with_quotes("Camera 'perspective' WorldBegin " + text + " Shape 'sphere'"), "test.pbrt",
      "", warnings);
}

/// π times the mean radiance of a ball of this material, seen from far, under parallel light of
/// irradiance 1 from 45° to the side: a white matte one has ½. Mirrors show nothing of the lamp.
double lit(const Bsdf& bsdf) {
  constexpr int kRings = 16;
  constexpr int kTurns = 24;
  const Vec3 eye(0.F, 0.F, 1.F);
  const Vec3 lamp = normalize(Vec3(1.F, 0.F, 1.F));
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    for (int k = 0; k < kTurns; ++k) {
      const float r = std::sqrt((static_cast<float>(i) + 0.5F) / kRings);
      const float phi = 2.F * kPi * (static_cast<float>(k) + 0.5F) / kTurns;
      const Vec3 n(r * std::cos(phi), r * std::sin(phi), std::sqrt(1.F - r * r));
      const Vec3 s = normalize(cross(Vec3(0.F, 1.F, 0.F), n));
      const Vec3 t = cross(n, s);
      const auto local = [&](const Vec3& w) { return Vec3(dot(s, w), dot(t, w), dot(n, w)); };
      if (dot(n, lamp) <= 1e-6F) continue;
      sum += static_cast<double>(bsdf.eval(local(eye), local(lamp), TransportMode::Radiance)[0]);
    }
  }
  return M_PI * sum / (kRings * kTurns);
}

/// Mean over directions of the share of light that it scatters, to both sides.
double furnace(const Bsdf& bsdf) {
  constexpr int kCosines = 8;
  constexpr int kSamples = 4096;
  constexpr double kPhi = 1.22074408460575947536;  // Roberts 2018: the R3 sequence
  double sum = 0.0;
  for (int i = 0; i < kCosines; ++i) {
    const float z = std::sqrt((static_cast<float>(i) + 0.5F) / kCosines);
    for (int k = 1; k <= kSamples; ++k) {
      const auto number = [k](double step) {
        const double x = 0.5 + k * step;
        return std::min(static_cast<float>(x - std::floor(x)), kOneMinusEpsilon);
      };
      const BsdfUniforms u{number(1.0 / kPhi),
                           {number(1.0 / (kPhi * kPhi)), number(1.0 / (kPhi * kPhi * kPhi))}};
      // Importance: radiance that is refracted grows by the square of the index.
      const auto s = bsdf.sample({std::sqrt(1.F - z * z), 0.F, z}, u, TransportMode::Importance);
      if (s) sum += static_cast<double>(s->weight[0]);
    }
  }
  return sum / (kCosines * kSamples);
}

struct Measured {
  double lit, furnace;
};
Measured measured(const ModelCase& model) {
  testing::Fixture fixture;
  fixture.scene = scene_of(model);
  const Bsdf bsdf = fixture.bsdf(fixture.scene.shapes.at(0).material);
  return {lit(bsdf), furnace(bsdf)};
}

double relative_error(double ours, double theirs) {
  return theirs > 0.0 ? std::abs(ours / theirs - 1.0) : std::abs(ours);
}
double error_of(const ModelCase& model, const Measured& ours) {
  const double in_furnace = relative_error(ours.furnace, model.furnace);
  return model.lit < 0.0 ? in_furnace : std::max(in_furnace, relative_error(ours.lit, model.lit));
}

TEST(FormatModels, MatchTheirRenderers) {
  for (const ModelCase& model : model_cases()) {
    const Measured ours = measured(model);
    EXPECT_LE(error_of(model, ours), model.error)
        << kHeadings.at(model.format) << ", " << model.name << ": lit " << ours.lit << " for "
        << model.lit << ", in a furnace " << ours.furnace << " for " << model.furnace;
    EXPECT_LE(ours.furnace, 1.0 + 1e-3) << model.name;
  }
}

/// A row of the page: theirs, ours, and how near that is.
std::string row_of(const ModelCase& model, const Measured& ours) {
  const std::string verdict =
      model.error <= 0.01
          ? "exact"
          : fmt::format("{} ({:.0f} %)", model.stand_in ? "stand-in" : "near", 100.0 * model.error);
  const auto number = [](double x) {
    return x < 0.0 ? std::string("–") : fmt::format("{:.3f}", x);
  };
  return fmt::format("| {} | {} | {} | {} | {} | {} |", model.name, number(model.lit),
                     model.lit < 0.0 ? "–" : number(ours.lit), number(model.furnace),
                     number(ours.furnace), verdict);
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::stringstream stream(row);
  for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
  return cells;
}

/// True if two rows are equal, numbers but for the last digit.
bool is_same_row(const std::string& a, const std::string& b) {
  const std::vector<std::string> left = cells_of(a);
  const std::vector<std::string> right = cells_of(b);
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const std::string& x, const std::string& y) {
                      if (x == y) return true;
                      char* end = nullptr;
                      const double number = std::strtod(x.c_str(), &end);
                      return end != x.c_str() &&
                             std::abs(number - std::strtod(y.c_str(), nullptr)) < 0.0025;
                    });
}

TEST(FormatModels, AreOnThePage) {
  std::ifstream file(std::string(AJAR_SOURCE_DIR) + "/docs/reference/formats-models.md");
  ASSERT_TRUE(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  for (const ModelCase& model : model_cases()) {
    const std::string row = row_of(model, measured(model));
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [&](const std::string& line) { return is_same_row(line, row); }))
        << kHeadings.at(model.format) << " needs\n"
        << row;
  }
}

}  // namespace
}  // namespace ajar
