#include "import/mesh/obj.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

using Triangle = Imath::Vec3<unsigned>;

std::string obj_error_in(std::string_view bytes) {
  try {
    read_obj(bytes, "m.obj");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Obj, PolygonsAreFannedAndTextureCoordinatesKept) {
  const desc::Mesh mesh = read_obj(
      "# a quad\nmtllib none.mtl\no quad\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvt 1 0\n"
      "vt 1 1\nvt 0 0.25\nvn 0 0 1\nusemtl red\ns off\nf 1/1/1 2/2/1 3/3/1 4/4/1\n",
      "m.obj");
  ASSERT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.positions[3], Vec3(0.F, 1.F, 0.5F));
  EXPECT_EQ(mesh.uvs[3], Vec2(0.F, 0.25F));
  EXPECT_EQ(mesh.normals, std::vector<Vec3>(4, Vec3(0.F, 0.F, 1.F)));
  EXPECT_EQ(mesh.indices, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Obj, PolygonsWithADentAreCutAtIt) {
  // A fan from the first corner would cover (0 0.5 0), which is outside.
  const desc::Mesh mesh =
      read_obj("v 0 2 0\nv -1 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 0\nf 2 3 4 1\n", "m.obj");
  double area = 0.0;
  for (const Triangle& t : mesh.indices) {
    const Vec3 a = mesh.positions[t.x];
    area += 0.5F * cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a).z;
  }
  EXPECT_EQ(mesh.indices.size(), 2U);
  EXPECT_NEAR(area, 1.0, 1e-6);
  for (const Triangle& t : mesh.indices) EXPECT_TRUE(t.x == 1 || t.y == 1 || t.z == 1) << t;
}

TEST(Obj, NegativeIndicesCountBackwardsFromTheFace) {
  const desc::Mesh mesh = read_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\n", "m.obj");
  ASSERT_EQ(mesh.positions.size(), 6U);
  EXPECT_EQ(mesh.positions[3], Vec3(5.F, 0.F, 0.F));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.uvs.empty());
}

TEST(Obj, CornersShareVerticesOnlyIfAllTheirIndicesAgree) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\n";
  const auto count = [&](const std::string& faces) {
    return read_obj(vertices + faces, "m.obj").positions.size();
  };
  EXPECT_EQ(count("f 1 2 3\nf 1 3 4\n"), 4U);
  EXPECT_EQ(count("f 1/1 2/1 3/1\nf 1/2 3/1 4/1\n"), 5U);
}

TEST(Obj, NormalsAreLeftOutUnlessAllCornersHaveThem) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n";
  EXPECT_EQ(read_obj(vertices + "f 1//1 2//1 3//1\n", "m.obj").normals.size(), 3U);
  EXPECT_TRUE(read_obj(vertices + "f 1//1 2//1 3//1\nf 1 3 4\n", "m.obj").normals.empty());
}

TEST(Obj, ReadsLineEndsOfAnySystemAndAFileWithoutTheLastOne) {
  for (const std::string end : {"\r\n", "\n", "\r"}) {
    const std::string text = "v 0 0 0" + end + "v 1 0 0" + end + "v 0 1 0" + end + "f 1 2 3";
    EXPECT_EQ(read_obj(text, "m.obj").indices.size(), 1U);
    EXPECT_EQ(obj_error_in(text + end + "f 1 2 9"), "m.obj:5:7: this face refers to vertex 9 of 3");
  }
  EXPECT_EQ(
      read_obj("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n", "m.obj").indices.size(), 1U)
      << "a byte order mark, and a line that goes on";
}

TEST(Obj, ReadsNumbersAsTheyAreWritten) {
  const desc::Mesh mesh = read_obj(
      "v  1e2\t-.5 +3 0.5 0.5\nv 0 1 0\nv 0 0 1 # last\nvt .25\nf 1/1 2/1 3/1 # all\n", "m.obj");
  EXPECT_EQ(mesh.positions[0], Vec3(100.F, -0.5F, 3.F));
  EXPECT_EQ(mesh.uvs[0], Vec2(0.25F, 0.F));
  EXPECT_EQ(obj_error_in("v 1 2\n"), "m.obj:1:6: here a number is missing");
  EXPECT_EQ(obj_error_in("\nv 1 2 3,5\n"), "m.obj:2:7: this is no number: \"3,5\"");
}

TEST(Obj, ManyCornersKeepTheirVertices) {
  // A strip long enough that the table of corners grows many times.
  constexpr unsigned kCount = 5000;
  std::string text;
  for (unsigned i = 0; i < kCount; ++i) text += "v " + std::to_string(i) + " 0 0\n";
  for (unsigned i = 3; i <= kCount; ++i)
    text += "f -" + std::to_string(i) + " -" + std::to_string(i - 1) + " -" +
            std::to_string(i - 2) + "\n";
  const desc::Mesh mesh = read_obj(text, "m.obj");
  ASSERT_EQ(mesh.positions.size(), kCount);
  ASSERT_EQ(mesh.indices.size(), kCount - 2);
  for (const Triangle& t : mesh.indices) {
    EXPECT_EQ(mesh.positions[t.y].x, mesh.positions[t.x].x + 1.F);
    EXPECT_EQ(mesh.positions[t.z].x, mesh.positions[t.x].x + 2.F);
  }
}

/// Half of the light is 188 of 255.
TEST(Obj, ColorsOfVerticesAreThoseOfADisplay) {
  std::string odd;
  const auto ignore = [](const SourceLocation&, std::string_view) {};
  const ObjEvents events = {ignore, ignore,
                            [&](const SourceLocation& where, std::string_view text) {
                              odd += where.to_string() + ": " + std::string(text);
                            }};
  const auto colors_of = [&](const std::string& vertices) {
    return read_obj_parts(vertices + "f 3 2 1\n", "m.obj", events).at(0).colors;
  };
  for (const auto& [full, half] : {std::pair("1", "0.7374"), std::pair("255", "188")}) {
    const auto vertex = [](const std::string& color) { return "v 0 0 0 " + color + "\n"; };
    const std::vector<Vec3> colors =
        colors_of(vertex(std::string(full) + " 0 " + half) + "v 1 0 0\n" +
                  vertex("1.0 0 0 " + std::string(half) + " # weight before the colour"));
    ASSERT_EQ(colors.size(), 3U);
    EXPECT_NEAR(colors[0].z, 0.503F, 2e-3F);
    EXPECT_EQ(colors[0].x, 0.F);
    EXPECT_EQ(colors[1], Vec3(1.F)) << "has none";
    EXPECT_EQ(colors[2].x, 1.F);
    EXPECT_EQ(colors[2].y, 0.F);
  }
  EXPECT_TRUE(colors_of("v 0 0 0\nv 1 0 0 0.5\nv 1 1 0\n").empty()) << "weights alone";
  EXPECT_EQ(odd, "");
  EXPECT_TRUE(colors_of("v 0 0 0 1 2\nv 1 0 0\nv 1 1 0\n").empty());
  EXPECT_EQ(odd, "m.obj:1:1: 1 2");
}

TEST(Obj, FacesThatReferToNothingAreErrors) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
  EXPECT_EQ(obj_error_in(vertices + "f 1 2 3\nf 1 2 4\n"),
            "m.obj:6:7: this face refers to vertex 4 of 3");
  EXPECT_EQ(obj_error_in(vertices + "f 1 2 -4\n"), "m.obj:5:7: this face refers to vertex -4 of 3");
  EXPECT_EQ(obj_error_in(vertices + "f 1//1 2//1 3//2\n"),
            "m.obj:5:13: this face refers to normal 2 of 1");
  EXPECT_EQ(obj_error_in(vertices + "f 1 2 three\n"),
            "m.obj:5:7: this is no corner of a face: \"three\"");
  EXPECT_EQ(obj_error_in(vertices + "f 1/1/1/1 2 3\n"),
            "m.obj:5:3: this is no corner of a face: \"1/1/1/1\"");
  EXPECT_EQ(obj_error_in(vertices), "m.obj: there are no faces in this file");
  EXPECT_EQ(obj_error_in(""), "m.obj: there are no faces in this file");
}

}  // namespace
}  // namespace ajar
