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
    bytes.append(2, '\x7f');
  }
  return bytes;
}

std::string stl_error(std::string_view bytes) {
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
  const desc::Mesh mesh = read_stl(binary(2, 2), "a.stl").mesh;
  EXPECT_EQ(mesh.positions.size(), 6U);
  EXPECT_EQ(mesh.positions[3], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[5], Vec3(0, 1, 0));
  EXPECT_EQ(mesh.indices, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(Stl, ColorsOfTrianglesAreWrittenInTwoWays) {
  const auto with_bits = [](std::uint16_t first, std::uint16_t second, const std::string& header) {
    std::string bytes = binary(2, 2);
    bytes.replace(10, header.size(), header);
    std::memcpy(bytes.data() + 84 + 48, &first, 2);
    std::memcpy(bytes.data() + 84 + 98, &second, 2);
    return read_stl(bytes, "a.stl").colors;
  };
  EXPECT_TRUE(with_bits(0, 0x7fff, "").empty()) << "no bit that says they count";
  // Blue first; half of the light is 188 of 255, or 23 of 31.
  const std::vector<Vec3> blue_first = with_bits(0x8000U | 31U << 10U | 23U, 0, "");
  ASSERT_EQ(blue_first.size(), 6U) << "three corners each";
  EXPECT_EQ(blue_first[0].x, 1.F);
  EXPECT_EQ(blue_first[0].y, 0.F);
  EXPECT_NEAR(blue_first[2].z, 0.51F, 0.01F);
  EXPECT_EQ(blue_first[3], Vec3(1.F)) << "has none of its own";
  // Red first, and the colour of the rest in the header.
  const std::string header("COLOR=\xff\0\0\xff", 10);
  const std::vector<Vec3> red_first = with_bits(31, 0x8000U, header);
  ASSERT_EQ(red_first.size(), 6U);
  EXPECT_EQ(red_first[0], Vec3(1, 0, 0));
  EXPECT_EQ(red_first[3], Vec3(1, 0, 0));
  EXPECT_EQ(with_bits(31U << 10U, 0x8000U, header)[0], Vec3(0, 0, 1));
}

TEST(Stl, BinaryHeadersMayBeginLikeAscii) {
  std::string bytes = binary(1, 1);
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_stl(bytes, "a.stl").mesh.indices.size(), 1U);
}

TEST(Stl, TruncatedBinaryFilesAreErrorsWithTheMissingCount) {
  EXPECT_EQ(stl_error(binary(3, 2)),
            "a.stl: the file ends early: 3 triangles need 234 bytes, and there are 184");
  EXPECT_TRUE(stl_error(binary(0xffffffffU, 1)).find("ends early") != std::string::npos);
  EXPECT_TRUE(stl_error("").find("no STL file") != std::string::npos);
}

TEST(Stl, AsciiTrianglesAreRead) {
  const desc::Mesh mesh = read_stl(kAscii + kAscii, "a.stl").mesh;
  EXPECT_EQ(mesh.indices.size(), 2U);
  EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[5], Vec3(0, 1.5F, -2));
}

TEST(Stl, AsciiErrorsHaveLineAndColumn) {
  std::string text = kAscii;
  text.replace(text.find("+1e0"), 4, "one!");
  EXPECT_EQ(stl_error(text), "a.stl:5:11: expected a number, found \"one!\"");
  EXPECT_EQ(stl_error(kAscii.substr(0, 60)).substr(0, 8), "a.stl:4:");
  EXPECT_EQ(stl_error("solid x\nfacet"),
            "a.stl:2:6: expected \"normal\", found the end of the file");
}

TEST(Stl, AsciiFilesMayBeginWithSpacesAndBeInCapitals) {
  EXPECT_EQ(read_stl("\n  " + kAscii, "a.stl").mesh.indices.size(), 1U);
  std::string capitals = kAscii;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  EXPECT_EQ(read_stl(capitals, "a.stl").mesh.indices.size(), 1U);
}

}  // namespace
}  // namespace ajar
