#include <zlib.h>

#include <cstring>

#include "import/mitsuba/import_test_support.h"
#include "import/mitsuba/serialized.h"

namespace ajar::mitsuba {
namespace {

const std::string kQuad =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 0.25\n"
    "f 1/1 2/2 3/3 4/4\n";

desc::MeshPointer mesh_of(const std::string& properties) {
  const desc::SceneDesc scene =
      scene_of("<shape type=\"obj\"><string name=\"filename\" value=\"q.obj\"/>" + properties +
                   "<bsdf type=\"dielectric\"/></shape>",
               {{"q.obj", kQuad}});
  return scene.shapes.front().node.mesh("mesh");
}

TEST(MitsubaShapes, MeshesAreSmoothUnlessTheyAskForFaces) {
  EXPECT_EQ(mesh_of("")->normals, std::vector<Vec3>(4, Vec3(0.F, 0.F, 1.F)));
  EXPECT_TRUE(mesh_of("<boolean name=\"faceNormals\" value=\"true\"/>")->normals.empty());
}

TEST(MitsubaShapes, MirrorsTurnNormalsThatNoFileHasSinceVersion3) {
  struct Read {
    desc::MeshPointer mesh;
    std::string warnings;
  };
  const auto read = [](const std::string& version, const std::string& scale,
                       const std::string& properties) {
    Warnings warnings;
    const desc::SceneDesc scene = import_with(
        "<scene version=\"" + version +
            "\"><sensor type=\"perspective\"/><shape type=\"obj\"><string name=\"filename\" "
            "value=\"q.obj\"/><transform name=\"to_world\"><scale z=\"" +
            scale + "\"/></transform>" + properties + "<bsdf type=\"dielectric\"/></shape></scene>",
        warnings, {{"q.obj", kQuad}});
    return Read{scene.shapes.front().node.mesh("mesh"), lines_of(warnings)};
  };
  const std::string faces = "<boolean name=\"faceNormals\" value=\"true\"/>";
  for (const std::string version : {"0.6.0", "3.0.0"}) {
    const bool is_old = version == "0.6.0";
    const Read smooth = read(version, "-1", "");
    const Read flat = read(version, "-1", faces);
    const Read plain = read(version, "1", faces);
    EXPECT_EQ(plain.warnings, "");
    // Before, it takes them of the vertices in the world: a mirror across z leaves this quad as it
    // is, and the transform turns the normal back.
    EXPECT_EQ(smooth.mesh->normals.front(), Vec3(0.F, 0.F, is_old ? -1.F : 1.F));
    EXPECT_EQ(flat.mesh->indices.front().y == plain.mesh->indices.front().z, is_old);
    for (const Read* mirrored : {&smooth, &flat}) {
      EXPECT_EQ(contains(mirrored->warnings, "as in Mitsuba 3.10"), !is_old) << mirrored->warnings;
    }
  }
}

/// Mitsuba 3.9 shows nothing of one that shines and is mirrored.
TEST(MitsubaShapes, MirrorsTurnSpheresInsideOutSinceVersion2) {
  const auto is_turned = [](const std::string& version, const std::string& type,
                            const std::string& more) {
    Warnings warnings;
    return import_with("<scene version=\"" + version +
                           "\"><sensor type=\"perspective\"/><shape type=\"" + type +
                           "\"><transform name=\"toWorld\"><scale x=\"-1\"/></transform>" + more +
                           "<bsdf type=\"dielectric\"/></shape></scene>",
                       warnings)
        .shapes.front()
        .reverse_orientation;
  };
  EXPECT_TRUE(is_turned("3.0.0", "sphere", ""));
  EXPECT_FALSE(is_turned("3.0.0", "sphere", "<boolean name=\"flip_normals\" value=\"true\"/>"));
  EXPECT_FALSE(is_turned("0.6.0", "sphere", ""));
  EXPECT_FALSE(is_turned("3.0.0", "cylinder", ""));
  EXPECT_TRUE(contains(warnings_of("<shape type=\"sphere\"><transform name=\"to_world\"><scale "
                                   "y=\"2\"/></transform><bsdf type=\"dielectric\"/></shape>"),
                       "test.xml:2:1: this sphere is stretched"));
}

TEST(MitsubaShapes, ObjFilesCountVFromTheBottomRow) {
  EXPECT_EQ(mesh_of("")->uvs[3], Vec2(0.F, 0.75F));
  EXPECT_EQ(mesh_of("<boolean name=\"flipTexCoords\" value=\"false\"/>")->uvs[3], Vec2(0.F, 0.25F));
}

/// Mitsuba 3 does not read them.
TEST(MitsubaShapes, MaterialsOfObjFilesAreWarningsWhereTheirShapesHaveNone) {
  const Files files = {{"m.obj", "mtllib m.mtl\n" + kQuad}, {"q.obj", kQuad}};
  const auto warnings_with = [&](const std::string& version, const std::string& properties,
                                 const std::string& file = "m.obj") {
    return warnings_in([&](Warnings& warnings) {
      import_with("<scene version=\"" + version + "\"><sensor type=\"perspective\"/>" +
                      "<shape type=\"obj\"><string name=\"filename\" value=\"" + file + "\"/>" +
                      properties + "</shape></scene>",
                  warnings, files);
    });
  };
  const std::string told = "the materials that this file names are not read";
  EXPECT_TRUE(contains(warnings_with("0.6.0", ""), told));
  EXPECT_FALSE(contains(warnings_with("0.6.0", "", "q.obj"), told));
  EXPECT_FALSE(contains(warnings_with("0.6.0", "<bsdf type=\"dielectric\"/>"), told));
  EXPECT_FALSE(
      contains(warnings_with("0.6.0", "<boolean name=\"loadMaterials\" value=\"false\"/>"), told));
  EXPECT_FALSE(contains(warnings_with("3.0.0", ""), told));
}

TEST(MitsubaShapes, MissingMeshesAreLeftOutWithAWarning) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      world("<shape type=\"ply\"><string name=\"filename\" value=\"no.ply\"/></shape>"), warnings);
  EXPECT_EQ(scene.shapes.size(), 1U);
  bool told = false;
  for (const std::string& message : warnings.messages()) {
    told |= message.starts_with("test.xml:2:1: cannot use this mesh");
  }
  EXPECT_TRUE(told);
}

TEST(MitsubaShapes, ObjFilesOfVersion0HaveAMeshForEachGroupAndMaterial) {
  const Files files = {{"m.obj",
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng a\nusemtl x\nf 1 2 3\nusemtl y\n"
                        "f 1 2 4\nf 2 3 4\ng b\ng c\nf 1 3 4\n"}};
  const auto import = [&](const std::string& more, Warnings& warnings) {
    return import_with(
        "<scene version=\"0.6.0\"><shape type=\"obj\"><string name=\"filename\" value=\"m.obj\"/>" +
            more + "</shape><sensor type=\"perspective\"/></scene>",
        warnings, files);
  };
  const auto triangles = [&](const std::string& more) {
    Warnings warnings;
    const desc::SceneDesc scene = import(more, warnings);
    expect_none(warnings, more);
    return scene.shapes.at(0).node.mesh("mesh")->indices.size();
  };
  const auto index = [](int i) {
    return "<integer name=\"shapeIndex\" value=\"" + std::to_string(i) + "\"/>";
  };
  EXPECT_EQ(triangles(""), 4U);
  EXPECT_EQ(triangles(index(-1)), 4U);
  EXPECT_EQ(triangles(index(0)), 1U);
  EXPECT_EQ(triangles(index(1)), 2U);
  EXPECT_EQ(triangles(index(2)), 1U);
  Warnings warnings;
  EXPECT_TRUE(import(index(3), warnings).shapes.empty());
  EXPECT_TRUE(contains(lines_of(warnings), "there is no run of faces 3")) << lines_of(warnings);
}

TEST(MitsubaShapes, SquaresFaceOutward) {
  for (const char* type : {"rectangle", "cube"}) {
    const desc::SceneDesc scene =
        scene_of("<shape type=\"" + std::string(type) + "\"><bsdf type=\"dielectric\"/></shape>");
    const desc::Mesh& mesh = *scene.shapes.front().node.mesh("mesh");
    EXPECT_EQ(mesh.indices.size(), type == std::string("cube") ? 12U : 2U);
    for (const Imath::Vec3<unsigned>& t : mesh.indices) {
      const Vec3& p = mesh.positions[t.x];
      const Vec3 n = cross(mesh.positions[t.y] - p, mesh.positions[t.z] - p);
      const Vec3 middle = (p + mesh.positions[t.y] + mesh.positions[t.z]) / 3.F;
      EXPECT_GT(type == std::string("cube") ? dot(n, middle) : n.z, 0.F);
    }
  }
}

TEST(MitsubaShapes, SpheresHaveTheirNorthPoleWhereMitsubaHasIt) {
  const desc::SceneDesc scene = scene_of(
      "<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"2\" z=\"3\"/><float "
      "name=\"radius\" "
      "value=\"2\"/><transform name=\"to_world\"><scale value=\"10\"/></transform></shape>");
  const desc::Shape& sphere = scene.shapes.front();
  // v = 1 of our sphere is at +z of its space; v = 0 of Mitsuba's at +z of its own.
  expect_near(transform_point(sphere.to_world, {0.F, 0.F, -2.F}), {10.F, 20.F, 50.F});
  EXPECT_FALSE(sphere.reverse_orientation);
}

TEST(MitsubaShapes, CylindersReachFromP0ToP1) {
  const desc::SceneDesc scene = scene_of(
      "<shape type=\"cylinder\"><point name=\"p0\" x=\"1\" y=\"0\" z=\"0\"/><point name=\"p1\" "
      "value=\"1, 5, 0\"/><float name=\"radius\" value=\"0.5\"/><boolean name=\"flip_normals\" "
      "value=\"true\"/><bsdf type=\"dielectric\"/></shape>");
  const desc::Shape& cylinder = scene.shapes.front();
  EXPECT_EQ(cylinder.node.number("z_max"), 5.F);
  EXPECT_EQ(cylinder.node.number("radius"), 0.5F);
  EXPECT_TRUE(cylinder.reverse_orientation);
  expect_near(transform_point(cylinder.to_world, {0.F, 0.F, 5.F}), {1.F, 5.F, 0.F});
}

TEST(MitsubaShapes, GroupsAreSeenByTheirInstancesOnly) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      world("<shape type=\"shapegroup\" id=\"g\"><shape type=\"sphere\"><emitter "
            "type=\"area\"/></shape></shape><shape type=\"instance\"><ref id=\"g\"/><transform "
            "name=\"to_world\"><translate x=\"4\"/></transform></shape><shape "
            "type=\"instance\"><ref id=\"g\"/></shape>"),
      warnings);
  EXPECT_EQ(scene.shapes.size(), 1U);
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_EQ(scene.objects[0].shapes.size(), 1U);
  EXPECT_FALSE(scene.objects[0].shapes[0].emission);
  ASSERT_EQ(scene.instances.size(), 2U);
  expect_near(transform_point(scene.instances[0].to_world, {0, 0, 0}), {4, 0, 0});
  EXPECT_EQ(warnings.count(Effect::Light), 1U);
}

TEST(MitsubaShapes, LampsWithoutMaterialAreBlackOthersGrey) {
  const desc::SceneDesc scene = scene_of(
      "<shape type=\"sphere\"><emitter type=\"area\"><rgb name=\"radiance\" value=\"1 2 3\"/>"
      "</emitter></shape><shape type=\"sphere\"/>");
  const auto reflectance = [&](std::size_t shape) {
    return scene.materials[static_cast<std::size_t>(scene.shapes[shape].material)].node.color(
        "reflectance");
  };
  EXPECT_EQ(scene.shapes[0].emission->node.color("radiance"), Vec3(1.F, 2.F, 3.F));
  EXPECT_FALSE(scene.shapes[0].emission->node.flag("two_sided"));
  EXPECT_EQ(reflectance(0), Vec3(0.F));
  EXPECT_EQ(reflectance(1), Vec3(0.5F));
}

TEST(MitsubaShapes, MediaOfVersion0NeedNoMaterial) {
  const std::string scene =
      "<sensor type=\"perspective\"/><shape type=\"sphere\"><medium type=\"homogeneous\" "
      "name=\"interior\"><rgb name=\"sigma_t\" value=\"2\"/><rgb name=\"albedo\" value=\"0.25\"/>"
      "<float name=\"scale\" value=\"10\"/><phase type=\"hg\"><float name=\"g\" value=\"0.5\"/>"
      "</phase></medium></shape></scene>";
  Warnings warnings;
  const desc::SceneDesc old = import_with("<scene version=\"0.6.0\">" + scene, warnings);
  EXPECT_TRUE(old.materials[static_cast<std::size_t>(old.shapes[0].material)].node.is("interface"));
  const desc::SceneDesc now = import_with("<scene version=\"3.0.0\">" + scene, warnings);
  EXPECT_TRUE(now.materials[static_cast<std::size_t>(now.shapes[0].material)].node.is("diffuse"));
  EXPECT_EQ(warnings.count(), 0U);
  ASSERT_EQ(now.media.size(), 1U);
  EXPECT_TRUE(now.shapes[0].has_medium_interface);
  EXPECT_EQ(now.media[0].sigma_s, Vec3(5.F));
  EXPECT_EQ(now.media[0].sigma_a, Vec3(15.F));
  EXPECT_EQ(now.media[0].g, 0.5F);
}

TEST(MitsubaShapes, TexturesOfDisksRunOutwardAndThenAround) {
  const std::string board = "type=\"checkerboard\"/>";
  const desc::SceneDesc scene = scene_of(
      "<shape type=\"disk\"><bsdf type=\"difftrans\"><texture name=\"transmittance\" " + board +
      "</bsdf><emitter type=\"area\"><texture name=\"radiance\" " + board + "</emitter></shape>");
  EXPECT_EQ(scene.shapes[0].node.text("coordinates"), "radius_then_angle");
}

TEST(MitsubaShapes, UnsupportedOnesAreLeftOut) {
  EXPECT_TRUE(contains(warnings_of("<shape type=\"sdfgrid\"/>"), "unknown shape \"sdfgrid\""));
  EXPECT_TRUE(contains(warnings_of("<shape type=\"sphere\"><transform name=\"to_world\"><scale "
                                   "x=\"0\"/></transform></shape>"),
                       "cannot be inverted"));
}

// ---------------------------------------------------------------- serialized meshes

template <typename T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// One triangle, its first vertex at x.
std::string serialized(std::uint16_t version, float x, std::uint32_t flags = 0) {
  std::string body;
  put<std::uint32_t>(body, 0x1000U | flags);
  if (version == 4) body += std::string("name\0", 5);
  put<std::uint64_t>(body, 3);
  put<std::uint64_t>(body, 1);
  for (const float v : {x, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) put(body, v);
  for (int i = 0; i < 9 && (flags & 1U) != 0; ++i) put(body, i % 3 == 2 ? 1.F : 0.F);
  for (const std::uint32_t i : {0U, 1U, 2U}) put(body, i);
  std::string packed(compressBound(body.size()), '\0');
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(body.data()), body.size());
  std::string out;
  put<std::uint16_t>(out, 0x041C);
  put<std::uint16_t>(out, version);
  return out + packed.substr(0, size);
}

template <typename Offset>
std::string two_meshes(std::uint16_t version) {
  std::string file = serialized(version, 5.F);
  const std::size_t second = file.size();
  file += serialized(version, 7.F, 1U);
  put<Offset>(file, 0);
  put<Offset>(file, static_cast<Offset>(second));
  put<std::uint32_t>(file, 2);
  return file;
}

TEST(SerializedMeshes, OfBothVersionsAreFoundByTheirIndex) {
  for (const std::string& file : {two_meshes<std::uint32_t>(3), two_meshes<std::uint64_t>(4)}) {
    EXPECT_EQ(read_serialized(file, "m", 0).positions[0].x, 5.F);
    const desc::Mesh second = read_serialized(file, "m", 1);
    EXPECT_EQ(second.positions[0].x, 7.F);
    EXPECT_EQ(second.normals, std::vector<Vec3>(3, Vec3(0.F, 0.F, 1.F)));
    EXPECT_EQ(second.indices[0], Imath::Vec3<unsigned>(0, 1, 2));
    EXPECT_THROW(read_serialized(file, "m", 2), SceneError);
    EXPECT_THROW(read_serialized(file, "m", -1), SceneError);
  }
  EXPECT_EQ(read_serialized(serialized(4, 3.F), "m", 0).positions[0].x, 3.F);
}

TEST(SerializedMeshes, KeepTheirNormalsWithAnyFlags) {
  const desc::Mesh faceted = read_serialized(serialized(4, 0.F, 0x11U), "m", 0);
  EXPECT_EQ(faceted.normals, std::vector<Vec3>(3, Vec3(0.F, 0.F, 1.F)));
}

TEST(SerializedMeshes, DamagedOnesAreRefused) {
  const std::string file = two_meshes<std::uint64_t>(4);
  for (std::size_t size = 0; size < serialized(4, 5.F).size(); ++size) {
    EXPECT_THROW(read_serialized(file.substr(0, size), "m", 0), SceneError) << size;
  }
  std::string other = file;
  other[2] = 5;
  EXPECT_THROW(read_serialized(other, "m", 0), SceneError);
}

}  // namespace
}  // namespace ajar::mitsuba
