#include <gtest/gtest.h>

#include "scene/desc/models.h"
#include "scene/scene.h"

namespace ajar {
namespace {

using If = desc::WarningIfSeen::If;

constexpr WarningKind kOfTest{Effect::Slight, "of the test"};

/// A camera at the origin looks along z at a large disk at z = 4, whose normal is toward it or not,
/// and another behind it, at z = 6.
std::vector<std::string> warned(If condition, float depth, bool is_turned, bool has_glass = false) {
  desc::SceneDesc scene;
  scene.film.resolution = {8, 6};
  const auto add_disk = [&](double z, bool is_away, const desc::Node& material) {
    desc::Shape& disk = scene.shapes.emplace_back();
    disk.node = desc::shape_node("disk", {{"radius", 10.F}});
    disk.to_world.setTranslation(Vec3d(0.0, 0.0, z));
    disk.reverse_orientation = !is_away;
    disk.material = static_cast<desc::MaterialId>(scene.materials.size());
    scene.materials.emplace_back().node = material;
  };
  if (has_glass) add_disk(2.0, false, desc::material_node("dielectric"));
  const auto opaque = static_cast<desc::MaterialId>(scene.materials.size());
  add_disk(4.0, is_turned, desc::material_node("diffuse"));
  add_disk(6.0, true, desc::material_node("diffuse"));
  scene.warnings_if_seen.push_back({condition, opaque, depth, {kOfTest, {}, "the wall"}});
  scene.warnings_if_seen.push_back(
      {condition, opaque + 1, depth, {kOfTest, {}, "what is behind the wall"}});
  Warnings warnings;
  const Scene built(std::move(scene), {}, warnings);
  std::vector<std::string> messages;
  for (const Warning& warning : warnings.kept()) {
    if (warning.kind.several == kOfTest.several) messages.push_back(warning.message);
  }
  return messages;
}

TEST(SeenWarnings, AreOfVisibleSurfaces) {
  using Messages = std::vector<std::string>;
  EXPECT_EQ(warned(If::FromBehind, 0.F, false), Messages());
  EXPECT_EQ(warned(If::FromBehind, 0.F, true), Messages{"the wall"});
  EXPECT_EQ(warned(If::FromBehind, 0.F, true, true), Messages{"the wall"}) << "through glass";
  EXPECT_EQ(warned(If::Nearer, 3.9F, false).size(), 0U);
  EXPECT_EQ(warned(If::Nearer, 4.1F, false).size(), 2U) << "no matter which material";
  EXPECT_EQ(warned(If::Farther, 4.1F, false).size(), 0U) << "the wall hides it";
  EXPECT_EQ(warned(If::Farther, 3.9F, false).size(), 2U);
}

}  // namespace
}  // namespace ajar
