#include "import/stl/stl.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/error.h"

namespace ajar {
namespace {

using Triangle = Imath::Vec3<unsigned>;

std::string binary(std::uint32_t count, std::uint32_t written) {
  std::string bytes(80, 'h');
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (std::uint32_t i = 0; i < written; ++i) {
    const float numbers[12] = {9, 9, 9, static_cast<float>(i), 0, 0, 1, 0, 0, 0, 1, 0};
    bytes.append(reinterpret_cast<const char*>(numbers), 48);
    bytes.append(2, '\xff');
  }
  return bytes;
}

std::string error_of(std::string_view bytes) {
  try {
    read_stl(bytes, "a.stl");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

const std::string kAscii =
    "solid a name\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex +1e0 0 0\n"
    "   vertex 0 1.5 -2\n  endloop\n endfacet\nendsolid a name\n";

TEST(Stl, BinaryTrianglesAreReadWithoutTheirNormals) {
  const desc::Mesh mesh = read_stl(binary(2, 2), "a.stl");
  EXPECT_EQ(mesh.positions.size(), 6U);
  EXPECT_EQ(mesh.positions[3], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[5], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.indices, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(Stl, BinaryHeadersMayBeginLikeAscii) {
  std::string bytes = binary(1, 1);
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_stl(bytes, "a.stl").indices.size(), 1U);
}

TEST(Stl, BinaryFilesThatEndEarlySayWhatIsMissing) {
  EXPECT_EQ(error_of(binary(3, 2)),
            "a.stl: the file ends early: 3 triangles need 234 bytes, and there are 184");
  EXPECT_TRUE(error_of(binary(0xffffffffU, 1)).find("ends early") != std::string::npos);
  EXPECT_TRUE(error_of("").find("no STL file") != std::string::npos);
}

TEST(Stl, AsciiTrianglesAreRead) {
  const desc::Mesh mesh = read_stl(kAscii + kAscii, "a.stl");
  EXPECT_EQ(mesh.indices.size(), 2U);
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[5], Vec3(0, 1.5F, -2));
}

TEST(Stl, AsciiErrorsHaveLineAndColumn) {
  std::string text = kAscii;
  text.replace(text.find("+1e0"), 4, "one!");
  EXPECT_EQ(error_of(text), "a.stl:5:11: expected a number, found \"one!\"");
  EXPECT_EQ(error_of(kAscii.substr(0, 60)).substr(0, 8), "a.stl:4:");
  EXPECT_EQ(error_of("solid x\nfacet"),
            "a.stl:2:6: expected \"normal\", found the end of the file");
}

}  // namespace
}  // namespace ajar
