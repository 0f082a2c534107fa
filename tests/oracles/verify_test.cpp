#include "path/verify.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>

#include "support/path_samples.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// Detection of impossible paths.
namespace ajar {
namespace {

/// With a specular vertex between two others.
Path path_through_glass(const Scene& scene) {
  std::optional<Path> found;
  test::for_samples(scene, 2000, [&](std::uint32_t, const std::vector<test::WeightedPath>& paths) {
    for (const test::WeightedPath& weighted : paths) {
      const Path& path = weighted.path;
      if (!found && path.depth() >= 4 && path.vertex(2).event.specular()) found = path;
    }
  });
  if (!found) throw std::logic_error("no such path");
  return *found;
}

TEST(Verify, NamesErrorsOfAPath) {
  const auto scene = test::scene_from(test::small_scene("GlassAndMetal").text);
  const Path path = path_through_glass(*scene);
  EXPECT_NO_THROW(verify(*scene, path, "a test"));
  const auto message = [&](const Path& wrong) {
    try {
      verify(*scene, wrong, "a test");
    } catch (const std::logic_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Path elsewhere = path;
  elsewhere.raster.x += 0.1F;
  EXPECT_EQ(message(elsewhere), "bug: a path of a test is not seen where it lands on the film");
  Path moved = path;
  moved.vertices[1].hit.point.p.x += 0.02F;
  EXPECT_EQ(message(moved), "bug: a path of a test goes elsewhere at specular vertex 2");
  Path other_event = path;
  other_event.vertices[1].event.transmission = !other_event.vertices[1].event.transmission;
  EXPECT_EQ(message(other_event), "bug: a path of a test goes elsewhere at specular vertex 2");
  Path short_of_one = path;
  short_of_one.segments.pop_back();
  EXPECT_EQ(message(short_of_one), "bug: a path of a test lacks a segment");
}

}  // namespace
}  // namespace ajar
