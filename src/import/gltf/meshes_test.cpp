#include "import/gltf/meshes.h"

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

using Triangle = Imath::Vec3<unsigned>;

/// A file of one primitive, with a material so that nothing is added for it.
TestFile file_of(const Json& primitive, TestFile file) {
  Json with_material = primitive;
  with_material["material"] = file.add("materials", Json::object());
  file.add("meshes", {{"primitives", Json::array({with_material})}});
  file.add("nodes", {{"mesh", 0}});
  return file;
}

/// Five positions (i, i², 0) and no indices.
TestFile five_corners(const char* attribute = "POSITION") {
  TestFile file;
  std::vector<float> numbers;
  for (int i = 0; i < 5; ++i) {
    numbers.insert(numbers.end(), {static_cast<float>(i), static_cast<float>(i * i), 0.F});
  }
  const std::size_t positions = file.add_accessor(bytes_of(numbers), 5126, "VEC3", 5);
  file.json["extras"] = {{"attributes", {{attribute, positions}}}};
  return file;
}

TEST(GltfMeshes, FlipTextureCoordinatesSoThatVPointsUp) {
  TestFile file;
  const Json triangle = file.triangle();
  const desc::SceneDesc scene = scene_of(file_of(triangle, file));
  EXPECT_EQ(mesh_of(scene).positions[1], Vec3(1.F, 0.F, 0.F));
  EXPECT_EQ(mesh_of(scene).indices, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(mesh_of(scene).uvs, (std::vector<Vec2>{{0.F, 1.F}, {1.F, 1.F}, {0.F, 0.F}}));
  EXPECT_TRUE(mesh_of(scene).normals.empty());
}

TEST(GltfMeshes, StripsAndFansKeepTheWindingOfTheSpecification) {
  for (const auto& [mode, expected] :
       std::vector<std::pair<int, std::vector<Triangle>>>{{4, {{0, 1, 2}}},
                                                          {5, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}},
                                                          {6, {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}}}) {
    TestFile file = five_corners();
    const Json primitive = {{"attributes", file.json["extras"]["attributes"]}, {"mode", mode}};
    EXPECT_EQ(mesh_of(scene_of(file_of(primitive, file))).indices, expected) << mode;
  }
}

TEST(GltfMeshes, IndicesMayBeOfThreeTypes) {
  const std::vector<std::pair<int, std::string>> types = {
      {5121, bytes_of<std::uint8_t>({3, 1, 0})},
      {5123, bytes_of<std::uint16_t>({3, 1, 0})},
      {5125, bytes_of<std::uint32_t>({3, 1, 0})}};
  for (const auto& [type, bytes] : types) {
    TestFile file = five_corners();
    const std::size_t indices = file.add_accessor(bytes, type, "SCALAR", 3);
    const Json primitive = {{"attributes", file.json["extras"]["attributes"]},
                            {"indices", indices}};
    EXPECT_EQ(mesh_of(scene_of(file_of(primitive, file))).indices,
              (std::vector<Triangle>{{3, 1, 0}}));
  }
}

TEST(GltfMeshes, IndicesOfOtherTypesAndBeyondTheVerticesAreErrors) {
  TestFile file = five_corners();
  const Json attributes = file.json["extras"]["attributes"];
  const std::size_t floats = file.add_accessor(bytes_of<float>({0, 1, 2}), 5126, "SCALAR", 3);
  const std::size_t beyond =
      file.add_accessor(bytes_of<std::uint8_t>({0, 1, 5}), 5121, "SCALAR", 3);
  EXPECT_EQ(error_of(file_of({{"attributes", attributes}, {"indices", floats}}, file).text()),
            "test.gltf#/accessors/1/componentType: indices are of the type 5121, 5123 or 5125, "
            "not 5126");
  EXPECT_EQ(error_of(file_of({{"attributes", attributes}, {"indices", beyond}}, file).text()),
            "test.gltf#/meshes/0/primitives/0: mesh triangle 0 refers to vertex 5 of 5");
}

TEST(GltfMeshes, QuantizedAndStridedAttributesAreUnpacked) {
  TestFile file;
  // Positions as shorts, every 8 bytes; normals as normalised bytes, every 4 bytes.
  const std::size_t positions = file.add_accessor(
      bytes_of<std::int16_t>({0, 0, 0, 99, 200, 0, 0, 99, 0, -300, 0, 99}), 5122, "VEC3", 3, 8);
  const std::size_t normals = file.add_accessor(
      bytes_of<std::int8_t>({0, 0, 127, 99, 0, -128, 0, 99, 127, 0, 0, 99}), 5120, "VEC3", 3, 4);
  file.json["accessors"][normals]["normalized"] = true;
  const Json primitive = {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}};
  file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  const desc::SceneDesc scene = scene_of(file_of(primitive, file));
  EXPECT_EQ(mesh_of(scene).positions, (std::vector<Vec3>{{0, 0, 0}, {200, 0, 0}, {0, -300, 0}}));
  EXPECT_EQ(mesh_of(scene).normals, (std::vector<Vec3>{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}}));
}

TEST(GltfMeshes, SparseAccessorsReplaceSomeElements) {
  TestFile file = five_corners();
  const std::size_t indices = file.add_view(bytes_of<std::uint16_t>({1, 4}));
  const std::size_t values = file.add_view(bytes_of<float>({7, 8, 9, 0, -1, 0}));
  file.json["accessors"][0]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
  const Json primitive = {{"attributes", file.json["extras"]["attributes"]}, {"mode", 6}};
  const desc::SceneDesc scene = scene_of(file_of(primitive, file));
  EXPECT_EQ(mesh_of(scene).positions,
            (std::vector<Vec3>{{0, 0, 0}, {7, 8, 9}, {2, 4, 0}, {3, 9, 0}, {0, -1, 0}}));

  file.json["accessors"][0]["count"] = 4;
  EXPECT_TRUE(contains(error_of(file_of(primitive, file).text()),
                       "#/accessors/0/sparse/indices: index 1 is 4, but there are 4 elements"));
}

TEST(GltfMeshes, ElementsBeyondTheirBytesAreErrors) {
  const auto error_with = [](const char* member, std::uint64_t value, const char* array) {
    TestFile file = five_corners();
    file.json[array][0][member] = value;
    const Json primitive = {{"attributes", file.json["extras"]["attributes"]}};
    return error_of(file_of(primitive, file).text());
  };
  EXPECT_TRUE(contains(error_with("count", 6, "accessors"), "reach beyond their buffer view"));
  EXPECT_TRUE(contains(error_with("count", 4294967295, "accessors"), "reach beyond"));
  for (const std::uint64_t count : {std::uint64_t{4294967296}, UINT64_MAX}) {
    EXPECT_TRUE(contains(error_with("count", count, "accessors"),
                         "#/accessors/0/count: these are " + std::to_string(count) + " elements"));
  }
  EXPECT_TRUE(contains(error_with("byteOffset", 4, "accessors"), "reach beyond"));
  EXPECT_TRUE(contains(error_with("byteOffset", UINT64_MAX, "accessors"), "reach beyond"));
  EXPECT_TRUE(contains(error_with("byteOffset", UINT64_MAX, "bufferViews"),
                       "#/bufferViews/0: this reaches beyond its buffer"));
  EXPECT_TRUE(contains(error_with("byteLength", 61, "bufferViews"), "beyond its buffer"));
  EXPECT_TRUE(contains(error_with("byteStride", 4096, "bufferViews"), "a stride is at most 252"));
  EXPECT_TRUE(contains(error_with("bufferView", 7, "accessors"),
                       "#/accessors/0/bufferView: refers to number 7, but there are 1"));
  EXPECT_TRUE(contains(error_with("componentType", 5124, "accessors"), "no component type"));
}

TEST(GltfMeshes, ZerosWithoutBytesAreNoMoreThanTheFileHas) {
  TestFile file = five_corners();
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 4'000'000'000U;
  const Json primitive = {{"attributes", file.json["extras"]["attributes"]}};
  EXPECT_TRUE(contains(error_of(file_of(primitive, file).text()), "have no bytes of their own"));
}

TEST(GltfMeshes, TypesOfAccessorsAreChecked) {
  TestFile file = five_corners();
  const Json primitive = {{"attributes", file.json["extras"]["attributes"]}};
  file.json["accessors"][0]["type"] = "VEC2";
  EXPECT_TRUE(contains(error_of(file_of(primitive, file).text()),
                       "#/accessors/0/type: a VEC3 is needed here, not a VEC2"));
  file.json["accessors"][0]["type"] = "VEC";
  EXPECT_TRUE(contains(error_of(file_of(primitive, file).text()), "did you mean \"VEC"));
}

TEST(GltfMeshes, PointsAreWarnings) {
  TestFile file = five_corners();
  const Json attributes = file.json["extras"]["attributes"];
  EXPECT_TRUE(contains(warnings_of(file_of({{"attributes", attributes}, {"mode", 0}}, file)),
                       "#/meshes/0/primitives/0: this primitive is made of points or lines"));
}

/// Three corners, with the material if there is one.
TestFile colored(const std::vector<float>& rgba, const char* type, const Json& material = {}) {
  TestFile file;
  Json primitive = file.triangle();
  primitive["attributes"]["COLOR_0"] =
      file.add_accessor(bytes_of(rgba), 5126, type, rgba.size() / (type[3] == '4' ? 4 : 3));
  if (!material.is_null()) primitive["material"] = file.add("materials", material);
  file.add("meshes", {{"primitives", Json::array({primitive})}});
  file.add("nodes", {{"mesh", 0}});
  return file;
}

TEST(GltfMeshes, ColorsOfVerticesAreAnImageOfTheirOwn) {
  const TestFile file = colored({1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
  const desc::SceneDesc scene = scene_of(file);
  const desc::Shape& shape = scene.shapes.front();
  const desc::Node& material = scene.materials[static_cast<std::size_t>(shape.material)].node;
  const desc::Node& image =
      scene.textures[static_cast<std::size_t>(material.texture("base_color"))].node;
  EXPECT_EQ(image.text("file"), "/scene/test.gltf/meshes/0/primitives/0/attributes/COLOR_0.exr");
  EXPECT_EQ(scene.embedded_files.count(image.text("file")), 1U);
  EXPECT_EQ(shape.node.mesh("mesh")->uvs.size(), 3U);
}

TEST(GltfMeshes, ColorsOfVerticesAreShownBesideATextureOfOcclusion) {
  TestFile file =
      colored({1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3", {{"occlusionTexture", {{"index", 0}}}});
  file.add("images", {{"uri", "a.png"}});
  file.add("textures", {{"source", 0}});
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_EQ(scene.embedded_files.size(), 1U);
}

TEST(GltfMeshes, ColorsOfVerticesThatCannotBeShownAreWarnings) {
  EXPECT_TRUE(contains(warnings_of(colored({1, 0, 0, 0, 1, 0}, "VEC3")),
                       "#/meshes/0/primitives/0/attributes/COLOR_0: there are 2 colours for 3 "
                       "vertices: ignored"));
  EXPECT_TRUE(contains(warnings_of(colored({1, 0, 0, 1, 0, 1, 0, 0.5F, 0, 0, 1, 1}, "VEC4")),
                       "the alpha of vertices is not supported"));
  TestFile file = colored({1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3",
                          {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  file.add("images", {{"uri", "a.png"}});
  file.add("textures", {{"source", 0}});
  Warnings warnings;
  const desc::SceneDesc scene = import_with(file.text(), warnings, {{"a.png", ""}});
  EXPECT_TRUE(contains(lines_of(warnings), "beside a texture, the mean of these colours is used"));
  const desc::Material& material =
      scene.materials[static_cast<std::size_t>(scene.shapes.front().material)];
  const desc::Node& product =
      scene.textures[static_cast<std::size_t>(material.node.texture("base_color"))].node;
  expect_near(product.vector("second"), Vec3(1.F / 3));
}

TEST(GltfMeshes, WithTexturesAndWithoutTheirCoordinatesAreWarnings) {
  TestFile file;
  file.add_triangle(
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}});
  file.add("images", {{"uri", "data:image/png;base64,AAAA"}});
  file.add("textures", {{"source", 0}});
  const std::string told = "#/meshes/0/primitives/0: this primitive has no TEXCOORD_1";
  EXPECT_TRUE(contains(warnings_of(file), told)) << warnings_of(file);
  Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["TEXCOORD_1"] = attributes["TEXCOORD_0"];
  EXPECT_FALSE(contains(warnings_of(file), told));
}

TEST(GltfMeshes, OfTheSameAccessorsAreTheSameMesh) {
  TestFile file;
  const Json triangle = file.triangle();
  Json first = triangle;
  Json second = triangle;
  first["material"] = file.add("materials", Json::object());
  second["material"] = file.add("materials", Json::object());
  file.add("meshes", {{"primitives", Json::array({first, second})}});
  file.add("nodes", {{"mesh", 0}});
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_EQ(scene.shapes[0].node.mesh("mesh"), scene.shapes[1].node.mesh("mesh"));
  EXPECT_NE(scene.shapes[0].material, scene.shapes[1].material);
}

TEST(GltfMeshes, HaveTangentsWhereANormalMapNeedsThem) {
  const auto tangents_of = [](const Json& material) {
    TestFile file;
    Json triangle = file.triangle();
    triangle["attributes"]["TANGENT"] =
        file.add_accessor(bytes_of<float>({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, -1}), 5126, "VEC4", 3);
    triangle["attributes"]["NORMAL"] =
        file.add_accessor(bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}), 5126, "VEC3", 3);
    triangle["material"] = file.add("materials", material);
    file.add("images", {{"uri", "a.png"}});
    file.add("textures", {{"source", 0}});
    file.add("meshes", {{"primitives", Json::array({triangle})}});
    file.add("nodes", {{"mesh", 0}});
    Warnings warnings;
    const desc::SceneDesc scene = import_with(file.text(), warnings, {{"a.png", ""}});
    expect_none(warnings);
    return mesh_of(scene).tangents;
  };
  EXPECT_EQ(tangents_of({{"normalTexture", {{"index", 0}}}}), std::vector<Vec3>(3, {0, 1, 0}));
  EXPECT_TRUE(tangents_of(Json::object()).empty());
}

/// A triangle in the plane of x and y that faces +z, with tangents along x of this fourth part.
desc::Mesh with_signs(std::vector<float> signs, bool has_normals, const std::vector<float>& uvs) {
  TestFile file;
  Json triangle = file.triangle();
  std::vector<float> tangents;
  for (const float sign : signs) tangents.insert(tangents.end(), {1, 0, 0, sign});
  Json& attributes = triangle["attributes"];
  attributes["TANGENT"] = file.add_accessor(bytes_of<float>(tangents), 5126, "VEC4", 3);
  attributes["TEXCOORD_0"] = file.add_accessor(bytes_of<float>(uvs), 5126, "VEC2", 3);
  attributes.erase("NORMAL");
  if (has_normals) {
    attributes["NORMAL"] =
        file.add_accessor(bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}), 5126, "VEC3", 3);
  }
  triangle["material"] = file.add("materials", {{"normalTexture", {{"index", 0}}}});
  file.add("images", {{"uri", "a.png"}});
  file.add("textures", {{"source", 0}});
  file.add("meshes", {{"primitives", Json::array({triangle})}});
  file.add("nodes", {{"mesh", 0}});
  Warnings warnings;
  return mesh_of(import_with(file.text(), warnings, {{"a.png", ""}}));
}

TEST(GltfMeshes, KeepTheSignOfTangentsAgainstTextureCoordinates) {
  using Signs = std::vector<std::int8_t>;
  // v down in the file is up here; the second triangle is the mirror image of the first.
  const std::vector<float> up = {0, 1, 1, 1, 0, 0};
  const std::vector<float> down = {0, 0, 1, 0, 0, 1};
  EXPECT_EQ(with_signs({1, 1, 1}, true, up).handedness, Signs());
  EXPECT_EQ(with_signs({-1, -1, -1}, true, down).handedness, Signs());
  EXPECT_EQ(with_signs({-1, -1, -1}, true, up).handedness, Signs({-1, -1, -1}));
  EXPECT_EQ(with_signs({1, 1, 1}, true, down).handedness, Signs({1, 1, 1}));
  EXPECT_EQ(with_signs({1, -1, 0}, true, up).handedness, Signs({1, -1, 0}));
}

TEST(GltfMeshes, TangentsWithoutNormalsAreIgnored) {
  EXPECT_TRUE(with_signs({1, 1, 1}, false, {0, 1, 1, 1, 0, 0}).tangents.empty());
  EXPECT_EQ(with_signs({1, 1, 1}, true, {0, 1, 1, 1, 0, 0}).tangents.size(), 3U);
}

TEST(GltfMeshes, ElementsWithoutBytesAreZero) {
  TestFile file = five_corners();
  Json attributes = file.json["extras"]["attributes"];
  attributes["TEXCOORD_0"] =
      file.add("accessors", {{"componentType", 5126}, {"type", "VEC2"}, {"count", 5}});
  const std::size_t indices = file.add_view(bytes_of<std::uint8_t>({1}));
  const std::size_t values = file.add_view(bytes_of<float>({7, 8, 9}));
  attributes["NORMAL"] =
      file.add("accessors", {{"componentType", 5126},
                             {"type", "VEC3"},
                             {"count", 5},
                             {"sparse",
                              {{"count", 1},
                               {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                               {"values", {{"bufferView", values}}}}}});
  const desc::SceneDesc scene = scene_of(file_of({{"attributes", attributes}}, file));
  EXPECT_EQ(mesh_of(scene).uvs, std::vector<Vec2>(5, Vec2(0.F, 1.F)));
  EXPECT_EQ(mesh_of(scene).normals,
            (std::vector<Vec3>{Vec3(0.F), {7, 8, 9}, Vec3(0.F), Vec3(0.F), Vec3(0.F)}));
}

TEST(GltfMeshes, IntegerColorsAreNormalised) {
  TestFile file = five_corners();
  Json attributes = file.json["extras"]["attributes"];
  attributes["COLOR_0"] =
      file.add_accessor(bytes_of<std::uint8_t>({51,  102, 153, 255, 51,  102, 153, 255, 51,  102,
                                                153, 255, 51,  102, 153, 255, 51,  102, 153, 255}),
                        5121, "VEC4", 5);
  const TestFile whole = file_of({{"attributes", attributes}}, file);
  Warnings warnings;
  const desc::SceneDesc scene = import_with(whole.text(), warnings);
  ASSERT_EQ(scene.embedded_files.size(), 1U);
  EXPECT_TRUE(contains(lines_of(warnings),
                       "#/meshes/0/primitives/0/attributes/COLOR_0: these "
                       "colours are integers without \"normalized\""));
  file.json["accessors"][file.json["accessors"].size() - 1]["normalized"] = true;
  Warnings none;
  const desc::SceneDesc same =
      import_with(file_of({{"attributes", attributes}}, file).text(), none);
  EXPECT_EQ(*scene.embedded_files.begin()->second, *same.embedded_files.begin()->second);
  expect_none(none);
}

}  // namespace
}  // namespace ajar::gltf
