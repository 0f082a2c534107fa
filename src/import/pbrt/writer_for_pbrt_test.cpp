// Reading by pbrt-v3 itself of a file that Ajar writes: its words have the nearest equivalents, and
// Ajar's own beside them the exact values.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "color/daylight.h"
#include "color/srgb.h"
#include "imageio/image_encoder.h"
#include "imageio/image_input.h"
#include "import/import.h"
#include "import/pbrt/import_test_support.h"
#include "import/pbrt/pbrt_writer.h"
#include "os/regular_file.h"
#include "scene/desc/models.h"
#include "scene/testing/another_value.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

/// A written file, the scene that Ajar reads from it, and the writer's message.
struct Written {
  std::string text;
  desc::SceneDesc back;
  std::string unknown;
};
Written written(const desc::SceneDesc& scene, const TemporaryFolder& folder = TemporaryFolder()) {
  const std::string file = (folder.path() / "scene.pbrt").string();
  std::string unknown = write_pbrt(scene, file);
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  Warnings warnings;
  desc::SceneDesc back = import_pbrt(file, warnings);
  for (const std::string& message : warnings.messages()) {
    EXPECT_NE(message.find("there are no shapes"), std::string::npos) << message;
  }
  return {text.str(), std::move(back), std::move(unknown)};
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

TEST(WriterForPbrt, WritesAlphaWhereRoughnessIsItsSquare) {
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

TEST(WriterForPbrt, WritesGammaOnlyWhereItIsOff) {
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

TEST(WriterForPbrt, OmitsItsOwnWordsWithoutEffect) {
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
  // Evenly changing widths make one curve.
  EXPECT_EQ(written(strand({1.F, 2.F, 3.F, 4.F, 4.F, 5.F, 6.F, 7.F})).back.shapes.size(), 1U);
}

TEST(WriterForPbrt, NamesPicturesAsPbrtCan) {
  desc::SceneDesc scene;
  scene.film.filename = "a.jpg";
  EXPECT_TRUE(contains(written(scene).text, "\"string filename\" \"a.exr\""));
  scene.film.filename = "a.PNG";
  EXPECT_TRUE(contains(written(scene).text, "\"string filename\" \"a.PNG\""));
}

TEST(WriterForPbrt, WritesTheNumberOfIterations) {
  desc::SceneDesc scene;
  scene.hints.integrator = "sppm";
  scene.hints.samples_per_pixel = 7;
  const Written result = written(scene);
  EXPECT_TRUE(contains(result.text, "\"integer iterations\" [ 7 ]"));
  EXPECT_EQ(result.back.hints.samples_per_pixel, 7);
}

/// A file in `folder` of four texels, their codes 0, 51, 102, 153 in red, 255 less in green, and a
/// blue of 255.
std::string picture(const TemporaryFolder& folder, const std::string& name,
                    const Vec2i& size = {2, 2}) {
  ImageLayout layout;
  layout.width = size.x;
  layout.height = size.y;
  layout.names = {"R", "G", "B"};
  layout.resolution = {size.x, size.y};
  const auto row = [&](int y, auto* out) {
    for (int x = 0; x < size.x; ++x) {
      const int code = 51 * ((2 * y + x) % 4);
      for (const int value : {code, 255 - code, 255}) {
        using Value = std::remove_reference_t<decltype(*out)>;
        *out++ = std::is_same_v<Value, float> ? static_cast<Value>(value) / Value(255)
                                              : static_cast<Value>(value);
      }
    }
  };
  const std::vector<unsigned char> bytes =
      name.ends_with(".hdr") ? encode_hdr(layout, [&](int y, float* out) { row(y, out); })
      : name.ends_with(".exr")
          ? encode_exr(layout, [&](int y, float* out) { row(y, out); })
          : encode_png(layout, [&](int y, unsigned char* out) { row(y, out); });
  const fs::path path = folder.path() / name;
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  return path.string();
}

/// Pixels that pbrt reads from the file that a parameter names: three channels of each texel.
std::vector<float> seen_by_pbrt(const Written& result, const TemporaryFolder& folder,
                                const std::string& parameter) {
  const std::string begin = "\"string " + parameter + "\" \"";
  const std::size_t at = result.text.find(begin) + begin.size();
  const std::string name = result.text.substr(at, result.text.find('"', at) - at);
  EXPECT_TRUE(name.ends_with(".png") || name.ends_with(".exr")) << name;
  return ImageInput((folder.path() / name).string(), true).read<float>(3);
}

Written written_image(const TemporaryFolder& folder, const desc::Node& node) {
  desc::SceneDesc scene;
  scene.textures.emplace_back().node = node;
  scene.materials.emplace_back().node =
      desc::material_node("diffuse", {{"reflectance", desc::TextureRef{0}}});
  Written result = written(scene, folder);
  EXPECT_EQ(result.back.textures.at(0).node, node);
  EXPECT_EQ(result.unknown, "");
  return result;
}

TEST(WriterForPbrt, ConvertsImagesThatPbrtCannotOpen) {
  const TemporaryFolder folder;
  const std::string file = picture(folder, "a.hdr");
  const Written result = written_image(folder, desc::texture_node("image", {{"file", file}}));
  const std::vector<float> seen = seen_by_pbrt(result, folder, "filename");
  ASSERT_EQ(seen.size(), 12U);
  EXPECT_NEAR(seen[3], 0.2F, 0.01F);
  EXPECT_NEAR(seen[4], 0.8F, 0.01F);
  // Integers stay the codes that they are. The suffix alone is none of pbrt's here.
  fs::copy_file(picture(folder, "b.png"), folder.path() / "b.tif");
  const std::vector<float> codes = seen_by_pbrt(
      written_image(folder,
                    desc::texture_node("image", {{"file", (folder.path() / "b.tif").string()}})),
      folder, "filename");
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(codes.at(3 * i), static_cast<float>(i) * 0.2F, 1e-6F);
  }
}

TEST(WriterForPbrt, BakesUnsupportedOptionsIntoImages) {
  const TemporaryFolder folder;
  const std::string file = picture(folder, "a.png");
  const auto seen = [&](desc::Node node) {
    node.set("file", file);
    return seen_by_pbrt(written_image(folder, node), folder, "filename");
  };
  const std::vector<float> green =
      seen(desc::texture_node("image", {{"channel", "green"}, {"decode_srgb", false}}));
  for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(green.at(i), 0.8F, 1e-6F);
  // With a scale of 0.5, which pbrt applies, too: 0.5 · seen = 1 − 0.5 · 0.2.
  const std::vector<float> inverted = seen(desc::texture_node(
      "image", {{"channel", "red"}, {"decode_srgb", false}, {"invert", true}, {"scale", 0.5F}}));
  EXPECT_NEAR(inverted[3], 1.8F, 1e-5F);
  const std::vector<float> squared =
      seen(desc::texture_node("image", {{"decoding_exponent", 2.F}, {"decode_srgb", false}}));
  EXPECT_NEAR(squared[3], 0.04F, 0.5F / 255.F);
}

TEST(WriterForPbrt, WritesImagesOfLightsDecoded) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  scene.lights.emplace_back().node =
      desc::light_node("goniometric", {{"image", picture(folder, "a.png")}, {"gray", true}});
  const Written result = written(scene, folder);
  EXPECT_EQ(result.back.lights.at(0).node, scene.lights[0].node);
  EXPECT_EQ(result.unknown, "");
  const std::vector<float> seen = seen_by_pbrt(result, folder, "mapname");
  const float mean = (linear_from_srgb(0.2F) + linear_from_srgb(0.8F) + 1.F) / 3.F;
  for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(seen[i], mean, 1e-5F);
}

/// A square sky whose upper half is white, and its lower half black.
desc::Node half_sky(const TemporaryFolder& folder) {
  constexpr int kSide = 32;
  ImageLayout layout;
  layout.width = layout.height = kSide;
  layout.names = {"R", "G", "B"};
  layout.resolution = {kSide, kSide};
  const std::vector<unsigned char> bytes = encode_exr(layout, [](int y, float* out) {
    for (int x = 0; x < kSide; ++x) {
      const float u = std::abs(static_cast<float>(2 * x + 1) / kSide - 1.F);
      const float v = std::abs(static_cast<float>(2 * y + 1) / kSide - 1.F);
      for (int i = 0; i < 3; ++i) *out++ = u + v < 1.F ? 1.F : 0.F;
    }
  });
  const fs::path path = folder.path() / "square.exr";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  return desc::light_node("environment", {{"image", path.string()},
                                          {"projection", "equal_area"},
                                          {"radiance", Vec3(2.F)},
                                          {"irradiance", 6.F * 3.14159265F}});
}

TEST(WriterForPbrt, UnfoldsSquareSkies) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  scene.lights.emplace_back().node = half_sky(folder);
  const Written result = written(scene, folder);
  EXPECT_EQ(result.back.lights.at(0).node, scene.lights[0].node);
  EXPECT_EQ(result.unknown, "");
  const std::vector<float> seen = seen_by_pbrt(result, folder, "mapname");
  ASSERT_EQ(seen.size(), 64U * 32U * 3U);
  for (std::size_t y = 0; y < 32; ++y) {
    if (y >= 13 && y <= 18) continue;  // texels of the horizon
    for (std::size_t x = 0; x < 64; ++x) {
      ASSERT_EQ(seen[3 * (64 * y + x)], y < 16 ? 1.F : 0.F) << x << ' ' << y;
    }
  }
  // A white half alone would light surfaces toward it by π, times the radiance.
  const std::size_t at = result.text.find("\"rgb L\" [ ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stof(result.text.substr(at + 10)), 2.F * 6.F, 0.2F);
}

TEST(WriterForPbrt, KeepsTheRowsOfRectangularSkies) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  desc::Node sky = desc::light_node("environment", {{"image", picture(folder, "wide.exr", {4, 2})},
                                                    {"projection", std::string("equal_area")}});
  scene.lights.emplace_back().node = sky;
  const Written result = written(scene, folder);
  EXPECT_TRUE(contains(result.text, "\"string mapname\" \"wide.exr\"")) << result.text;
  EXPECT_EQ(result.back.lights.at(0).node, sky);
  EXPECT_EQ(result.unknown, "");
}

TEST(WriterForPbrt, WarnsOfUnreadableImages) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  scene.textures.emplace_back().node =
      desc::texture_node("image", {{"file", (folder.path() / "none.jpg").string()}});
  scene.materials.emplace_back().node =
      desc::material_node("diffuse", {{"reflectance", desc::TextureRef{0}}});
  const Written result = written(scene, folder);
  EXPECT_TRUE(contains(result.unknown, "images that cannot be read")) << result.unknown;
  EXPECT_TRUE(contains(result.unknown, "none.jpg")) << result.unknown;
}

TEST(WriterForPbrt, UnknownModelsOfOursAreErrors) {
  for (const std::string line : {"Material \"matte\" ", "LightSource \"point\" ",
                                 "Texture \"a\" \"spectrum\" \"constant\" "}) {
    const std::string error =
        error_of("WorldBegin\n" + line + "\"string ajar:model\" \"difuse\"\nWorldEnd");
    EXPECT_TRUE(contains(error, "test.pbrt:2:1: unknown model of Ajar \"difuse\"")) << error;
  }
}

TEST(WriterForPbrt, WritesNoImageOfUnusedTextures) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  scene.textures.emplace_back().node =
      desc::texture_node("image", {{"file", picture(folder, "a.hdr")}});
  written(scene, folder);
  EXPECT_FALSE(fs::exists(folder.path() / "scene_images"));
}

TEST(WriterForPbrt, WritesTheScaleOfASky) {
  desc::SceneDesc scene;
  scene.lights.emplace_back().node =
      desc::light_node("environment", {{"radiance", Vec3(2.F)}, {"irradiance", 3.14159265F}});
  const Written result = written(scene);
  EXPECT_EQ(result.back.lights.at(0).node, scene.lights[0].node);
  EXPECT_TRUE(contains(result.text, "\"rgb L\" [ 2 2 2 ]")) << result.text;
}

TEST(WriterForPbrt, GivesLampsTheMeanOfTheirTextures) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  scene.textures.emplace_back().node =
      desc::texture_node("image", {{"file", picture(folder, "a.exr")}, {"scale", 2.F}});
  scene.textures.emplace_back().node = desc::texture_node(
      "product", {{"first", desc::TextureRef{0}}, {"second", Vec3(10.F, 10.F, 0.F)}});
  scene.materials.emplace_back().node = desc::material_node("diffuse");
  scene.shapes.emplace_back().node = desc::shape_node("sphere");
  scene.shapes.back().material = 0;
  scene.shapes.back().emission =
      desc::Emission{{}, desc::emission_node("area", {{"radiance", desc::TextureRef{1}}})};
  const Written result = written(scene, folder);
  EXPECT_EQ(result.back.shapes.at(0).emission->node, scene.shapes[0].emission->node);
  const std::size_t at = result.text.find("\"rgb L\" [ ");
  ASSERT_NE(at, std::string::npos);
  std::istringstream numbers(result.text.substr(at + 10));
  Vec3 mean;
  numbers >> mean.x >> mean.y >> mean.z;
  expect_rgb(mean, {6.F, 14.F, 0.F}, 1e-4F);
  EXPECT_TRUE(contains(result.unknown, "textures of lamps")) << result.unknown;
}

TEST(WriterForPbrt, CutsOutWhereImagesReachAThreshold) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  scene.textures.emplace_back().node =
      desc::texture_node("image", {{"file", picture(folder, "a.png")},
                                   {"channel", "red"},
                                   {"decode_srgb", false},
                                   {"scale_u", 3.F}});
  scene.textures.emplace_back().node =
      desc::texture_node("product", {{"first", desc::TextureRef{0}}, {"second", Vec3(2.F)}});
  scene.textures.emplace_back().node =
      desc::texture_node("threshold", {{"value", desc::TextureRef{1}}, {"edge", 0.6F}});
  scene.materials.emplace_back().node = desc::material_node("diffuse");
  scene.shapes.emplace_back().node = desc::shape_node("sphere");
  scene.shapes.back().material = 0;
  scene.shapes.back().alpha = 2;
  const Written result = written(scene, folder);
  EXPECT_EQ(result.back.textures.at(2).node, scene.textures[2].node);
  EXPECT_EQ(result.back.shapes.at(0).alpha, 2);
  EXPECT_EQ(result.unknown, "");
  Written of_threshold = result;
  of_threshold.text = result.text.substr(result.text.find("\"texture2\" \"float\" \"imagemap\""));
  EXPECT_TRUE(contains(of_threshold.text, "\"float uscale\" [ 3 ]"));
  const std::vector<float> seen = seen_by_pbrt(of_threshold, folder, "filename");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(seen.at(3 * i), i < 2 ? 0.F : 1.F) << i;
}

TEST(WriterForPbrt, ShowsCoatedMetalWithoutItsCoat) {
  const Written result = written_material(desc::material_node(
      "coated_conductor",
      {{"reflectance", Vec3(0.5F)}, {"roughness", 0.25F}, {"roughness_scale", "square"}}));
  EXPECT_TRUE(contains(result.text, "\"string type\" \"metal\"")) << result.text;
  EXPECT_TRUE(contains(result.text, "\"rgb k\" [ 2 2 2 ]")) << result.text;
  EXPECT_TRUE(contains(result.text, "\"float uroughness\" [ 0.5 ]")) << result.text;
}

TEST(WriterForPbrt, PaintsTheSky) {
  const TemporaryFolder folder;
  desc::SceneDesc scene;
  scene.lights.emplace_back().node =
      desc::light_node("sky", {{"elevation", 30.F}, {"turbidity", 4.F}, {"scale", 2.F}});
  const Written result = written(scene, folder);
  EXPECT_EQ(result.back.lights.at(0).node, scene.lights[0].node);
  EXPECT_EQ(result.unknown, "");
  EXPECT_TRUE(contains(result.text, "LightSource \"infinite\""));
  const std::vector<float> seen = seen_by_pbrt(result, folder, "mapname");
  ASSERT_EQ(seen.size(), 512U * 256U * 3U);
  const Vec3d zenith = SunnySky(4.0, 30.0).color({0.0, 0.0, 1.0});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(seen[i], 2.0 * zenith[static_cast<int>(i)], 0.02 * zenith.y);
    EXPECT_EQ(seen[seen.size() - 1 - i], 0.F);
  }
}

/// The scene with its camera and its image files as `back` has them, whose contents must be the
/// same.
desc::SceneDesc with_files_of(const desc::SceneDesc& back, desc::SceneDesc scene) {
  EXPECT_EQ(back.textures.size(), scene.textures.size());
  for (std::size_t i = 0; i < std::min(back.textures.size(), scene.textures.size()); ++i) {
    desc::Node& node = scene.textures[i].node;
    if (!node.is("image")) continue;
    const std::string file = back.textures[i].node.text("file");
    EXPECT_EQ(read_file(file).view(), *scene.embedded_files.at(node.text("file")));
    node.set("file", file);
  }
  // The file has the inverse of its place, which is rounded.
  EXPECT_TRUE(back.camera.to_world.equalWithAbsError(scene.camera.to_world, 1e-9));
  scene.camera.to_world = back.camera.to_world;
  return scene;
}

TEST(WriterForPbrt, KeepsBareMeshesAndTheirColors) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
       "float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face "
       "1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 "
       "0 0 0 255\n3 0 1 2\n"},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
       "0\nendloop\nendfacet\nendsolid a\n"}};
  for (const auto& [name, text] : files) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    const std::string path = (folder.path() / name).string();
    std::ofstream(path) << text;
    Warnings warnings;
    const desc::SceneDesc scene = import_scene(path, warnings);
    const Written result = written(scene, folder);
    EXPECT_EQ(scene.embedded_files.empty(), name == "a.stl");
    EXPECT_EQ(desc::hash(with_files_of(result.back, scene)), desc::hash(result.back));
  }
}

TEST(WriterForPbrt, ReportsNamesUnknownToPbrt) {
  desc::SceneDesc scene;
  for (int i = 0; i < 2; ++i) {
    scene.materials.emplace_back().node = desc::material_node("dielectric", {{"thin", true}});
  }
  scene.materials.emplace_back().node = desc::material_node("coated_conductor");
  scene.textures.emplace_back().node = desc::texture_node("threshold");
  scene.materials.back().bump = 0;
  EXPECT_EQ(written(scene).unknown,
            "pbrt-v3 does not know, and shows otherwise, these models: coated_conductor, "
            "threshold; parameters: thin (2 times)");
  // Models that pbrt has by the same or another name are known to it.
  desc::SceneDesc known;
  for (const char* name : {"mirror", "plastic", "translucent", "composite", "diffuse"}) {
    desc::Node node = desc::material_node(name);
    for (const ParameterSpec& spec : node.model().parameters) {
      if (spec.name != "roughness_scale" && spec.name != "between_facets" &&
          spec.name != "uncounted") {
        node.set(spec.name, testing::another_value(spec));
      }
    }
    known.materials.emplace_back().node = node;
  }
  known.lights.emplace_back().node = desc::light_node("spot", {{"falloff_start", 3.F}});
  EXPECT_EQ(written(known).unknown, "");
}

}  // namespace
}  // namespace ajar
