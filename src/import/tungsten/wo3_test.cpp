#include "import/tungsten/wo3.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "import/tungsten/wo3_test_support.h"

namespace ajar::tungsten {
namespace {

std::string wo3_error_in(std::string_view bytes) {
  try {
    read_wo3(bytes, "m.wo3");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Wo3, HasVerticesAndTrianglesWithMaterials) {
  const Wo3Mesh result = read_wo3(wo3_of_two_materials(), "m.wo3");
  ASSERT_EQ(result.mesh.positions.size(), 4U);
  EXPECT_EQ(result.mesh.positions[2], Vec3(1.F, 1.F, 0.F));
  EXPECT_EQ(result.mesh.normals[2], Vec3(0.F, 0.F, 1.F));
  EXPECT_EQ(result.mesh.uvs[2], Vec2(1.F, 1.F));
  ASSERT_EQ(result.mesh.indices.size(), 2U);
  EXPECT_EQ(result.mesh.indices[1], (Imath::Vec3<unsigned>(0, 2, 3)));
  EXPECT_EQ(result.materials, (std::vector<std::int32_t>{0, 1}));
}

TEST(Wo3, RefusesFilesThatEndTooEarlyAtAnyByte) {
  const std::string whole = wo3_of_two_materials();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(wo3_error_in(whole.substr(0, size)).find("m.wo3: this is no complete .wo3 mesh"),
              std::string::npos)
        << size;
  }
  EXPECT_EQ(wo3_error_in(whole), "no error");
}

TEST(Wo3, RefusesImpossibleCounts) {
  std::string bytes = wo3_of_two_materials();
  for (std::size_t i = 0; i < 8; ++i) bytes[i] = '\xff';
  EXPECT_NE(wo3_error_in(bytes).find("ends before its 18446744073709551615 vertices"),
            std::string::npos)
      << wo3_error_in(bytes);
}

}  // namespace
}  // namespace ajar::tungsten
