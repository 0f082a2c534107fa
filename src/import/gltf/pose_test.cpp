#include "import/gltf/pose.h"

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

Vec3 corner(const desc::SceneDesc& scene, std::size_t i, std::size_t shape = 0) {
  return transform_point(scene.shapes.at(shape).to_world, mesh_of(scene, shape).positions.at(i));
}

// ---------------------------------------------------------------- morph targets

/// A triangle with normals +z, of which the first target lifts corner 0 by 8 and turns its normal
/// by (1 0 0), the second shifts all by (0 2 0).
TestFile morphing() {
  TestFile file;
  Json triangle = file.triangle();
  const auto add = [&](const std::vector<float>& numbers) {
    return file.add_accessor(bytes_of(numbers), 5126, "VEC3", 3);
  };
  triangle["attributes"]["NORMAL"] = add({0, 0, 1, 0, 0, 1, 0, 0, 1});
  const Json lift = {{"POSITION", add({0, 0, 8, 0, 0, 0, 0, 0, 0})},
                     {"NORMAL", add({1, 0, 0, 0, 0, 0, 0, 0, 0})}};
  const Json shift = {{"POSITION", add({0, 2, 0, 0, 2, 0, 0, 2, 0})}};
  triangle["targets"] = Json::array({lift, shift});
  triangle["material"] = file.add("materials", Json::object());
  file.add("meshes", {{"primitives", Json::array({triangle})}});
  file.add("nodes", {{"mesh", 0}});
  return file;
}

TEST(GltfPoses, MorphTargetsAreWeighted) {
  TestFile file = morphing();
  EXPECT_EQ(corner(scene_of(file), 0), Vec3(0.F)) << "without weights there are none";
  file.json["meshes"][0]["weights"] = {0.25, 0};
  EXPECT_EQ(corner(scene_of(file), 0), Vec3(0, 0, 2));
  EXPECT_EQ(mesh_of(scene_of(file)).normals[0], Vec3(0.25F, 0, 1));
  file.json["nodes"][0]["weights"] = {0, 0.5};
  EXPECT_EQ(corner(scene_of(file), 0), Vec3(0, 1, 0)) << "those of the node count";
  file.json["nodes"][0]["weights"] = {0, 0};
  EXPECT_EQ(corner(scene_of(file), 0), Vec3(0.F));
}

TEST(GltfPoses, NodesOfDifferentWeightsHaveMeshesOfTheirOwn) {
  TestFile file = morphing();
  file.json["meshes"][0]["weights"] = {0, 1};
  file.json["nodes"][0]["weights"] = {0, 0.5};
  for (int i = 0; i < 2; ++i) file.add("nodes", {{"mesh", 0}, {"translation", {i, 0, 0}}});
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_EQ(corner(scene, 1), Vec3(1, 1, 0));
  ASSERT_EQ(scene.objects.size(), 1U) << "two nodes have the weights of the mesh";
  EXPECT_EQ(scene.objects[0].shapes[0].node.mesh("mesh")->positions[1], Vec3(1, 2, 0));
  EXPECT_EQ(scene.instances.size(), 2U);
}

TEST(GltfPoses, TargetsOfOtherSizesAreErrorsAndOfColorsWarnings) {
  TestFile file = morphing();
  file.json["meshes"][0]["weights"] = {1};
  Json& target = file.json["meshes"][0]["primitives"][0]["targets"][0];
  target["COLOR_0"] = 0;
  EXPECT_TRUE(contains(warnings_of(file),
                       "#/meshes/0/primitives/0/targets/0: this target changes colours"));
  target["POSITION"] = file.add_accessor(bytes_of<float>({0, 0, 0}), 5126, "VEC3", 1);
  EXPECT_TRUE(
      contains(error_of(file.text()), "targets/0/POSITION: there are 1 values for 3 vertices"));
}

// ---------------------------------------------------------------- skins

/// The corners of a triangle are bound to the joints 0, 1, and to both by halves. The joints were
/// at the origin and at (1 0 0) then, and are now at (0 0 5), and turned by 90 degrees about z and
/// doubled at (1 0 5).
TestFile skinned() {
  TestFile file;
  Json triangle = file.triangle();
  triangle["attributes"]["JOINTS_0"] = file.add_accessor(
      bytes_of<std::uint8_t>({0, 9, 9, 9, 1, 9, 9, 9, 0, 1, 9, 9}), 5121, "VEC4", 3);
  triangle["attributes"]["WEIGHTS_0"] =
      file.add_accessor(bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, .5F, .5F, 0, 0}), 5126, "VEC4", 3);
  triangle["attributes"]["NORMAL"] =
      file.add_accessor(bytes_of<float>({1, 0, 0, 1, 0, 0, 0, 0, 1}), 5126, "VEC3", 3);
  triangle["material"] = file.add("materials", Json::object());
  file.add("meshes", {{"primitives", Json::array({triangle})}});
  const std::vector<float> bind = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                   1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
  const std::size_t matrices = file.add_accessor(bytes_of(bind), 5126, "MAT4", 2);
  file.add("nodes", {{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}});
  file.add("nodes", {{"translation", {0, 0, 5}}, {"children", {2}}});
  file.add("nodes", {{"translation", {1, 0, 0}},
                     {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}},
                     {"scale", {2, 2, 2}}});
  file.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", matrices}, {"skeleton", 1}});
  return file;
}

TEST(GltfPoses, SkinsFollowTheirJointsAndNotTheirNode) {
  const desc::SceneDesc scene = scene_of(skinned());
  expect_near(corner(scene, 0), {0, 0, 5});
  expect_near(corner(scene, 1), {1, 0, 5});
  // (0 1 0) goes to (0 1 5) by the first; by the second it is at (−1 1 0), which goes to
  // (1 0 5) + 2 (−1 −1 0).
  expect_near(corner(scene, 2), {-0.5F, -0.5F, 5});
  const std::vector<Vec3>& normals = mesh_of(scene).normals;
  expect_near(normals[0], {1, 0, 0});
  expect_near(normals[1].normalized(), {0, 1, 0});
}

TEST(GltfPoses, JointsAreWhereTheyWereBoundWithoutMatrices) {
  TestFile file = skinned();
  file.json["skins"][0].erase("inverseBindMatrices");
  expect_near(corner(scene_of(file), 1), {1, 2, 5});
}

TEST(GltfPoses, InvalidSkinsAreShownInTheirBindPose) {
  TestFile file = skinned();
  file.add("scenes", {{"nodes", {0}}});
  EXPECT_TRUE(contains(warnings_of(file), "#/skins/0/joints/0: this joint is not in the scene"));
  TestFile unbound = skinned();
  unbound.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  EXPECT_TRUE(contains(warnings_of(unbound),
                       "#/meshes/0/primitives/0: this primitive has a skin, but not both"));
}

TEST(GltfPoses, DamagedSkinsAreErrors) {
  TestFile file = skinned();
  file.json["skins"][0]["joints"] = {1};
  EXPECT_TRUE(
      contains(error_of(file.text()),
               "JOINTS_0: vertex 1 is bound to a joint that its skin, of 1, does not have"));
  file.json["skins"][0]["joints"] = {1, 2, 1};
  EXPECT_TRUE(contains(error_of(file.text()),
                       "#/skins/0/inverseBindMatrices: there are 2 matrices for 3 joints"));
  file.json["nodes"][0]["skin"] = 4;
  EXPECT_TRUE(contains(error_of(file.text()), "#/nodes/0/skin: refers to number 4"));
}

}  // namespace
}  // namespace ajar::gltf
