#include "import/mesh/obj.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

using Triangle = Imath::Vec3<unsigned>;

std::string error_in(std::string_view bytes) {
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
  EXPECT_EQ(read_obj("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3", "m.obj").indices.size(), 1U);
}

TEST(Obj, FacesThatReferToNothingAreErrors) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
  EXPECT_EQ(error_in(vertices + "f 1 2 3\nf 1 2 4\n"),
            "m.obj: face 2 refers to vertex 4, but there are 3 before it");
  EXPECT_EQ(error_in(vertices + "f 1 2 -4\n"),
            "m.obj: face 1 refers to vertex -4, but there are 3 before it");
  EXPECT_EQ(error_in(vertices + "f 1//1 2//1 3//2\n"),
            "m.obj: face 1 refers to normal 2, but there are 1 before it");
  EXPECT_EQ(error_in(vertices + "f 1 2 three\n"),
            "m.obj: face 1 has a corner that is not a vertex number");
  EXPECT_EQ(error_in(vertices), "m.obj: there are no faces in this file");
  EXPECT_EQ(error_in(""), "m.obj: there are no faces in this file");
}

}  // namespace
}  // namespace ajar
