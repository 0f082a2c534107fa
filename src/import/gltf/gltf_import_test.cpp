#include "import/gltf/gltf_import.h"

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

TEST(GltfImport, CompressedMeshesHaveARemedyInTheirWarning) {
  TestFile file;
  file.add_triangle();
  file.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  EXPECT_EQ(error_of(file.text()), "no error") << "the meshes are there without it";
  file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  EXPECT_EQ(error_of(file.text()),
            "test.gltf#/extensionsRequired/0: the meshes of this file are compressed by "
            "KHR_draco_mesh_compression, which cannot be read: export it without compression of "
            "meshes");
}

TEST(GltfImport, UnknownExtensionsAreErrorsOnlyIfRequired) {
  TestFile file;
  file.add_triangle();
  file.json["extensionsUsed"] = {"KHR_materials_iridescence", "ABC_new"};
  const std::string warnings = warnings_of(file);
  EXPECT_TRUE(
      contains(warnings, "#/extensionsUsed/0: KHR_materials_iridescence is not read: thin"));
  EXPECT_TRUE(contains(warnings, "#/extensionsUsed/1: the extension ABC_new is not known"));
  file.json["extensionsRequired"] = {"KHR_materials_spekular"};
  EXPECT_TRUE(contains(error_of(file.text()), "did you mean \"KHR_materials_specular\""));
}

/// Claims of docs/reference/formats-gltf.md on extensions.
TEST(GltfImport, UnreadExtensionsWarnOfTheirEffect) {
  for (const auto& [name, says] :
       {std::pair("KHR_materials_anisotropy", "gloss is the same in all directions"),
        std::pair("KHR_materials_dispersion", "glass has one index of refraction for all colours"),
        std::pair("KHR_materials_iridescence", "thin films have no colours"),
        std::pair("KHR_texture_basisu", "textures that have no other image are left out")}) {
    TestFile file;
    file.add_triangle();
    file.json["extensionsUsed"] = {name};
    file.json["extensionsRequired"] = {name};
    EXPECT_EQ(warnings_of(file),
              std::string("test.gltf#/extensionsUsed/0: ") + name + " is not read: " + says + "\n");
  }
  for (const char* name :
       {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    TestFile file;
    file.add_triangle();
    file.json["extensionsUsed"] = {name};
    EXPECT_EQ(warnings_of(file), "") << name;
    file.json["extensionsRequired"] = {name};
    EXPECT_TRUE(contains(error_of(file.text()), std::string("compressed by ") + name)) << name;
  }
}

TEST(GltfImport, OtherScenesAreWarnings) {
  TestFile file;
  file.add_triangle();
  file.add("scenes", {{"nodes", Json::array({0})}});
  EXPECT_EQ(warnings_of(file), "");
  file.add("scenes", {{"nodes", Json::array()}});
  EXPECT_EQ(warnings_of(file),
            "test.gltf#/scenes: of these 2 scenes only number 0, counted from 0, is shown\n");
}

TEST(GltfImport, AnimationsAndVariantsAreWarnings) {
  TestFile file;
  file.add_triangle();
  file.add("animations", Json::object());
  file.json["extensions"]["KHR_materials_variants"] = Json::object();
  const std::string warnings = warnings_of(file);
  EXPECT_TRUE(contains(warnings, "test.gltf#/animations: animations are not played"));
  EXPECT_TRUE(contains(warnings, "only the default is shown"));
}

TEST(GltfImport, BuffersOutsideOfTheFolderOrMissingAreErrors) {
  TestFile file;
  file.add_triangle();
  for (const char* uri : {"../a.bin", "/dev/zero", "http://a/b", "missing.bin"}) {
    Json json = Json::parse(file.text());
    json["buffers"][0]["uri"] = uri;
    EXPECT_TRUE(contains(error_of(json.dump()), "#/buffers/0/uri: cannot read this buffer: "))
        << uri;
  }
}

TEST(GltfImport, BuffersMayBeFilesAndMustBeLongEnough) {
  TestFile file;
  file.add_triangle();
  Json json = Json::parse(file.text());
  json["buffers"][0]["uri"] = "a.bin";
  const std::string bytes = bytes_of<float>(std::vector<float>(15, 1.F));
  Warnings warnings;
  EXPECT_NO_THROW(import_with(json.dump(), warnings, {{"/scene/a.bin", bytes}}));
  EXPECT_THROW(import_with(json.dump(), warnings, {{"/scene/a.bin", bytes.substr(1)}}), SceneError);
}

TEST(GltfImport, ModelsWithoutCameraAndLightsAreInAStudio) {
  TestFile file;
  file.add_triangle();
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_EQ(scene.lights.size(), 1U) << "the sky";
  EXPECT_EQ(scene.shapes.size(), 4U) << "with two softboxes and the table";
}

/// With a camera.
desc::SceneDesc seen(const Json& material, Warnings& warnings, bool has_dark_light = false) {
  TestFile file;
  file.add_triangle(material);
  file.add("images", {{"uri", "a.png"}});
  file.add("textures", {{"source", 0}});
  file.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
  file.add("nodes", {{"camera", 0}});
  if (has_dark_light) {
    file.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "point"}, {"intensity", 0}}});
    file.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  }
  return import_with(file.text(), warnings, {{"a.png", ""}});
}

TEST(GltfImport, ImagesOfLightAreNoLampsWhereThereIsNone) {
  const Json texture = {{"index", 0}};
  const auto has_studio = [&](const Json& material, bool has_dark_light = false) {
    Warnings warnings;
    const bool result = !seen(material, warnings, has_dark_light).lights.empty();
    const bool is_told = contains(lines_of(warnings), "the light of a studio is added");
    EXPECT_EQ(is_told, result && material.contains("emissiveTexture")) << material;
    return result;
  };
  const Json ones = Json::array({1, 1, 1});
  const auto with_strength = [&](double strength) {
    return Json{
        {"emissiveFactor", ones},
        {"emissiveTexture", texture},
        {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", strength}}}}}};
  };
  EXPECT_TRUE(has_studio({{"emissiveFactor", ones}, {"emissiveTexture", texture}}));
  EXPECT_FALSE(has_studio({{"emissiveFactor", ones}}));
  EXPECT_FALSE(has_studio(with_strength(20.0))) << "brighter than an image can be";
  EXPECT_TRUE(has_studio(Json::object())) << "only a camera";
  EXPECT_TRUE(has_studio(Json::object(), true)) << "a light of no intensity";
  EXPECT_TRUE(has_studio({{"emissiveFactor", Json::array({0, 0, 0})}}));
  EXPECT_TRUE(has_studio(
      {{"emissiveFactor", ones},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 0.0}}}}}}));
  EXPECT_FALSE(has_studio({{"pbrMetallicRoughness", {{"baseColorTexture", texture}}},
                           {"extensions", {{"KHR_materials_unlit", Json::object()}}}}));
}

TEST(GltfImport, PrimitivesWithoutMaterialHaveThatOfTheSpecification) {
  TestFile file;
  file.add_triangle();
  file.json["meshes"][0]["primitives"][0].erase("material");
  const desc::SceneDesc scene = scene_of(file);
  const desc::Node& node =
      scene.materials.at(static_cast<std::size_t>(scene.shapes.front().material)).node;
  EXPECT_TRUE(node.is("principled"));
  EXPECT_EQ(node.color("base_color"), Vec3(1.F));
  EXPECT_EQ(node.number("metallic"), 1.F);
  EXPECT_EQ(node.number("roughness"), 1.F);
}

}  // namespace
}  // namespace ajar::gltf
