#include "measuring/shared_reference.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/error.h"
#include "imageio/image_file.h"

namespace ajar::bench {
namespace {

TEST(SharedReference, IsFoundOnlyAtItsOwnResolutionAndDepth) {
  const std::filesystem::path shared = std::filesystem::temp_directory_path() /
                                       ("ajar-shared-reference-" + std::to_string(getpid()));
  const std::filesystem::path folder = shared / "references";
  std::filesystem::create_directories(folder);
  EXPECT_THROW(shared_reference(shared, "room", {2, 1}, 8), IoError) << "no index";

  std::ofstream(folder / "index.json")
      << R"([{"name": "room", "resolution": "2x1", "max_depth": 8}])";
  const std::vector<float> pixels = {1.F, 2.F, 3.F, 4.F, 5.F, 6.F};
  write_image((folder / "room.exr").string(), {.resolution = {2, 1},
                                               .crop = {Vec2i(0, 0), Vec2i(1, 0)},
                                               .layers = {{.name = "", .pixels = pixels}},
                                               .metadata = {}});
  EXPECT_EQ(shared_reference(shared, "room", {2, 1}, 8), pixels);
  EXPECT_FALSE(shared_reference(shared, "room", {2, 1}, 7));
  EXPECT_FALSE(shared_reference(shared, "room", {1, 2}, 8));
  EXPECT_FALSE(shared_reference(shared, "hall", {2, 1}, 8));
  std::filesystem::remove_all(shared);
}

}  // namespace
}  // namespace ajar::bench
