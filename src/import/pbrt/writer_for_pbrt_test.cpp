// What pbrt-v3 itself makes of a file that Ajar writes: its words have what comes nearest, and
// Ajar's own beside them what is meant.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "import/pbrt/import_test_support.h"
#include "import/pbrt/pbrt_writer.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

/// A written file, and what Ajar reads of it.
struct Written {
  std::string text;
  desc::SceneDesc back;
};
Written written(const desc::SceneDesc& scene) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "scene.pbrt").string();
  write_pbrt(scene, file);
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  Warnings warnings;
  desc::SceneDesc back = import_pbrt(file, warnings);
  for (const std::string& message : warnings.messages()) {
    EXPECT_NE(message.find("there are no shapes"), std::string::npos) << message;
  }
  return {text.str(), std::move(back)};
}

Written written_material(const desc::Node& node) {
  desc::SceneDesc scene;
  scene.materials.emplace_back().node = node;
  Written result = written(scene);
  EXPECT_EQ(result.back.materials.at(0).node, node);
  return result;
}

TEST(WriterForPbrt, GivesCoatsTheirGloss) {
  const std::string text =
      written_material(
          desc::material_node("coated_diffuse", {{"coat", "dielectric"},
                                                 {"eta", 3.F},
                                                 {"roughness_v", 0.2F},
                                                 {"coat_reflectance", Vec3(1.F, 0.5F, 0.F)}}))
          .text;
  EXPECT_TRUE(contains(text, "\"rgb Ks\" [ 0.25 0.125 0 ]")) << text;
  EXPECT_TRUE(contains(text, "\"string type\" \"substrate\"")) << text;
}

TEST(WriterForPbrt, GivesMetalsTheIndexThatReflectsTheSame) {
  const std::string text =
      written_material(desc::material_node("conductor", {{"reflectance", Vec3(0.5F, 0.F, 0.8F)},
                                                         {"roughness_v", 0.2F}}))
          .text;
  EXPECT_TRUE(contains(text, "\"rgb eta\" [ 1 1 1 ] ")) << text;
  EXPECT_TRUE(contains(text, "\"rgb k\" [ 2 0 4")) << text;
}

TEST(WriterForPbrt, SaysAlphaWhereRoughnessIsItsSquare) {
  for (const char* name : {"dielectric", "conductor", "coated_diffuse", "composite"}) {
    const std::string text =
        written_material(desc::material_node(name, {{"roughness", 0.25F},
                                                    {"roughness_v", 0.0625F},
                                                    {"roughness_scale", "square"}}))
            .text;
    EXPECT_TRUE(contains(text, "\"float uroughness\" [ 0.5 ]")) << text;
    EXPECT_TRUE(contains(text, "\"float vroughness\" [ 0.25 ]")) << text;
    EXPECT_TRUE(contains(text, "\"bool remaproughness\" \"false\"")) << text;
  }
  const std::string plastic =
      written_material(
          desc::material_node("plastic", {{"roughness", 0.25F}, {"roughness_scale", "square"}}))
          .text;
  EXPECT_TRUE(contains(plastic, "\"float roughness\" [ 0.5 ]")) << plastic;
}

TEST(WriterForPbrt, MakesSmoothMetalAsSmoothAsItCan) {
  const std::string text =
      written_material(
          desc::material_node("conductor", {{"distribution", "smooth"}, {"roughness_v", 0.3F}}))
          .text;
  EXPECT_TRUE(contains(text, "\"float uroughness\" [ 0 ]")) << text;
}

TEST(WriterForPbrt, SaysNothingOfGammaButWhereItIsOff) {
  const auto text = [](bool decode) {
    desc::SceneDesc scene;
    scene.textures.emplace_back().node =
        desc::texture_node("image", {{"file", "/a.exr"}, {"decode_srgb", decode}});
    scene.materials.emplace_back().node =
        desc::material_node("diffuse", {{"reflectance", desc::TextureRef{0}}});
    const Written result = written(scene);
    EXPECT_EQ(result.back.textures.at(0).node, scene.textures[0].node);
    return result.text;
  };
  EXPECT_FALSE(contains(text(true), "gamma"));
  EXPECT_TRUE(contains(text(false), "\"bool gamma\" \"false\""));
}

TEST(WriterForPbrt, WritesNoWordsOfItsOwnThatSayNothing) {
  desc::SceneDesc scene;
  scene.textures.emplace_back().node = desc::texture_node("image", {{"file", "/a.png"}});
  scene.materials.emplace_back().node =
      desc::material_node("diffuse", {{"reflectance", desc::TextureRef{0}}});
  scene.materials.emplace_back().node = desc::material_node("dielectric");
  const std::string text = written(scene).text;
  for (const char* word : {"channel", "invert", "rotation", "thin", "masking", "ajar:"}) {
    EXPECT_FALSE(contains(text, word)) << word;
  }
}

/// Strands along x, of segments of length 3, with these widths at their control points.
desc::SceneDesc strand(const std::vector<float>& widths) {
  desc::Curves curves;
  curves.widths = widths;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    curves.control_points.emplace_back(static_cast<float>(i / 4 * 3 + i % 4), 0.F, 0.F);
  }
  desc::SceneDesc scene;
  scene.materials.emplace_back().node = desc::material_node("diffuse");
  scene.shapes.emplace_back().node = desc::shape_node(
      "curves",
      {{"type", "cylinder"}, {"curves", std::make_shared<const desc::Curves>(std::move(curves))}});
  scene.shapes.back().material = 0;
  return scene;
}

/// Width at x, by Bernstein's polynomials.
float width_at(const desc::SceneDesc& scene, float x) {
  for (const desc::Shape& shape : scene.shapes) {
    const desc::Curves& curves = *shape.node.curves("curves");
    for (std::size_t s = 0; s < curves.widths.size(); s += 4) {
      const float begin = curves.control_points[s].x;
      const float end = curves.control_points[s + 3].x;
      if (x < begin || x > end) continue;
      const float t = (x - begin) / (end - begin);
      const float u = 1.F - t;
      const float* w = &curves.widths[s];
      return u * u * u * w[0] + 3.F * u * u * t * w[1] + 3.F * u * t * t * w[2] + t * t * t * w[3];
    }
  }
  ADD_FAILURE() << "no curve at " << x;
  return 0.F;
}

TEST(WriterForPbrt, KeepsWidthsAlongStrands) {
  const float third = 1.F / 3.F;
  for (const std::vector<float>& widths : std::vector<std::vector<float>>{
           {1.F, 2.F, 3.F, 4.F, 4.F, 3.F, 2.F, 1.F},  // thick in the middle
           {1.F, 4.F, 4.F, 1.F},                      // within a segment
           {1.F, 1.F, 1.F, 1.F, 2.F, 2.F, 2.F, 2.F},  // a step
           {1.F, 1.F + third, 2.F - third, 2.F, 2.F, 2.F + third, 3.F - third, 3.F}}) {
    const desc::SceneDesc scene = strand(widths);
    const desc::SceneDesc back = written(scene).back;
    const float length = static_cast<float>(widths.size() / 4 * 3);
    for (float x = 0.01F; x < length; x += 0.07F) {
      ASSERT_NEAR(width_at(back, x), width_at(scene, x), 0.02F) << x;
    }
  }
  // What changes evenly is one curve.
  EXPECT_EQ(written(strand({1.F, 2.F, 3.F, 4.F, 4.F, 5.F, 6.F, 7.F})).back.shapes.size(), 1U);
}

TEST(WriterForPbrt, NamesPicturesAsPbrtCan) {
  desc::SceneDesc scene;
  scene.film.filename = "a.jpg";
  EXPECT_TRUE(contains(written(scene).text, "\"string filename\" \"a.exr\""));
  scene.film.filename = "a.PNG";
  EXPECT_TRUE(contains(written(scene).text, "\"string filename\" \"a.PNG\""));
}

TEST(WriterForPbrt, SaysHowManyIterationsThereAre) {
  desc::SceneDesc scene;
  scene.hints.integrator = "sppm";
  scene.hints.samples_per_pixel = 7;
  const Written result = written(scene);
  EXPECT_TRUE(contains(result.text, "\"integer iterations\" [ 7 ]"));
  EXPECT_EQ(result.back.hints.samples_per_pixel, 7);
}

}  // namespace
}  // namespace ajar
