#include "import/pbrt/pbrt_writer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "import/common/transforms.h"
#include "import/pbrt/import_test_support.h"
#include "os/regular_file.h"
#include "scene/desc/models.h"
#include "scene/medium/color_field.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

const char* const kEverything = R"(
Integrator "mlt" "integer maxdepth" 9 "integer chains" 7 "float sigma" .03
Sampler "random" "integer pixelsamples" 5
PixelFilter "mitchell" "float xwidth" 3 "float B" .2
Film "image" "integer xresolution" 31 "integer yresolution" 17 "float cropwindow" [.1 .9 0 .7] "float scale" 1.7 "string filename" "a \"b\".exr"
LookAt 1.1 2.2 3.3  0.4 -0.5 0.6  0.1 1 0.2
Scale -1 1 1
MakeNamedMedium "fog" "string type" "homogeneous" "rgb sigma_a" [.1 .2 .3] "rgb sigma_s" [.4 .5 .6] "float g" .3
Rotate 20 1 2 3
MakeNamedMedium "smoke" "string type" "heterogeneous" "rgb sigma_a" [.1 .2 .3] "rgb sigma_s" [.4 .5 .6] "integer nx" 2 "integer nz" 2 "float density" [0 .1 .2 .7] "point p0" [-1 -2 0] "point p1" [1 2 3]
MakeNamedMedium "dye" "string type" "rgbgrid" "rgb sigma_a" [.1 .2 .3 .4 .5 .6] "integer nx" 2 "float scale" 3
Rotate -20 1 2 3
MediumInterface "" "fog"
Camera "perspective" "float fov" 33.3 "float lensradius" .01 "float focaldistance" 7 "float screenwindow" [-1 1.5 -2 2.5] "float frameaspectratio" 1.1
WorldBegin
Rotate 33 1 2 3
LightSource "point" "rgb I" [1 2 3] "point from" [4 5 6]
LightSource "spot" "rgb I" [1 2 3] "point from" [4 5 6] "point to" [-1 .3 2] "float coneangle" 33.3 "float conedeltaangle" 4.7
LightSource "distant" "blackbody L" [4000 2] "point from" [4 5 6]
LightSource "infinite" "rgb L" [.1 .2 .3] "string mapname" "sky.exr"
LightSource "goniometric" "string mapname" "/maps/lamp.exr"
LightSource "projection" "string mapname" "sky.exr" "float fov" 12
Texture "chk" "float" "checkerboard" "float tex1" .2 "float uscale" 3
Texture "chk" "spectrum" "checkerboard" "rgb tex1" [1 0 0] "integer dimension" 3
Texture "img" "spectrum" "imagemap" "string filename" "wood.png" "string wrap" "black" "bool gamma" "false" "float scale" 2 "string mapping" "spherical"
Texture "bumps" "float" "imagemap" "string filename" "wood.png" "string mapping" "planar" "vector v1" [1 2 3]
Texture "mixed" "spectrum" "mix" "texture tex1" "img" "texture tex2" "chk" "texture amount" "chk"
Texture "scaled" "spectrum" "scale" "texture tex1" "mixed" "rgb tex2" [.5 .6 .7]
Texture "dots" "spectrum" "dots" "texture inside" "scaled" "string mapping" "cylindrical"
Texture "marble" "spectrum" "marble" "integer octaves" 4
Texture "fbm" "float" "fbm" Texture "wrinkled" "float" "wrinkled" Texture "windy" "float" "windy"
Texture "uv" "spectrum" "uv" Texture "bilerp" "spectrum" "bilerp" "rgb v00" [.1 .2 .3]
MakeNamedMaterial "a" "string type" "matte" "texture Kd" "dots" "texture sigma" "chk" "texture bumpmap" "bumps"
MakeNamedMaterial "b" "string type" "metal" "spectrum eta" "Au.eta.spd" "texture uroughness" "fbm" "texture normal_map" "img" "float normal_strength" .7 "bool normal_right_handed" true
MakeNamedMaterial "mix" "string type" "mix" "string namedmaterial1" "a" "string namedmaterial2" "b" "texture amount" "marble"
AttributeBegin MakeNamedMaterial "a" "string type" "glass" "float eta" 1.4 "bool thin" true NamedMaterial "a" Shape "disk" AttributeEnd
NamedMaterial "mix"
AttributeBegin AreaLightSource "diffuse" "rgb L" [5 6 7] "bool twosided" true ReverseOrientation Shape "cylinder" "float phimax" 77 AttributeEnd
AttributeBegin AreaLightSource "diffuse" "texture L" "uv" "rgb scale" [3 3 3] Shape "cone" AttributeEnd
AttributeBegin Material "none" MediumInterface "fog" "" Shape "sphere" "float zmax" .4 "texture alpha" "windy" AttributeEnd
AttributeBegin Material "none" MediumInterface "smoke" "dye" Shape "sphere" AttributeEnd
Material "uber" "texture Kr" "bilerp" Shape "paraboloid" "float shadowalpha" 0
Material "disney" "texture color" "marble" "texture roughness" "wrinkled" Shape "hyperboloid"
Material "plastic" Shape "trianglemesh" "integer indices" [0 1 2] "point P" [0 0 0 1 .1 0 0 1 .3] "rgb Kd" [.3 .2 .1]
Material "substrate" Shape "trianglemesh" "integer indices" [0 1 2] "point P" [0 0 0 1 .1 0 0 1 .3] "vector S" [1 0 0 1 0 0 1 0 0] "integer ajar:handedness" [1 -1 0] "normal N" [0 0 1 0 0 1 0 0 1] "float uv" [0 0 1 0 0 .3]
Material "translucent" Shape "loopsubdiv" "integer levels" 2 "integer indices" [0 1 2] "point P" [0 0 0 1 .1 0 0 1 .3]
Material "mirror" Shape "curve" "string basis" "bspline" "string type" "ribbon" "float width0" .1 "float width1" .7
  "point P" [0 0 0 1 .1 0 0 1 .3 2 1 .7 3.3 1 1] "normal N" [0 1 0 0 .6 .8 1 0 0]
ObjectBegin "thing" Translate .1 .2 .3 Shape "trianglemesh" "integer indices" [0 1 2] "point P" [0 0 0 1 .1 0 0 1 .4] ObjectEnd
AttributeBegin Scale 1 2 3 ObjectInstance "thing" AttributeEnd ObjectInstance "thing"
WorldEnd
)";

TEST(PbrtWriter, RoundTripsTheSameScene) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "scene");
  { std::ofstream(folder.path() / "scene/in.pbrt") << kEverything; }
  Warnings warnings;
  const desc::SceneDesc scene = import_pbrt((folder.path() / "scene/in.pbrt").string(), warnings);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  const std::string out = (folder.path() / "out.pbrt").string();
  write_pbrt(scene, out);
  const desc::SceneDesc back = import_pbrt(out, warnings);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  EXPECT_EQ(desc::hash(back), desc::hash(scene));
  EXPECT_EQ(back.shapes.size(), scene.shapes.size());
  EXPECT_EQ(back.film.filename, "a \"b\".exr");
  EXPECT_EQ(back.hints.integrator, "mmlt");
  EXPECT_EQ(back.hints.max_depth, 10);
  EXPECT_EQ(back.hints.samples_per_pixel, 5);
  EXPECT_EQ(back.hints.parameters, scene.hints.parameters);
  EXPECT_EQ(back.lights[3].node.text("image"), (folder.path() / "scene/sky.exr").string());
}

TEST(PbrtWriter, WritesADefaultDepth) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "scene.pbrt").string();
  desc::SceneDesc scene;
  scene.shapes.emplace_back().node = desc::shape_node("sphere");
  write_pbrt(scene, file);
  Warnings warnings;
  // Without it, readers would stop after five bounces.
  EXPECT_EQ(import_pbrt(file, warnings).hints.max_depth, desc::RenderHints::kDefaultMaxDepth);
}

/// A scene with a medium, there and back.
desc::Medium written_and_read(const desc::Medium& medium) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "scene.pbrt").string();
  desc::SceneDesc scene;
  scene.shapes.emplace_back().node = desc::shape_node("sphere");
  scene.media.push_back(medium);
  write_pbrt(scene, file);
  Warnings warnings;
  desc::SceneDesc back = import_pbrt(file, warnings);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << message;
  return back.media.at(0);
}

/// Coefficients of both at places in the box.
void expect_same_colors(const desc::Medium& a, const desc::Medium& b) {
  const auto field = [](const desc::Medium& m) {
    return ColorField(*m.density, Spectrum(m.sigma_a.x, m.sigma_a.y, m.sigma_a.z),
                      Spectrum(m.sigma_s.x, m.sigma_s.y, m.sigma_s.z));
  };
  const ColorField first = field(a);
  const ColorField second = field(b);
  for (int i = 0; i < 343; ++i) {
    const Vec3 in_cube =
        Vec3(static_cast<float>(i % 7), static_cast<float>(i / 7 % 7), static_cast<float>(i / 49)) /
            6.2F +
        Vec3(0.01F);
    const Vec3 p = transform_point(a.density->to_world, in_cube);
    for (int lane = 0; lane < 3; ++lane) {
      ASSERT_NEAR(first.sigma_t(p)[lane], second.sigma_t(p)[lane], 1e-5F) << in_cube;
      ASSERT_NEAR(first.sigma_s(p)[lane], second.sigma_s(p)[lane], 1e-5F) << in_cube;
    }
  }
  for (const float at : {-0.01F, 1.01F}) {
    const Vec3 p = transform_point(a.density->to_world, Vec3(0.4F, at, 0.6F));
    EXPECT_NEAR(second.sigma_t(p)[0], first.sigma_t(p)[0], 1e-5F) << "beyond the box";
  }
}

TEST(PbrtWriter, WritesColorsOfMediaWhateverTheirGrid) {
  using Grid = desc::DensityGrid;
  for (const auto points : {Grid::Points::Centers, Grid::Points::Corners}) {
    for (const auto border : {Grid::Border::Zero, Grid::Border::Clamp}) {
      for (const std::string given : {"both", "absorption", "scattering"}) {
        for (const desc::Rgb& sigma : {desc::Rgb(0.7F), desc::Rgb(1.F, 0.5F, 0.F)}) {
          SCOPED_TRACE(given);
          desc::Medium medium;
          medium.sigma_a = medium.sigma_s = sigma;
          medium.g = 0.5F;
          Grid grid{{2, 3, 2}, {}, points, border};
          for (int i = 0; i < 12; ++i) {
            const auto x = static_cast<float>(i);
            if (given != "scattering") grid.absorption.emplace_back(x, 1.F, 12.F - x);
            if (given != "absorption") grid.scattering.emplace_back(1.F, x, 2.F);
          }
          Mat4 to_world = Mat4().setScale(Vec3d(2, 3, 4));
          to_world[3][0] = -1;
          medium.density = {std::make_shared<const Grid>(std::move(grid)), to_world};
          const desc::Medium back = written_and_read(medium);
          EXPECT_EQ(back.g, medium.g);
          expect_same_colors(medium, back);
        }
      }
    }
  }
}

TEST(PbrtWriter, GridsKeepTheirBoundsInLargerShapes) {
  using Grid = desc::DensityGrid;
  for (const auto points : {Grid::Points::Centers, Grid::Points::Corners}) {
    for (const auto border : {Grid::Border::Zero, Grid::Border::Clamp}) {
      desc::SceneDesc scene;
      scene.shapes.emplace_back().node = desc::shape_node("sphere");
      desc::Medium& medium = scene.media.emplace_back();
      Grid grid{{2, 3, 2}, {}, points, border};
      for (int i = 0; i < 12; ++i) grid.values.push_back(static_cast<float>(i));
      medium.density = {std::make_shared<const Grid>(std::move(grid)), Mat4()};
      const desc::Density back = *written_and_read(medium).density;
      EXPECT_EQ(back.to_world, Mat4());
      EXPECT_EQ(back.grid->resolution, medium.density->grid->resolution);
      EXPECT_EQ(back.grid->values, medium.density->grid->values);
      EXPECT_EQ(back.grid->points, points);
      EXPECT_EQ(back.grid->border, border);
    }
  }
}

TEST(PbrtWriter, LeavesNoTemporaryFilesAndRefersToImagesRelatively) {
  const TemporaryFolder folder;
  Warnings warnings;
  const desc::SceneDesc scene =
      import_pbrt_text(kEverything, "x.pbrt", folder.path().string(), warnings);
  write_pbrt(scene, (folder.path() / "sub.pbrt").string());
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos);
  }
  std::ifstream in(folder.path() / "sub.pbrt");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_NE(text.find("\"string filename\" \"wood.png\""), std::string::npos);
}

TEST(PbrtWriter, FoldersThatDoNotExistAreErrors) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(world(""), warnings);
  EXPECT_THROW(write_pbrt(scene, "/nonexistent/folder/x.pbrt"), IoError);
}

TEST(SceneHash, ChangesWithThePictureAndNotWithNames) {
  const auto hash_of = [](const std::string& text) {
    Warnings warnings;
    return desc::hash(import_with(text, warnings));
  };
  const std::string base = kEverything;
  const std::uint64_t original = hash_of(base);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = base;
    text.replace(text.find(from), from.size(), to);
    return hash_of(text);
  };
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"[.4 .5 .6]", "[.4 .5 .7]"},
           {"[0 .1 .2 .7]", "[0 .1 .2 .8]"},
           {"[.1 .2 .3 .4 .5 .6]", "[.1 .2 .3 .4 .5 .7]"},
           {"\"rgb sigma_a\" [.1 .2 .3 .4", "\"rgb sigma_s\" [.1 .2 .3 .4"},
           {"[-1 -2 0]", "[-1 -2 1]"},
           {"\"float fov\" 33.3", "\"float fov\" 33.4"},
           {"1.1 2.2 3.3", "1.1 2.2 3.4"},
           {"\"float phimax\" 77", "\"float phimax\" 78"},
           {"1 .1 0 0 1 .3", "1 .1 0 0 1 .31"},
           {"[.5 .6 .7]", "[.5 .6 .71]"},
           {"wood.png", "oak.png"},
           {"\"integer xresolution\" 31", "\"integer xresolution\" 32"},
           {"\"float B\" .2", "\"float B\" .3"},
           {"ReverseOrientation", ""},
           {"\"bool twosided\" true", ""},
           {"\"float conedeltaangle\" 4.7", "\"float conedeltaangle\" 4.8"},
           {"Scale 1 2 3 ObjectInstance", "Scale 1 2 4 ObjectInstance"},
           {"\"integer octaves\" 4", "\"integer octaves\" 5"}}) {
    EXPECT_NE(changed(from, to), original) << from;
  }
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"a \\\"b\\\".exr", "other.exr"},
           {"\"integer maxdepth\" 9", "\"integer maxdepth\" 3"},
           {"WorldBegin", "\n\nWorldBegin # comment"},
           {"WorldBegin", "WorldBegin MakeNamedMaterial \"unused\" \"string type\" \"mirror\""}}) {
    EXPECT_EQ(changed(from, to), original) << from;
  }
}

TEST(PbrtWriter, WritesEmbeddedFilesBeside) {
  TemporaryFolder folder;
  desc::SceneDesc scene = scene_of("");
  scene.embedded_files["room.abc/oak.png"] = std::make_shared<const std::string>("the bytes");
  scene.textures.emplace_back().node =
      desc::texture_node("image", {{"file", std::string("room.abc/oak.png")}});
  const desc::TextureRef oak{static_cast<desc::TextureId>(scene.textures.size()) - 1};
  scene.materials.emplace_back().node = desc::material_node("diffuse", {{"reflectance", oak}});
  const fs::path out = folder.path() / "room.pbrt";
  write_pbrt(scene, out.string());
  Warnings warnings;
  const desc::SceneDesc back = import_pbrt(out.string(), warnings);
  ASSERT_EQ(back.textures.size(), 1U);
  const std::string& file = back.textures[0].node.text("file");
  EXPECT_EQ(fs::path(file).parent_path(), folder.path() / "room_images");
  EXPECT_EQ(fs::path(file).extension(), ".png");
  EXPECT_EQ(read_file(file).view(), "the bytes");
  // Others stay as they are, whatever the current scene.
  scene.embedded_files["room.abc/oak.png"] = std::make_shared<const std::string>("other bytes");
  write_pbrt(scene, out.string());
  EXPECT_EQ(read_file(file).view(), "the bytes");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "room_images"), {}), 2);
  std::ofstream(file) << "something else";
  scene.embedded_files["room.abc/oak.png"] = std::make_shared<const std::string>("the bytes");
  EXPECT_THROW(write_pbrt(scene, out.string()), IoError);
  EXPECT_EQ(read_file(file).view(), "something else");
}

}  // namespace
}  // namespace ajar
