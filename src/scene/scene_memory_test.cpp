#include "scene/scene_memory.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "core/warnings.h"
#include "scene/desc/models.h"
#include "scene/scene.h"

namespace ajar {
namespace {

/// A bumpy floor of `side`² squares.
desc::SceneDesc floor_of(unsigned side) {
  auto mesh = std::make_shared<desc::Mesh>();
  for (unsigned y = 0; y <= side; ++y) {
    for (unsigned x = 0; x <= side; ++x) {
      mesh->positions.emplace_back(x, y, (x * 7919U + y * 104729U) % 13U);
      if (x == side || y == side) continue;
      const unsigned corner = y * (side + 1) + x;
      mesh->indices.emplace_back(corner, corner + 1, corner + side + 1);
      mesh->indices.emplace_back(corner + 1, corner + side + 2, corner + side + 1);
    }
  }
  desc::SceneDesc scene;
  scene.materials.emplace_back().node = desc::material_node("diffuse");
  desc::Shape shape;
  shape.node = desc::mesh_node(std::move(mesh));
  shape.material = 0;
  scene.shapes.push_back(shape);
  scene.lights.emplace_back().node = desc::light_node("point");
  return scene;
}

TEST(SceneMemory, CoversEmbreesTreeWithoutExaggerating) {
  for (const unsigned side : {100U, 300U}) {
    desc::SceneDesc description = floor_of(side);
    const std::uint64_t estimate = estimate_memory(description).geometry;
    Warnings warnings;
    const Scene scene(std::move(description), {}, warnings);
    const std::uint64_t vertices = std::uint64_t{side + 1} * (side + 1) * sizeof(Vec3);
    EXPECT_GT(estimate, scene.counts().embree_bytes + vertices);
    EXPECT_LT(estimate, 4 * (scene.counts().embree_bytes + vertices));
  }
}

TEST(SceneMemory, SubdividedSurfacesCountAfterSubdivision) {
  desc::SceneDesc coarse = floor_of(4);
  const desc::MeshPointer mesh = coarse.shapes[0].node.mesh("mesh");
  coarse.shapes[0].node = desc::shape_node("subdivision", {{"levels", 5}, {"control", mesh}});
  const double as_mesh = static_cast<double>(estimate_memory(floor_of(4 * 32)).geometry);
  EXPECT_NEAR(static_cast<double>(estimate_memory(coarse).geometry) / as_mesh, 1.0, 0.05);
}

TEST(SceneMemory, TooFineSubdivisionsAreRefusedWithTheLevelsThatFit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers reserve more memory than any limit allows";
#endif
  desc::SceneDesc scene = floor_of(1);
  desc::Shape& shape = scene.shapes[0];
  const desc::MeshPointer mesh = shape.node.mesh("mesh");
  shape.where = {std::make_shared<const std::string>("a.pbrt"), 3, 7};
  shape.node = desc::shape_node("subdivision", {{"levels", 3}, {"control", mesh}});
  EXPECT_NO_THROW(estimate_memory(scene));
  shape.node.set("levels", 13);
  // 24 GB, of 4 GB.
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  rlimit tight = before;
  tight.rlim_cur = std::min<rlim_t>(before.rlim_max, rlim_t{4} << 30U);
  setrlimit(RLIMIT_AS, &tight);
  std::string error;
  try {
    estimate_memory(scene);
  } catch (const SceneError& caught) {
    error = caught.what();
  }
  setrlimit(RLIMIT_AS, &before);
  EXPECT_EQ(error.find("a.pbrt:3:7: this subdivision surface, with 2 faces and \"levels\" of 13, "
                       "needs 24.0 GB of memory, and "),
            0U)
      << error;
  EXPECT_NE(error.find("\"levels\" can be at most "), std::string::npos) << error;
}

TEST(SceneMemory, EveryImageCountsOnceAndAbsentOnesNothing) {
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("ajar-memory-" + std::to_string(getpid()) + ".png"))
                               .string();
  const auto output = OIIO::ImageOutput::create(path);
  output->open(path, OIIO::ImageSpec(20, 10, 4, OIIO::TypeDesc::UINT16));
  output->write_image(OIIO::TypeDesc::UINT16, std::vector<std::uint16_t>(800).data());
  output->close();
  desc::SceneDesc scene = floor_of(1);
  for (const std::string& name : {path, path, path + ".absent"}) {
    scene.textures.emplace_back().node = desc::texture_node("image", {{"file", name}});
  }
  EXPECT_EQ(estimate_memory(scene).images, 20U * 10U * 3U * 2U) << "without alpha";
  scene.lights.emplace_back().node = desc::light_node("environment", {{"image", path}});
  EXPECT_GT(estimate_memory(scene).images, 20U * 10U * (3U * 2U + 8U));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace ajar
