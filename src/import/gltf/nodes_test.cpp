#include "import/gltf/nodes.h"

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

Vec3 placed(const Mat4& to_world, const Vec3& p) { return transform_point(to_world, p); }

TestFile with_node(const Json& members) {
  TestFile file;
  file.add_triangle();
  file.json["nodes"][0].update(members);
  return file;
}

TEST(GltfNodes, ScaleThenRotateThenTranslate) {
  // A quarter turn about z takes x to y.
  const desc::SceneDesc scene =
      scene_of(with_node({{"translation", {10, 20, 30}},
                          {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}},
                          {"scale", {2, 3, 4}}}));
  const Mat4& to_world = scene.shapes.front().to_world;
  expect_near(placed(to_world, {1, 0, 0}), {10, 22, 30});
  expect_near(placed(to_world, {0, 1, 0}), {7, 20, 30});
  expect_near(placed(to_world, {0, 0, 1}), {10, 20, 34});
}

TEST(GltfNodes, MatricesAreColumnByColumn) {
  const desc::SceneDesc scene =
      scene_of(with_node({{"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}}));
  expect_near(placed(scene.shapes.front().to_world, {1, 0, 0}), {5, 7, 7});
}

TEST(GltfNodes, ChildrenMoveWithTheirParents) {
  TestFile file = with_node({{"translation", {1, 0, 0}}});
  file.add("nodes", {{"scale", {2, 2, 2}}, {"children", {0}}});
  file.add("scenes", {{"nodes", {1}}});
  expect_near(placed(scene_of(file).shapes.front().to_world, Vec3(0.F)), {2, 0, 0});
}

TEST(GltfNodes, OfTheShownSceneAloneArePlaced) {
  TestFile file = with_node(Json::object());
  file.add("scenes", {{"nodes", Json::array()}});
  file.add("scenes", {{"nodes", {0}}});
  const auto meshes = [&] {
    Warnings warnings;
    const desc::SceneDesc scene = import_with(file.text(), warnings);
    EXPECT_EQ(warnings.count(), 1U) << "of the other scene";
    std::size_t count = 0;
    for (const desc::Shape& shape : scene.shapes) count += shape.node.is("mesh") ? 1 : 0;
    return count;
  };
  EXPECT_EQ(meshes(), 0U);
  file.json["scene"] = 1;
  EXPECT_EQ(meshes(), 1U);
  file.json["scene"] = 2;
  EXPECT_TRUE(contains(error_of(file.text()), "#/scene: refers to number 2"));
}

TEST(GltfNodes, CyclesAndSharedChildrenAreErrors) {
  TestFile cycle = with_node({{"children", {0}}});
  cycle.add("scenes", {{"nodes", {0}}});
  EXPECT_TRUE(contains(error_of(cycle.text()), "#/nodes/0: this node is reached in two ways"));
  // Thirty levels of two references each would be a thousand million nodes.
  TestFile doubled = with_node(Json::object());
  for (int i = 0; i < 30; ++i) doubled.add("nodes", {{"children", {i, i}}});
  EXPECT_TRUE(contains(error_of(doubled.text()), "reached in two ways"));
}

TEST(GltfNodes, MayBeVeryDeep) {
  TestFile file = with_node(Json::object());
  constexpr int kDepth = 20000;
  for (int i = 0; i < kDepth; ++i) file.add("nodes", {{"children", {i}}});
  EXPECT_EQ(error_of(file.text()), "no error");
}

TEST(GltfNodes, MeshesUsedTwiceAreInstances) {
  TestFile file = with_node({{"translation", {1, 0, 0}}});
  file.add("nodes", {{"mesh", 0}, {"translation", {2, 0, 0}}});
  const desc::SceneDesc scene = scene_of(file);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].shapes.size(), 1U);
  ASSERT_EQ(scene.instances.size(), 2U);
  expect_near(placed(scene.instances[1].to_world, Vec3(0.F)), {2, 0, 0});
  EXPECT_EQ(without_places(scene.instances[1].where.to_string()), "test.gltf#/nodes/1");
}

TEST(GltfNodes, EmissiveMeshesAreCopiedInsteadOfInstanced) {
  TestFile file;
  file.add_triangle({{"emissiveFactor", {1, 1, 1}}});
  file.add("nodes", {{"mesh", 0}});
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_TRUE(scene.shapes[0].emission);
  EXPECT_TRUE(scene.shapes[1].emission);
  EXPECT_EQ(scene.shapes[0].node.mesh("mesh"), scene.shapes[1].node.mesh("mesh"));
}

TEST(GltfNodes, MayHaveTheirMeshInManyPlaces) {
  TestFile file = with_node({{"translation", {0, 0, 7}}});
  Json& attributes = file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  attributes["TRANSLATION"] =
      file.add_accessor(bytes_of<float>({1, 0, 0, 2, 0, 0}), 5126, "VEC3", 2);
  attributes["SCALE"] = file.add_accessor(bytes_of<float>({1, 1, 1, 3, 3, 3}), 5126, "VEC3", 2);
  // The second is turned by 90 degrees about z.
  attributes["ROTATION"] = file.add_accessor(
      bytes_of<float>({0, 0, 0, 1, 0, 0, std::sqrt(0.5F), std::sqrt(0.5F)}), 5126, "VEC4", 2);
  file.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const desc::SceneDesc scene = scene_of(file);
  ASSERT_EQ(scene.instances.size(), 2U);
  expect_near(placed(scene.instances[0].to_world, {1, 0, 0}), {2, 0, 7});
  expect_near(placed(scene.instances[1].to_world, {1, 0, 0}), {2, 3, 7});
  attributes["SCALE"] = 0;
  EXPECT_TRUE(
      contains(error_of(file.text()), "/attributes/ROTATION: there are 2 values for 3 instances"));
}

TEST(GltfNodes, HaveALimitOfMeshPlacements) {
  TestFile file = with_node(Json::object());
  // Zeros without bytes, as many as the file has bytes.
  const std::string zeros(60'000, '\0');
  const std::size_t places = file.add_accessor(zeros, 5120, "VEC3", 20'000, 4);
  file.json["accessors"][places].erase("bufferView");
  const Json instanced = {
      {"mesh", 0},
      {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}};
  for (int i = 0; i < 51; ++i) file.add("nodes", instanced);
  EXPECT_TRUE(contains(error_of(file.text()), "in more than 1000000 places"));
}

TEST(GltfNodes, MayBeHiddenWithAllBelow) {
  TestFile file = with_node({{"translation", {1, 0, 0}}});
  file.add_triangle();
  file.add("nodes",
           {{"children", {0}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  file.add("scenes", {{"nodes", {1, 2}}});
  const desc::SceneDesc scene = scene_of(file);
  const auto is_first = [](const desc::Shape& shape) {
    return contains(shape.where.to_string(), "#/meshes/0");
  };
  EXPECT_EQ(std::count_if(scene.shapes.begin(), scene.shapes.end(), is_first), 0);
  file.json["nodes"][2]["extensions"]["KHR_node_visibility"]["visible"] = true;
  const desc::SceneDesc all = scene_of(file);
  EXPECT_EQ(std::count_if(all.shapes.begin(), all.shapes.end(), is_first), 1);
}

// ---------------------------------------------------------------- cameras

TestFile with_camera(const Json& camera, const Json& node = Json::object()) {
  TestFile file;
  file.add_triangle();
  file.add("cameras", camera);
  Json with = {{"camera", 0}};
  with.update(node);
  file.add("nodes", with);
  return file;
}
const Json kPerspective = {{"type", "perspective"},
                           {"perspective", {{"yfov", 0.5}, {"aspectRatio", 2.0}, {"znear", 0.1}}}};

TEST(GltfCameras, LookAlongMinusZWithXToTheRight) {
  const desc::SceneDesc scene = scene_of(with_camera(kPerspective, {{"translation", {1, 2, 3}}}));
  const Mat4& to_world = scene.camera.to_world;
  expect_near(placed(to_world, Vec3(0.F)), {1, 2, 3});
  expect_near(transform_vector(to_world, {0, 0, 1}), {0, 0, -1});
  expect_near(transform_vector(to_world, {0, 1, 0}), {0, 1, 0});
  expect_near(transform_vector(to_world, {1, 0, 0}), {1, 0, 0});
}

TEST(GltfCameras, HaveTheAngleOfTheShorterSide) {
  const auto camera = [](const desc::SceneDesc& scene) {
    return std::get<desc::PerspectiveCamera>(scene.camera.node);
  };
  const desc::SceneDesc wide = scene_of(with_camera(kPerspective));
  EXPECT_NEAR(camera(wide).fov, 0.5F * 180.F / kPi, 1e-4F);
  EXPECT_EQ(wide.film.resolution, Vec2i(1440, 720));
  Json tall = kPerspective;
  tall["perspective"]["aspectRatio"] = 0.5;
  const desc::SceneDesc narrow = scene_of(with_camera(tall));
  EXPECT_NEAR(std::tan(camera(narrow).fov * kPi / 360.F), 0.5F * std::tan(0.25F), 1e-5F);
  EXPECT_EQ(narrow.film.resolution, Vec2i(720, 1440));
}

TEST(GltfCameras, OrthographicOnesShowTheirMagnification) {
  const desc::SceneDesc scene = scene_of(
      with_camera({{"type", "orthographic"},
                   {"orthographic", {{"xmag", 3.0}, {"ymag", 2.0}, {"zfar", 9}, {"znear", 0}}}}));
  const auto& camera = std::get<desc::OrthographicCamera>(scene.camera.node);
  ASSERT_TRUE(camera.window);
  EXPECT_EQ(camera.window->x_min, -3.F);
  EXPECT_EQ(camera.window->y_max, 2.F);
  EXPECT_EQ(scene.film.resolution, Vec2i(1080, 720));
}

TEST(GltfCameras, OfWrongTypesAndAnglesAreErrors) {
  Json camera = kPerspective;
  camera["type"] = "perspectiv";
  EXPECT_TRUE(contains(error_of(with_camera(camera).text()),
                       "#/cameras/0/type: unknown type of camera \"perspectiv\"; did you mean"));
  camera = kPerspective;
  camera["perspective"]["yfov"] = 0;
  EXPECT_TRUE(contains(error_of(with_camera(camera).text()), "/yfov: this must be above 0"));
}

// ---------------------------------------------------------------- lights

TestFile with_light(const Json& light, const Json& node = Json::object()) {
  TestFile file = with_camera(kPerspective);
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
  Json with = {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
  with.update(node);
  file.add("nodes", with);
  return file;
}

TEST(GltfLights, CandelaAreWattsPerSteradian) {
  const desc::SceneDesc scene = scene_of(with_light(
      {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 8}}, {{"translation", {0, 5, 0}}}));
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_TRUE(scene.lights[0].node.is("point"));
  EXPECT_EQ(scene.lights[0].node.color("intensity"), Vec3(8.F, 4.F, 0.F));
  expect_near(placed(scene.lights[0].to_world, Vec3(0.F)), {0, 5, 0});
}

TEST(GltfLights, LuxAreWattsPerSquareMetreFromPlusZ) {
  const desc::SceneDesc scene = scene_of(with_light({{"type", "directional"}, {"intensity", 3}}));
  EXPECT_TRUE(scene.lights[0].node.is("distant"));
  EXPECT_EQ(scene.lights[0].node.color("irradiance"), Vec3(3.F));
  // Light shines along −z: it is in the direction of +z.
  expect_near(transform_vector(scene.lights[0].to_world, {0, 0, 1}), {0, 0, 1});
}

TEST(GltfLights, SpotsShineAlongMinusZ) {
  const desc::SceneDesc scene = scene_of(
      with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.6}}}}));
  const TestFile hard =
      with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}}}});
  EXPECT_TRUE(contains(warnings_of(hard), "/lights/0/spot: its cone angles are the same"))
      << warnings_of(hard);
  const desc::Node& spot = scene.lights[0].node;
  EXPECT_NEAR(spot.number("cone_angle"), 0.6F * 180.F / kPi, 1e-4F);
  EXPECT_NEAR(spot.number("falloff_start"), 0.1F * 180.F / kPi, 1e-4F);
  EXPECT_EQ(spot.text("falloff"), "quadratic");
  expect_near(transform_vector(scene.lights[0].to_world, {0, 0, 1}), {0, 0, -1});
  EXPECT_TRUE(
      contains(error_of(with_light({{"type", "spot"}, {"spot", {{"innerConeAngle", 2}}}}).text()),
               "/lights/0/spot: its cone angles must be"));
}

TEST(GltfLights, RangesAreWarnings) {
  EXPECT_EQ(warnings_of(with_light({{"type", "point"}, {"range", 4}})),
            "test.gltf#/extensions/KHR_lights_punctual/lights/0: the range of this light is "
            "ignored\n");
}

TEST(GltfLights, NegativeStrengthsAndUnknownTypesAreLocatedErrors) {
  EXPECT_TRUE(contains(error_of(with_light({{"type", "point"}, {"intensity", -1}}).text()),
                       "test.gltf#/extensions/KHR_lights_punctual/lights/0: "));
  EXPECT_TRUE(contains(error_of(with_light({{"type", "pont"}}).text()),
                       "did you mean \"point\"? Valid: directional, point, spot"));
}

TEST(GltfCameras, DoNotHaveTheScaleOfTheirNodes) {
  const Json orthographic = {
      {"type", "orthographic"},
      {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 9}}}};
  const Mat4 plain =
      scene_of(with_camera(orthographic, {{"translation", {1, 2, 3}}})).camera.to_world;
  for (const Json& scale : {Json{2, 2, 2}, Json{0.01, 5, 3}, Json{-1, 1, 1}}) {
    const desc::SceneDesc scene =
        scene_of(with_camera(orthographic, {{"translation", {1, 2, 3}}, {"scale", scale}}));
    EXPECT_TRUE(scene.camera.to_world.equalWithAbsError(plain, 1e-9)) << scale;
  }
}

TEST(GltfLights, KeepTheirConesInScaledNodes) {
  const auto place_of = [](const Json& node) {
    TestFile file;
    file.add_triangle();
    Json with = node;
    with["extensions"]["KHR_lights_punctual"]["light"] = 0;
    file.json["scenes"][0]["nodes"].push_back(file.add("nodes", with));
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
    return scene_of(file).lights.at(0).to_world;
  };
  const Json rotation = {0.0, 0.38268343, 0.0, 0.92387953};
  EXPECT_TRUE(place_of({{"rotation", rotation}, {"scale", {1, 4, 9}}})
                  .equalWithAbsError(place_of({{"rotation", rotation}}), 1e-6));
}

}  // namespace
}  // namespace ajar::gltf
