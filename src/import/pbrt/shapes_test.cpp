// Shapes and mesh files: pbrt-v3's defaults and meanings.
#include <gtest/gtest.h>

#include <algorithm>

#include "import/pbrt/import_test_support.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

TEST(PbrtShapes, QuadricsHaveTheDefaultsOfPbrt) {
  const desc::SceneDesc s = scene_of(
      "Shape \"sphere\" \"float radius\" 2 Shape \"sphere\" \"float radius\" 2 \"float zmin\" -9 "
      "\"float zmax\" 1 \"float phimax\" 90 "
      "Shape \"cylinder\" Shape \"disk\" Shape \"cone\" Shape \"paraboloid\" Shape "
      "\"hyperboloid\"");
  const auto node = [&](std::size_t i) { return s.shapes[i].node; };
  EXPECT_EQ(node(0), desc::shape_node("sphere", {{"radius", 2.F}})) << "whole";
  EXPECT_EQ(node(1),
            desc::shape_node(
                "sphere", {{"radius", 2.F}, {"z_min", -9.F}, {"z_max", 1.F}, {"phi_max", 90.F}}));
  EXPECT_EQ(node(2).number("z_min"), -1.F);
  EXPECT_EQ(node(3).number("inner_radius"), 0.F);
  EXPECT_EQ(node(4).number("height"), 1.F);
  EXPECT_EQ(node(5).number("z_max"), 1.F);
  EXPECT_EQ(node(6).vector("p2"), Vec3(1.F));
}

TEST(PbrtShapes, WarnWhyTheyAreInvisible) {
  for (const auto& [shape, reason] :
       {std::pair("\"sphere\" \"float radius\" -1", "the radius is not positive"),
        std::pair("\"sphere\" \"float zmin\" 3 \"float zmax\" 2", "zmin equals zmax"),
        std::pair("\"disk\" \"float innerradius\" 3",
                  "the inner radius is not between 0 and the radius"),
        std::pair("\"cylinder\" \"float zmin\" 1", "zmin equals zmax"),
        std::pair("\"cone\" \"float height\" 0", "radius or height is not positive"),
        std::pair("\"paraboloid\" \"float zmax\" -1", "radius or zmax is not positive"),
        std::pair("\"hyperboloid\" \"point p1\" [1 1 1]", "p1 equals p2")}) {
    EXPECT_TRUE(contains(warnings_of(world("Shape " + std::string(shape))),
                         "2:1: " + std::string(reason) + ": shape left out"))
        << shape;
  }
  EXPECT_TRUE(contains(error_of(world("Shape \"spheer\"")),
                       "unknown shape \"spheer\"; did you mean \"sphere\"?"));
}

TEST(PbrtShapes, ImpossibleOnesAreLeftOutWithAWarning) {
  for (const char* shape : {"\"sphere\" \"float radius\" -1", "\"disk\" \"float innerradius\" 3",
                            "\"nurbs\"", "\"curve\""}) {
    Warnings warnings;
    const desc::SceneDesc s = import_with(world("Shape " + std::string(shape)), warnings);
    EXPECT_EQ(s.shapes.size(), 1U) << shape;
    EXPECT_GE(warnings.count(), 1U) << shape;
  }
  EXPECT_TRUE(contains(warnings_of(world("AttributeBegin Scale 1 0 1 Shape \"disk\" AttributeEnd")),
                       "cannot be inverted: shape left out"));
}

TEST(PbrtShapes, TriangleMeshesHaveTheirAttributes) {
  const desc::SceneDesc s = scene_of(
      "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0] \"normal "
      "N\" [0 0 1 0 0 1 0 0 1] "
      "\"vector S\" [1 0 0 1 0 0 1 0 0] \"float uv\" [0 0 1 0 0 1]");
  const auto& mesh = *s.shapes[0].node.mesh("mesh");
  EXPECT_EQ(mesh.positions[1], Vec3(1.F, 0.F, 0.F));
  EXPECT_EQ(mesh.normals.size(), 3U);
  EXPECT_EQ(mesh.tangents.size(), 3U);
  EXPECT_EQ(mesh.uvs[2], Vec2(0.F, 1.F));
  for (const char* uv : {"\"point2 uv\"", "\"point2 st\"", "\"float st\""}) {
    const desc::SceneDesc t = scene_of(
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0 1 0 0 0 1 0] " +
        std::string(uv) + " [0 0 1 0 0 1]");
    EXPECT_EQ(t.shapes[0].node.mesh("mesh")->uvs.size(), 3U) << uv;
  }
}

TEST(PbrtShapes, WrongMeshesAreLocatedErrors) {
  const std::string p = "\"point P\" [0 0 0 1 0 0 0 1 0 1 1 0]";
  EXPECT_TRUE(
      contains(error_of(world("\n Shape \"trianglemesh\" \"integer indices\" [0 1 4] " + p)),
               "test.pbrt:3:2: mesh triangle 0 refers to vertex 4 of 4"));
  EXPECT_TRUE(contains(error_of(world("Shape \"trianglemesh\" \"integer indices\" [0 1 -1] " + p)),
                       "refers to vertex -1"));
  EXPECT_TRUE(contains(error_of(world("Shape \"trianglemesh\" \"integer indices\" [0 1 2]")),
                       "needs \"point P\""));
  EXPECT_TRUE(
      contains(error_of(world("Shape \"trianglemesh\" " + p)), "needs \"integer indices\""));
  EXPECT_TRUE(contains(
      error_of(
          world("Shape \"loopsubdiv\" \"integer levels\" 100 \"integer indices\" [0 1 2] " + p)),
      "make no sense"));
  const std::string flat =
      warnings_of(world("Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 0 1 1 1 1] " + p));
  EXPECT_EQ(flat, "test.pbrt:2:1: 2 of 3 triangles have no area: dropped\n");
}

const std::string kTriangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(PbrtShapes, MeshFilesAreReadOnceAndShared) {
  const desc::SceneDesc s = scene_of(
      "Shape \"plymesh\" \"string filename\" \"m/tri.ply\" Shape \"plymesh\" \"string filename\" "
      "\"m/tri.ply\"",
      {{"m/tri.ply", kTriangle}});
  const auto a = s.shapes[0].node.mesh("mesh");
  const auto b = s.shapes[1].node.mesh("mesh");
  EXPECT_EQ(a, b);
  EXPECT_EQ(a->indices.size(), 1U);
  EXPECT_EQ(s.shapes[0].name, "tri");
}

TEST(PbrtShapes, ThoseOfBadMeshFilesAreLeftOutWithAWarning) {
  const std::string two = world(
      "Shape \"plymesh\" \"string filename\" \"a.ply\"\nShape \"plymesh\" \"string filename\" "
      "\"b.ply\"");
  const std::string none = warnings_of(two);
  EXPECT_TRUE(contains(none, "test.pbrt:2:1: cannot use this mesh: cannot open")) << none;
  EXPECT_TRUE(contains(none, "test.pbrt:3:1: cannot use this mesh: cannot open")) << none;
  std::string bad = kTriangle;
  bad.replace(bad.find("3 0 1 2"), 7, "3 0 1 7");
  EXPECT_EQ(warnings_of(two, {{"a.ply", kTriangle}, {"b.ply", bad}}),
            "test.pbrt:3:1: cannot use this mesh: b.ply: mesh triangle 0 refers to vertex 7 of 3: "
            "left out\n");
  const std::string cut =
      warnings_of(two, {{"a.ply", kTriangle.substr(0, kTriangle.size() - 6)}, {"b.ply", bad}});
  EXPECT_TRUE(contains(cut, "test.pbrt:2:1: cannot use this mesh: a.ply: the file")) << cut;

  Warnings warnings;
  const desc::SceneDesc s = import_with(two, warnings, {{"a.ply", kTriangle}});
  ASSERT_EQ(s.shapes.size(), 2U);  // the sphere of every world, and one of two
  EXPECT_EQ(s.shapes[0].name, "a");
}

TEST(PbrtShapes, MissingMeshOfALampIsOneWarning) {
  const std::string told = warnings_of(
      "Film \"rgb\" Camera \"perspective\" WorldBegin Shape \"sphere\" AreaLightSource \"diffuse\" "
      "\"float power\" 100 Shape \"plymesh\" \"string filename\" \"a.ply\"");
  EXPECT_TRUE(contains(told, "cannot use this mesh")) << told;
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
}

TEST(PbrtShapes, CurvesBecomeBezierSegments) {
  const desc::SceneDesc s = scene_of(
      "Shape \"curve\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0 6 0 0] \"float width0\" 1 "
      "\"float width1\" 3 \"string type\" \"cylinder\" "
      "\"integer splitdepth\" 3");
  const auto& curve = *s.shapes[0].node.curves("curves");
  EXPECT_EQ(s.shapes[0].node.text("type"), "cylinder");
  ASSERT_EQ(curve.control_points.size(), 8U);
  EXPECT_EQ(curve.control_points[4], Vec3(3.F, 0.F, 0.F));
  EXPECT_EQ(curve.widths.front(), 1.F);
  EXPECT_EQ(curve.widths[3], 2.F);
  EXPECT_EQ(curve.widths.back(), 3.F);
}

TEST(PbrtShapes, SplinesAndQuadraticsAreTheSameCurve) {
  // A straight line with evenly spaced controls: every form gives evenly spaced points on it.
  for (const char* form : {"\"integer degree\" 2 \"point P\" [0 0 0 1.5 0 0 3 0 0]",
                           "\"string basis\" \"bspline\" \"point P\" [-3 0 0 0 0 0 3 0 0 6 0 0]",
                           "\"string basis\" \"bspline\" \"integer degree\" 2 \"point P\" [-1.5 0 "
                           "0 1.5 0 0 4.5 0 0]"}) {
    const desc::SceneDesc s = scene_of("Shape \"curve\" " + std::string(form));
    const auto& curve = *s.shapes[0].node.curves("curves");
    ASSERT_EQ(curve.control_points.size(), 4U);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(curve.control_points[static_cast<std::size_t>(i)].x, static_cast<float>(i), 1e-5F)
          << form;
  }
}

TEST(PbrtShapes, RibbonsTurnTheirNormalsEvenly) {
  const desc::SceneDesc s = scene_of(
      "Shape \"curve\" \"string type\" \"ribbon\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0] \"normal "
      "N\" [0 1 0 0 0 1]");
  const auto& curve = *s.shapes[0].node.curves("curves");
  ASSERT_EQ(curve.normals.size(), 4U);
  EXPECT_NEAR(dot(curve.normals[0], curve.normals[1]), std::cos(kPi / 6.F), 1e-5F);
  EXPECT_NEAR(dot(curve.normals[1], curve.normals[3]), std::cos(kPi / 3.F), 1e-5F);
  EXPECT_TRUE(contains(
      warnings_of(world(
          "Shape \"curve\" \"string type\" \"ribbon\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]")),
      "needs 2 normals"));
}

TEST(PbrtShapes, HeightFieldsAndSubdivisionSurfaces) {
  const desc::SceneDesc s = scene_of(
      "Shape \"heightfield\" \"integer nu\" 3 \"integer nv\" 2 \"float Pz\" [0 1 2 3 4 5] "
      "Shape \"loopsubdiv\" \"integer nlevels\" 2 \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 "
      "0 0 0 1 0]");
  const auto& field = *s.shapes[0].node.mesh("mesh");
  EXPECT_EQ(field.indices.size(), 4U);
  EXPECT_EQ(field.positions[5], Vec3(1.F, 1.F, 5.F));
  EXPECT_EQ(s.shapes[1].node.integer("levels"), 2);
  EXPECT_TRUE(contains(
      error_of(world(
          "Shape \"heightfield\" \"integer nu\" 1000000 \"integer nv\" 1000000 \"float Pz\" [1]")),
      "2:1"));
}

TEST(PbrtShapes, AlphaIsATextureOrAConstantZero) {
  const desc::SceneDesc s = scene_of(
      "Texture \"a\" \"float\" \"checkerboard\" Shape \"disk\" \"texture alpha\" \"a\" \"float "
      "shadowalpha\" 0 Shape \"disk\" \"float alpha\" .5");
  const auto alpha = static_cast<std::size_t>(s.shapes[0].alpha);
  EXPECT_TRUE(s.textures.at(alpha).node.is("checkerboard"));
  expect_rgb(constant(s, s.shapes[0].shadow_alpha), desc::Rgb(0.F));
  EXPECT_EQ(s.shapes[1].alpha, desc::kNone);
}

}  // namespace
}  // namespace ajar
