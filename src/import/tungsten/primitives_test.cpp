#include "import/tungsten/primitives.h"

#include <gtest/gtest.h>

#include <cstring>

#include "import/tungsten/import_test_support.h"
#include "import/tungsten/instances.h"
#include "import/tungsten/wo3_test_support.h"

namespace ajar::tungsten {
namespace {

/// The scene with one primitive.
desc::SceneDesc scene_with(const std::string& members, const Files& files = {}) {
  return scene_of("", "{" + members + "}", "{}", files);
}
const desc::Mesh& mesh_of(const desc::Shape& shape) { return *shape.node.mesh("mesh"); }

/// Normal of a triangle by its winding.
Vec3 normal_of(const desc::Mesh& mesh, std::size_t triangle) {
  const Imath::Vec3<unsigned>& t = mesh.indices.at(triangle);
  return normalize(
      cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]));
}

TEST(Primitives, QuadsFaceYWithVAlongZ) {
  const desc::SceneDesc scene = scene_with("'type': 'quad', 'transform': {'scale': [2, 0, 4]}");
  const desc::Mesh& mesh = mesh_of(scene.shapes.at(0));
  ASSERT_EQ(mesh.positions.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    expect_near(mesh.positions[i],
                {2.F * (mesh.uvs[i].x - 0.5F), 0.F, 4.F * (mesh.uvs[i].y - 0.5F)});
  }
  expect_near(normal_of(mesh, 0), {0, 1, 0});
  expect_near(normal_of(mesh, 1), {0, 1, 0});
}

TEST(Primitives, CubesFaceOutwardEvenIfTheyAreMirrored) {
  for (const char* scale : {"[1, 1, 1]", "[-1, 1, 1]", "[2, -3, -4]", "[-1, -2, -1]"}) {
    const desc::SceneDesc scene =
        scene_with(std::string("'type': 'cube', 'transform': {'position': [5, 6, 7], 'scale': ") +
                   scale + "}");
    const desc::Mesh& mesh = mesh_of(scene.shapes.at(0));
    ASSERT_EQ(mesh.indices.size(), 12U);
    for (std::size_t t = 0; t < 12; ++t) {
      const Vec3 corner = mesh.positions[mesh.indices[t].x] - Vec3(5.F, 6.F, 7.F);
      EXPECT_GT(dot(corner, normal_of(mesh, t)), 0.4F) << scale << " " << t;
    }
  }
}

TEST(Primitives, SpheresHaveTheLargestScaleAndDisksFaceY) {
  const desc::SceneDesc scene =
      scene_of("",
               "{'type': 'sphere', 'transform': {'scale': [1, 3, 2], 'position': [1, 0, 0]}},"
               "{'type': 'disk', 'transform': {'scale': [1, 0, 2]}}");
  EXPECT_NEAR(length(moved(scene.shapes.at(0).to_world, {1, 0, 0}) - Vec3(1, 0, 0)), 3.F, 1e-5F);
  const Mat4& disk = scene.shapes.at(1).to_world;
  EXPECT_NEAR(length(moved(disk, {1, 0, 0})), 2.F, 1e-5F);
  expect_near(normalize(transform_vector(disk, {0, 0, 1})), {0, 1, 0});
}

TEST(Primitives, CylindersHaveLids) {
  const desc::SceneDesc scene = scene_of(
      "",
      "{'type': 'cylinder', 'transform': {'scale': [2, 6, 2]}}, {'type': 'cylinder', 'capped': "
      "false}");
  ASSERT_EQ(scene.shapes.size(), 4U);
  EXPECT_TRUE(scene.shapes[0].node.is("cylinder"));
  expect_near(moved(scene.shapes[0].to_world, {0, 0, 1}), {0, 3, 0});
  EXPECT_NEAR(length(moved(scene.shapes[0].to_world, {1, 0, 0})), 1.F, 1e-6F);
  for (const int i : {1, 2}) {
    const Mat4& lid = scene.shapes[static_cast<std::size_t>(i)].to_world;
    const float side = i == 1 ? 1.F : -1.F;
    expect_near(moved(lid, {0, 0, 0}), {0, 3.F * side, 0});
    expect_near(normalize(transform_vector(lid, {0, 0, 1})), {0, side, 0});
  }
}

TEST(Primitives, TexturesOfDisksAndCylindersGoAroundAsInTungsten) {
  // Ours have u = 0 along x and u = 1/4 along y.
  const auto place = [](const std::string& members) { return scene_with(members).shapes.at(0); };
  const desc::Shape disk = place("'type': 'disk', 'transform': {'scale': 2}");
  EXPECT_EQ(disk.node.text("coordinates"), "angle_then_radius");
  // u = atan2(p · t, p · b) / 2π + 1/2, with t = x and b = −z around the normal y.
  expect_near(moved(disk.to_world, {1, 0, 0}), {0, 0, 2});
  expect_near(moved(disk.to_world, {0, 1, 0}), {-2, 0, 0});
  // The frame is one of the normal, here z: t = x, b = y.
  const desc::Shape turned = place("'type': 'disk', 'transform': {'rotation': [90, 0, 0]}");
  expect_near(transform_vector(turned.to_world, {0, 0, 1}), {0, 0, 1});
  expect_near(moved(turned.to_world, {1, 0, 0}), {0, -1, 0});
  expect_near(moved(turned.to_world, {0, 1, 0}), {-1, 0, 0});
  // u = atan2(z, x) / 2π + 1/2, and v along y.
  const desc::Shape side = place("'type': 'cylinder', 'transform': {'scale': [2, 6, 2]}");
  expect_near(moved(side.to_world, {1, 0, 0}), {-1, 0, 0});
  expect_near(moved(side.to_world, {0, 1, 0}), {0, 0, -1});
  expect_near(moved(side.to_world, {0, 0, 1}), {0, 3, 0});
}

TEST(Primitives, TexturesOnLidsAreWarnings) {
  const auto with = [](const std::string& members) {
    return warnings_of(
        scene_text("{'name': 'm', 'type': 'mixed', 'bsdf0': {'type': 'lambert', "
                   "'albedo': 'a.png'}, 'bsdf1': {'type': 'mirror'}}",
                   "{'type': 'cylinder', " + members + "}"));
  };
  EXPECT_TRUE(contains(with("'bsdf': 'm'"),
                       "test.json:3:16#/primitives/0: the texture runs around the lids"));
  EXPECT_TRUE(contains(with("'emission': {'type': 'checker'}"), "runs around the lids"));
  EXPECT_EQ(with("'bsdf': 'm', 'capped': false"), "");
  EXPECT_EQ(with("'emission': 1"), "");
}

TEST(Primitives, MixesOfMixesAreLookedThroughOnce) {
  // Each twice in the next: 2^60 ways to the first.
  std::string bsdfs = "{'name': '0', 'type': 'mirror'}";
  for (int i = 1; i <= 60; ++i) {
    const std::string part = "'" + std::to_string(i - 1) + "'";
    bsdfs += ",{'name': '" + std::to_string(i) + "', 'type': 'mixed', 'bsdf0': " + part +
             ", 'bsdf1': " + part + "}";
  }
  EXPECT_EQ(warnings_of(scene_text(bsdfs, "{'type': 'cylinder', 'bsdf': '60'}")), "");
}

TEST(Primitives, NormalsAreThoseOfTheFileOrNew) {
  const Files files = {{"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nf 1//1 2//1 3//1\n"}};
  const auto normals = [&](const std::string& members) {
    return mesh_of(scene_with("'type': 'mesh', 'file': 'm.obj'" + members, files).shapes.at(0))
        .normals;
  };
  EXPECT_TRUE(normals("").empty());
  expect_near(normals(", 'smooth': true").at(0), {1, 0, 0});
  expect_near(normals(", 'smooth': true, 'recompute_normals': true").at(0), {0, 0, 1});
  EXPECT_TRUE(normals(", 'recompute_normals': true").empty());
}

TEST(Primitives, MeshesOfSeveralMaterialsAreSplit) {
  const Files files = {{"m.wo3", wo3_of_two_materials()}};
  const desc::SceneDesc scene =
      scene_of("{'name': 'a', 'type': 'mirror'}, {'name': 'b', 'type': 'null'}",
               "{'type': 'mesh', 'file': 'm.wo3', 'smooth': true, 'bsdf': ['a', 'b']},"
               "{'type': 'mesh', 'file': 'm.wo3', 'bsdf': 'a'}",
               "{}", files);
  ASSERT_EQ(scene.shapes.size(), 3U);
  EXPECT_EQ(mesh_of(scene.shapes[0]).indices.size(), 1U);
  EXPECT_EQ(mesh_of(scene.shapes[1]).indices.size(), 1U);
  EXPECT_EQ(mesh_of(scene.shapes[1]).positions.size(), 3U);
  EXPECT_EQ(mesh_of(scene.shapes[1]).uvs.at(2), Vec2(0.F, 1.F));
  EXPECT_NE(scene.shapes[0].material, scene.shapes[1].material);
  EXPECT_EQ(mesh_of(scene.shapes[0]).normals.size(), 3U);
  // With one bsdf all of it has that, and without "smooth" no normals.
  EXPECT_EQ(mesh_of(scene.shapes[2]).indices.size(), 2U);
  EXPECT_TRUE(mesh_of(scene.shapes[2]).normals.empty());
}

TEST(Primitives, MirroredMeshesKeepTheSideOfTheirTrianglesInTheWorld) {
  const Files files = {{"m.wo3", wo3_of_two_materials()}};
  const std::string mesh = "'type': 'mesh', 'file': 'm.wo3'";
  EXPECT_FALSE(scene_with(mesh, files).shapes.at(0).reverse_orientation);
  EXPECT_TRUE(scene_with(mesh + ", 'transform': {'scale': [-1, 1, 1]}", files)
                  .shapes.at(0)
                  .reverse_orientation);
}

TEST(Primitives, MirroredSmoothMeshesAreOutsideWhereTheirNormalsAre) {
  const Files files = {{"m.wo3", wo3_of_two_materials()}};
  const auto shape_with = [&](const std::string& rest) {
    return scene_with(
               "'type': 'mesh', 'file': 'm.wo3', 'smooth': true, 'transform': {'scale': [-1, "
               "1, 1]}, 'int_medium': {'type': 'homogeneous', 'sigma_a': 1}" +
                   rest,
               files)
        .shapes.at(0);
  };
  const desc::Shape glass = shape_with("");
  ASSERT_FALSE(mesh_of(glass).normals.empty());
  EXPECT_FALSE(glass.reverse_orientation) << "normals are turned with the mesh, not turned over";
  EXPECT_EQ(glass.inside, desc::kNone) << "media go by the winding";
  EXPECT_EQ(glass.outside, 0);
  const desc::Shape lamp = shape_with(", 'emission': 1");
  EXPECT_TRUE(lamp.reverse_orientation) << "emission goes by the winding";
  EXPECT_EQ(lamp.inside, 0);
}

TEST(Primitives, MeshFilesThatCannotBeUsedAreLeftOutWithAWarning) {
  const Files files = {{"bad.wo3", "short"}, {"m.stl", ""}, {"o.obj", "f 1 2 3\n"}};
  const auto with = [](const std::string& file) {
    return scene_text("", "{'type': 'mesh', 'file': '" + file + "'}");
  };
  for (const char* file : {"bad.wo3", "m.stl", "o.obj", "missing.wo3"}) {
    const std::string warnings = warnings_of(with(file), files);
    EXPECT_TRUE(contains(warnings, "test.json:3:41#/primitives/0/file: cannot use this mesh: "))
        << warnings;
  }
  EXPECT_TRUE(contains(warnings_of(scene_text("", "{'type': 'mesh'}")), "names no \"file\""));
  EXPECT_TRUE(
      contains(warnings_of(scene_text(
                   "", "{'type': 'sphere', 'bsdf': [{'type': 'lambert'}, {'type': 'mirror'}]}")),
               "only meshes can have several bsdfs"));
}

TEST(Primitives, EmitRadianceOrPower) {
  const auto scale = [](const std::string& members) {
    const desc::SceneDesc scene = scene_with(members);
    EXPECT_TRUE(scene.shapes.at(0).emission);
    const desc::Node& node = scene.shapes.at(0).emission->node;
    return node.color("radiance") * node.color("scale");
  };
  expect_near(scale("'type': 'quad', 'emission': [1, 2, 3]"), {1, 2, 3});
  // Φ = π A L.
  expect_near(scale("'type': 'quad', 'power': 8, 'transform': {'scale': 2}"),
              Vec3(8.F / (kPi * 4.F)));
  expect_near(scale("'type': 'sphere', 'power': 8"), Vec3(8.F / (4.F * kPi * kPi)));
  expect_near(scale("'type': 'cube', 'power': 8"), Vec3(8.F / (6.F * kPi)));
  expect_near(scale("'type': 'disk', 'power': 8"), Vec3(8.F / (kPi * kPi)));
  // Side and both lids: 2π/4 + π.
  expect_near(scale("'type': 'cylinder', 'power': 8"), Vec3(8.F / (1.5F * kPi * kPi)));
  EXPECT_FALSE(scene_with("'type': 'quad', 'emission': 0").shapes.at(0).emission);
}

TEST(Primitives, LightsWithoutASurface) {
  const desc::SceneDesc scene =
      scene_of("",
               "{'type': 'point', 'power': [4, 8, 12], 'transform': {'position': [1, 2, 3]}},"
               "{'type': 'infinite_sphere', 'emission': 'a.hdr'},"
               "{'type': 'infinite_sphere', 'emission': 0.5},"
               "{'type': 'sphere'}");
  ASSERT_EQ(scene.lights.size(), 3U);
  expect_near(scene.lights[0].node.color("intensity"), Vec3(1, 2, 3) / kPi);
  expect_near(moved(scene.lights[0].to_world, {0, 0, 0}), {1, 2, 3});
  EXPECT_TRUE(contains(scene.lights[1].node.text("image"), "a.hdr"));
  EXPECT_EQ(scene.lights[2].node.color("radiance"), Vec3(0.5F));
}

TEST(Primitives, ScenesWithoutLightAreInAnEvenOne) {
  const auto lights = [](const std::string& primitives) {
    Warnings warnings;
    return import_with(scene_text("", primitives), warnings).lights;
  };
  for (const char* dark :
       {"{'type': 'quad'}", "{'type': 'quad', 'emission': 0}", "{'type': 'infinite_sphere'}",
        "{'type': 'quad', 'power': {'type': 'constant', 'value': 0}}"}) {
    ASSERT_EQ(lights(dark).size(), 1U) << dark;
    EXPECT_TRUE(lights(dark)[0].node.is("environment"));
    EXPECT_EQ(lights(dark)[0].node.color("radiance"), Vec3(1.F));
  }
  EXPECT_TRUE(lights("{'type': 'quad', 'emission': [0, 0, 1]}").empty());
  EXPECT_TRUE(lights("{'type': 'quad', 'emission': {'type': 'checker'}}").empty());
  // A light of Tungsten's that is left out here.
  EXPECT_TRUE(lights("{'type': 'skydome', 'transform': {'rotation': [0, 0, 120]}}").empty());
  EXPECT_TRUE(
      lights("{'type': 'instances', 'masters': ['a'], 'instances': [], 'emission': 1}").empty());
  EXPECT_EQ(lights("{'type': 'point', 'emission': 2}").size(), 1U);
}

TEST(Primitives, ImagesOfAnInfiniteSphereAreDecodedAsTheySay) {
  const auto light = [](const std::string& image) {
    return scene_of("", "{'type': 'infinite_sphere', 'emission': " + image + "}, {'type': 'quad'}")
        .lights.at(0)
        .node;
  };
  const desc::Node plain = light("'a.png'");
  EXPECT_EQ(plain.number("decoding_exponent"), 2.2F);
  EXPECT_FALSE(plain.flag("nearest"));
  const desc::Node raw =
      light("{'type': 'bitmap', 'file': 'a.png', 'gamma_correct': false, 'interpolate': false}");
  EXPECT_EQ(raw.number("decoding_exponent"), 1.F);
  EXPECT_TRUE(raw.flag("nearest"));
  EXPECT_TRUE(contains(
      warnings_of(scene_text("",
                             "{'type': 'infinite_sphere', 'emission': {'type': 'bitmap', 'file': "
                             "'a.png', 'clamp': true}}, {'type': 'quad'}")),
      "test.json:3:56#/primitives/0/emission: \"clamp\" is not supported here"));
}

TEST(Primitives, ASunOfSomeSizeIsParallelLightOfTheSameIrradiance) {
  const std::string text = scene_text(
      "",
      "{'type': 'infinite_sphere_cap', 'emission': 100, 'cap_angle': 2, 'skydome': 'dome'},"
      "{'type': 'quad', 'name': 'dome', 'transform': {'up': [1, 0, 0]}}");
  EXPECT_TRUE(contains(warnings_of(text), "parallel light of the same strength stands in"));
  Warnings warnings;
  const desc::SceneDesc scene = import_with(text, warnings);
  const float sine = std::sin(2.F * kPi / 180.F);
  expect_near(scene.lights.at(0).node.color("irradiance"), Vec3(100.F * kPi * sine * sine));
  expect_near(transform_vector(scene.lights.at(0).to_world, {0, 0, 1}), {1, 0, 0});
}

TEST(Primitives, SkydomesAreClearSkiesWithTheSunAtTheirY) {
  const std::string text = scene_text("",
                                      "{'type': 'skydome', 'turbidity': 4, 'intensity': 3, "
                                      "'transform': {'rotation': [0, 0, 30]}}, {'type': 'quad'}");
  EXPECT_TRUE(contains(warnings_of(text), "Preetham"));
  Warnings warnings;
  const desc::SceneDesc scene = import_with(text, warnings);
  const desc::Light& sky = scene.lights.at(0);
  ASSERT_TRUE(sky.node.is("sky"));
  EXPECT_EQ(sky.node.number("turbidity"), 4.F);
  EXPECT_NEAR(sky.node.number("elevation"), 60.F, 1e-3F);
  // Per kcd/m²: that of an even spectrum, in units per nanometre.
  EXPECT_NEAR(sky.node.number("scale"), 3.F * 1000.F / (683.F * 106.857F), 1e-5F);
  expect_near(transform_vector(sky.to_world, {0, 0, 1}), {0, 1, 0});
  expect_near(transform_vector(sky.to_world, {1, 0, 0}), {-1, 0, 0});
  const std::string night = scene_text(
      "", "{'type': 'skydome', 'transform': {'rotation': [0, 0, 120]}}, {'type': 'quad'}");
  EXPECT_TRUE(contains(warnings_of(night), "the sun is below the horizon"));
}

TEST(Primitives, SeparateMedia) {
  std::string text =
      "{'media': [{'name': 'fog', 'type': 'homogeneous', 'sigma_a': 1, 'sigma_s': [1, 2, 3], "
      "'density': 2, 'phase_function': {'type': 'henyey_greenstein', 'g': 0.5}}], 'camera': "
      "{'medium': 'fog'}, 'primitives': [{'type': 'sphere', 'int_medium': 'fog'}, {'type': "
      "'quad'}]}";
  for (char& c : text) c = c == '\'' ? '"' : c;
  Warnings warnings;
  const desc::SceneDesc scene = import_with(text, warnings);
  EXPECT_EQ(warnings.count(), 0U);
  EXPECT_EQ(scene.media.at(0).sigma_a, Vec3(2.F));
  EXPECT_EQ(scene.media.at(0).sigma_s, Vec3(2.F, 4.F, 6.F));
  EXPECT_EQ(scene.media.at(0).g, 0.5F);
  EXPECT_EQ(scene.camera.medium, 0);
  EXPECT_TRUE(scene.shapes.at(0).has_medium_interface);
  EXPECT_EQ(scene.shapes.at(0).inside, 0);
  EXPECT_EQ(scene.shapes.at(0).outside, desc::kNone);
  EXPECT_FALSE(scene.shapes.at(1).has_medium_interface);
}

TEST(Primitives, InstancesTurnAndMoveTheirMasters) {
  const desc::SceneDesc scene = scene_of(
      "",
      "{'type': 'instances', 'transform': {'position': [0, 10, 0]},"
      " 'masters': [{'type': 'sphere', 'transform': {'scale': 0.5}}, {'type': 'cube'}],"
      " 'instances': [{'id': 1, 'transform': {'position': [1, 2, 3], 'rotation': [0, 0, 90]}},"
      " {'id': 0}]}");
  ASSERT_EQ(scene.objects.size(), 2U);
  ASSERT_EQ(scene.instances.size(), 2U);
  EXPECT_TRUE(scene.objects[1].shapes.at(0).node.is("mesh"));
  EXPECT_EQ(scene.instances[0].object, 1);
  expect_near(moved(scene.instances[0].to_world, {1, 0, 0}), {1, 13, 3});
  EXPECT_EQ(scene.instances[1].object, 0);
  EXPECT_TRUE(scene.shapes.empty());
}

TEST(Primitives, InstancesWithoutAMasterAreCounted) {
  const std::string text =
      scene_text("",
                 "{'type': 'instances', 'masters': [{'type': 'point'}], 'instances': [{'id': 0}, "
                 "{'id': -1}, {'id': 7}]}");
  EXPECT_TRUE(contains(warnings_of(text), "3 instances have nothing to copy")) << warnings_of(text);
}

TEST(InstanceFiles, HoldPlacesAndMasters) {
  std::string bytes;
  for (const std::uint32_t value : {1U, 0U}) append(bytes, value);
  for (int i = 0; i < 6; ++i) append(bytes, 0.F);
  for (const float value : {1.F, 2.F, 3.F, 0.F, kPi / 2.F, 0.F}) append(bytes, value);
  bytes += '\x05';
  const auto placed = read_instance_file(bytes);
  ASSERT_TRUE(placed && placed->size() == 1);
  EXPECT_EQ(placed->at(0).master, 5);
  expect_near(moved(placed->at(0).to_world, {0, 0, 1}), {2, 2, 3});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(read_instance_file(bytes.substr(0, size))) << size;
  }
}

TEST(InstanceFiles, MayRoundPlaces) {
  std::string bytes;
  for (const std::uint32_t value : {1U, 1U}) append(bytes, value);
  for (const float value : {0.F, 0.F, 0.F, 8.F, 8.F, 8.F}) append(bytes, value);
  // 1/8, 1/4 and 1/2 of the box; a quarter of a turn around (0, 0, 1).
  constexpr std::uint32_t kOne = 1U << 21;
  const std::uint32_t x = kOne / 8;
  const std::uint32_t y = kOne / 4;
  const std::uint32_t z = kOne / 2;
  append(bytes, (x << 11) | (y >> 10));
  append(bytes, (y << 22) | (z << 1));
  append(bytes, (2048U << 20) | (2048U << 8) | 64U);
  bytes += '\0';
  const auto placed = read_instance_file(bytes);
  ASSERT_TRUE(placed && placed->size() == 1);
  expect_near(moved(placed->at(0).to_world, {0, 0, 0}), {1, 2, 4});
  expect_near(moved(placed->at(0).to_world, {1, 0, 0}), {1, 3, 4});
}

TEST(Primitives, UnknownOrUnsupportedOnesAreLeftOut) {
  EXPECT_TRUE(contains(
      warnings_of(scene_text("", "{'type': 'qad'}")),
      "test.json:3:16#/primitives/0: unknown primitive type \"qad\"; did you mean \"quad\"?"));
  EXPECT_TRUE(contains(warnings_of(scene_text("", "{'type': 'minecraft_map'}")),
                       "\"minecraft_map\" are not supported"));
  EXPECT_TRUE(contains(warnings_of(scene_text("", "{'type': 'sphere', 'transform': {'scale': 0}}")),
                       "cannot be inverted: left out"));
  EXPECT_TRUE(contains(error_of(scene_text("", "{'name': 'a'}")), "a primitive needs \"type\""));
  EXPECT_TRUE(contains(error_of(scene_text("", "7")), "must be a primitive, which is an object"));
}

}  // namespace
}  // namespace ajar::tungsten
