#include "import/gltf/members.h"

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

TEST(GltfMembers, WithoutMeaningAreWarnings) {
  const auto expect_warning = [](const std::string& place, const Json& member,
                                 const std::string& text) {
    TestFile file;
    file.add_triangle();
    file.json[Json::json_pointer(place)].update(member);
    const std::string warnings = warnings_of(file);
    EXPECT_TRUE(
        contains(warnings, "test.gltf" + (place.empty() ? ": " : "#" + place + ": ") + text))
        << warnings;
  };
  expect_warning("", {{"sceens", Json::array()}},
                 "a file has no member \"sceens\"; did you mean \"scenes\"?: ignored");
  expect_warning("/asset", {{"auther", "x"}}, "an asset has no member \"auther\"");
  expect_warning("/materials/0", {{"alphaCutof", 0.5}},
                 "a material has no member \"alphaCutof\"; did you mean \"alphaCutoff\"");
  expect_warning("/meshes/0/primitives/0/attributes", {{"TANGENTS", 0}},
                 "attributes has no member \"TANGENTS\"; did you mean \"TANGENT\"");
  expect_warning("/nodes/0", {{"translate", Json::array({1, 2, 3})}},
                 "a node has no member \"translate\"");
  expect_warning("/accessors/0", {{"stride", 4}}, "an accessor has no member \"stride\"");
}

TEST(GltfMembers, OfExtensionsAreKnown) {
  TestFile file;
  file.add_triangle({{"extensions",
                      {{"KHR_materials_ior", {{"ior", 1.4}, {"index", 1.4}}},
                       {"KHR_materials_iridescence", Json::object()},
                       {"XYZ_glow", Json::object()}}}});
  file.add_triangle({{"extensions", {{"XYZ_glow", Json::object()}}}});
  const std::string warnings = warnings_of(file);
  EXPECT_TRUE(contains(warnings,
                       "test.gltf#/materials/0/extensions/KHR_materials_ior: KHR_materials_ior has "
                       "no member \"index\""))
      << warnings;
  EXPECT_TRUE(contains(warnings, "KHR_materials_iridescence is not read")) << warnings;
  EXPECT_TRUE(contains(
      warnings, "test.gltf#/materials/0/extensions/XYZ_glow: the extension XYZ_glow is not known"))
      << warnings;
  EXPECT_FALSE(contains(warnings, "/materials/1/")) << "told once: " << warnings;
}

TEST(GltfMembers, OfTexturesAreThoseOfTheirUse) {
  for (const auto& [place, member, is_known] : {std::tuple("emissiveTexture", "scale", false),
                                                {"emissiveTexture", "strength", false},
                                                {"normalTexture", "strength", false},
                                                {"normalTexture", "scale", true},
                                                {"occlusionTexture", "strength", true},
                                                {"occlusionTexture", "scale", false}}) {
    TestFile file;
    file.add_triangle({{place, {{"index", 0}, {member, 0.5}}}});
    file.add("images", {{"uri", "a.png"}});
    file.add("textures", {{"source", 0}});
    EXPECT_EQ(contains(warnings_of(file), std::string("has no member \"") + member), !is_known)
        << place << " " << member;
  }
}

TEST(GltfMembers, OfExtensionsHaveTheirPlace) {
  const Json transform = {{"KHR_texture_transform", {{"scale", {2, 2}}}}};
  const auto warnings_with = [&](const char* place, const Json& extensions) {
    TestFile file;
    file.add_triangle({{"emissiveTexture", {{"index", 0}}}, {"emissiveFactor", {1, 1, 1}}});
    file.add("images", {{"uri", "a.png"}});
    file.add("textures", {{"source", 0}});
    file.json[Json::json_pointer(place)]["extensions"] = extensions;
    return warnings_of(file);
  };
  EXPECT_TRUE(contains(warnings_with("/textures/0", transform),
                       "test.gltf#/textures/0/extensions/KHR_texture_transform: "
                       "KHR_texture_transform means nothing on a texture: ignored"));
  EXPECT_EQ(warnings_with("/materials/0/emissiveTexture", transform), "");
  EXPECT_TRUE(contains(warnings_with("/nodes/0", {{"KHR_materials_unlit", Json::object()}}),
                       "KHR_materials_unlit means nothing on a node"));
  EXPECT_TRUE(contains(warnings_with("/materials/0", {{"KHR_lights_punctual", {{"light", 0}}}}),
                       "KHR_lights_punctual means nothing on a material"));
  EXPECT_TRUE(contains(warnings_with("/meshes/0", {{"KHR_node_visibility", {{"visible", false}}}}),
                       "KHR_node_visibility means nothing on a mesh"));
}

TEST(GltfMembers, OfUnknownExtensionsAreClassifiedByName) {
  for (const auto& [name, effect] : {std::pair("EXT_lights_image_based", Effect::Light),
                                     std::pair("KHR_materials_volume_scatter", Effect::Surface),
                                     std::pair("MSFT_lod", Effect::Slight)}) {
    TestFile file;
    file.add_triangle();
    file.json["extensionsUsed"] = {name};
    Warnings warnings;
    import_with(file.text(), warnings);
    EXPECT_EQ(warnings.count(effect), 1U) << name;
  }
}

TEST(GltfMembers, OfApplicationsAreIgnored) {
  TestFile file;
  Json triangle = file.triangle();
  triangle["attributes"]["_ID"] = 0;
  triangle["attributes"]["TEXCOORD_1"] = 1;
  triangle["extras"] = {{"anything", 1}};
  triangle["material"] = file.add("materials", Json::object());
  file.add("meshes", {{"primitives", Json::array({triangle})}});
  file.add("nodes", {{"mesh", 0}});
  scene_of(file);
}

}  // namespace
}  // namespace ajar::gltf
