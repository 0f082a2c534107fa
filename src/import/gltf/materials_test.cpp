#include "import/gltf/materials.h"

#include <cmath>

#include "import/gltf/gltf_test_support.h"

namespace ajar::gltf {
namespace {

/// A file with images 0 (a file), 1 (in the buffer) and 2 (in its URI), textures of them, and a
/// triangle.
TestFile textured(const Json& material) {
  TestFile file;
  file.add_triangle(material);
  const std::size_t view = file.add_view("the bytes of an image");
  file.add("images", {{"uri", "wood%20oak.png"}});
  file.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  file.add("images", {{"uri", "data:image/jpeg;base64,TWFu"}});
  for (int i = 0; i < 3; ++i) file.add("textures", {{"source", i}});
  return file;
}
Json texture(int index) { return {{"index", index}}; }

const desc::Shape& shape_of(const desc::SceneDesc& scene) { return scene.shapes.front(); }
const desc::Material& material_of(const desc::SceneDesc& scene) {
  return scene.materials.at(static_cast<std::size_t>(shape_of(scene).material));
}
const desc::Node& node_of(const desc::SceneDesc& scene) { return material_of(scene).node; }
const desc::Node& material_at(const desc::SceneDesc& scene, desc::MaterialId id) {
  return scene.materials.at(static_cast<std::size_t>(id)).node;
}
const desc::Node& texture_at(const desc::SceneDesc& scene, desc::TextureId id) {
  return scene.textures.at(static_cast<std::size_t>(id)).node;
}

TEST(GltfMaterials, DefaultsAreThoseOfTheSpecification) {
  const desc::Node node = only_material(Json::object());
  EXPECT_TRUE(node.is("principled"));
  EXPECT_EQ(node.color("base_color"), Vec3(1.F));
  EXPECT_EQ(node.number("metallic"), 1.F);
  EXPECT_EQ(node.number("roughness"), 1.F);
  EXPECT_EQ(node.number("eta"), 1.5F);
}

TEST(GltfMaterials, FactorsOfMetallicRoughnessAreThoseOfPrincipled) {
  const desc::Node node = only_material({{"name", "brass"},
                                         {"pbrMetallicRoughness",
                                          {{"baseColorFactor", {0.8, 0.6, 0.2, 1}},
                                           {"metallicFactor", 0.75},
                                           {"roughnessFactor", 0.3}}},
                                         {"extensions", {{"KHR_materials_ior", {{"ior", 1.8}}}}}});
  EXPECT_EQ(node.color("base_color"), Vec3(0.8F, 0.6F, 0.2F));
  EXPECT_EQ(node.number("metallic"), 0.75F);
  EXPECT_EQ(node.number("roughness"), 0.3F);
  EXPECT_NEAR(node.number("eta"), 1.8F, 1e-6F);
}

TEST(GltfMaterials, ColoursAreCodedAndNumbersAreLinear) {
  const desc::SceneDesc scene = scene_of(textured({{"pbrMetallicRoughness",
                                                    {{"baseColorTexture", texture(0)},
                                                     {"baseColorFactor", {1, 0.5, 1, 1}},
                                                     {"metallicRoughnessTexture", texture(1)},
                                                     {"roughnessFactor", 0.5}}}}));
  const desc::Node& base = texture_at(scene, node_of(scene).texture("base_color"));
  ASSERT_TRUE(base.is("product"));
  EXPECT_EQ(base.color("first"), Vec3(1.F, 0.5F, 1.F));
  const desc::Node& wood = texture_at(scene, base.texture("second"));
  EXPECT_EQ(wood.text("file"), "/scene/wood oak.png");
  EXPECT_EQ(wood.text("channel"), "color");
  EXPECT_TRUE(wood.flag("decode_srgb"));
  EXPECT_TRUE(scene.files.contains("/scene/wood oak.png"));

  const desc::Node& roughness = texture_at(scene, node_of(scene).texture("roughness"));
  EXPECT_EQ(roughness.text("channel"), "green");
  EXPECT_FALSE(roughness.flag("decode_srgb"));
  EXPECT_EQ(roughness.number("scale"), 0.5F);
  const desc::Node& metallic = texture_at(scene, node_of(scene).texture("metallic"));
  EXPECT_EQ(metallic.text("channel"), "blue");
  EXPECT_EQ(metallic.number("scale"), 1.F);
}

TEST(GltfMaterials, ImagesInsideTheFileAreEmbedded) {
  const desc::SceneDesc scene =
      scene_of(textured({{"pbrMetallicRoughness", {{"baseColorTexture", texture(1)}}},
                         {"emissiveFactor", {1, 1, 1}},
                         {"emissiveTexture", texture(2)}}));
  const desc::Node& base = texture_at(scene, node_of(scene).texture("base_color"));
  EXPECT_EQ(base.text("file"), "/scene/test.gltf/images/1.png");
  EXPECT_EQ(*scene.embedded_files.at(base.text("file")), "the bytes of an image");
  const desc::Node& emission =
      texture_at(scene, shape_of(scene).emission->node.texture("radiance"));
  EXPECT_EQ(emission.text("file"), "/scene/test.gltf/images/2.jpg");
  EXPECT_EQ(*scene.embedded_files.at(emission.text("file")), "Man");
}

TEST(GltfMaterials, ImagesElsewhereAreLeftOutWithAWarning) {
  for (const char* uri : {"../secret.png", "/etc/passwd", "https://example.org/a.png",
                          "file:///etc/passwd", "a/%2e%2e/../../b.png"}) {
    TestFile file = textured({{"pbrMetallicRoughness", {{"baseColorTexture", texture(0)}}}});
    file.json["images"][0]["uri"] = uri;
    EXPECT_TRUE(contains(warnings_of(file), "#/images/0/uri: this image is left out: ")) << uri;
  }
}

TEST(GltfMaterials, TextureTransformsFollowTheFlippedV) {
  // glTF: u' = 0.1 + 2 c u + 3 s v, v' = 0.2 − 2 s u + 3 c v, with v = 0 at the top.
  const double angle = 0.4;
  Json info = texture(0);
  info["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.1, 0.2}}, {"scale", {2, 3}}, {"rotation", angle}};
  const desc::SceneDesc scene =
      scene_of(textured({{"pbrMetallicRoughness", {{"baseColorTexture", info}}}}));
  const desc::Node& image = texture_at(scene, node_of(scene).texture("base_color"));
  const double u = 0.3;
  const double v = 0.7;
  const double expected_u = 0.1 + 2 * std::cos(angle) * u + 3 * std::sin(angle) * v;
  const double expected_v = 0.2 - 2 * std::sin(angle) * u + 3 * std::cos(angle) * v;
  // The map of an `image` is (u, 1 − v).
  const double turned = double{image.number("rotation")} * M_PI / 180;
  const double x = double{image.number("scale_u")} * u;
  const double y = double{image.number("scale_v")} * (1 - v);
  EXPECT_NEAR(std::cos(turned) * x - std::sin(turned) * y + double{image.number("offset_u")},
              expected_u, 1e-6);
  EXPECT_NEAR(std::sin(turned) * x + std::cos(turned) * y + double{image.number("offset_v")},
              1 - expected_v, 1e-6);
}

TEST(GltfMaterials, SamplersSetWrapAndFilter) {
  TestFile file = textured({{"pbrMetallicRoughness", {{"baseColorTexture", texture(0)}}}});
  file.add("samplers", {{"wrapS", 33071}, {"wrapT", 33071}, {"magFilter", 9728}});
  file.json["textures"][0]["sampler"] = 0;
  const desc::SceneDesc scene = scene_of(file);
  const desc::Node& image = texture_at(scene, node_of(scene).texture("base_color"));
  EXPECT_EQ(image.text("wrap"), "clamp");
  EXPECT_EQ(image.text("filter"), "nearest");
  file.json["samplers"][0] = {{"wrapS", 33648}};
  EXPECT_TRUE(contains(warnings_of(file), "#/samplers/0: mirrored repetition"));
}

TEST(GltfMaterials, MeshesHaveTheCoordinatesOfTheFirstTexture) {
  Json second = texture(0);
  second["texCoord"] = 1;
  TestFile file = textured({{"pbrMetallicRoughness", {{"baseColorTexture", second}}}});
  const std::size_t uvs =
      file.add_accessor(bytes_of<float>({0.F, 0.25F, 0.F, 0.F, 0.F, 0.F}), 5126, "VEC2", 3);
  file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = uvs;
  EXPECT_EQ(shape_of(scene_of(file)).node.mesh("mesh")->uvs[0], Vec2(0.F, 0.75F));
  file.json["materials"][0]["emissiveFactor"] = {1, 1, 1};
  file.json["materials"][0]["emissiveTexture"] = texture(1);
  EXPECT_TRUE(contains(warnings_of(file),
                       "#/materials/0/emissiveTexture: this texture uses TEXCOORD_0, others of "
                       "its material TEXCOORD_1: left out"));
}

TEST(GltfMaterials, SpecularGlossinessIsACoatedBase) {
  const desc::SceneDesc scene = scene_of(textured({{"extensions",
                                                    {{"KHR_materials_pbrSpecularGlossiness",
                                                      {{"diffuseFactor", {0.1, 0.2, 0.3, 1}},
                                                       {"specularFactor", {0.4, 0.5, 0.6}},
                                                       {"glossinessFactor", 0.75}}}}}}));
  const desc::Node& node = node_of(scene);
  ASSERT_TRUE(node.is("coated_diffuse"));
  EXPECT_EQ(node.color("diffuse_reflectance"), Vec3(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(node.color("glossy_reflectance"), Vec3(0.4F, 0.5F, 0.6F));
  EXPECT_NEAR(node.number("roughness"), 0.0625F, 1e-6F) << "alpha = (1 - glossiness)^2";
  const desc::SceneDesc matte = scene_of(
      textured({{"extensions",
                 {{"KHR_materials_pbrSpecularGlossiness",
                   {{"diffuseFactor", {0.1, 0.2, 0.3, 1}}, {"specularFactor", {0, 0, 0}}}}}}}));
  EXPECT_TRUE(node_of(matte).is("diffuse"));
  EXPECT_EQ(node_of(matte).color("reflectance"), Vec3(0.1F, 0.2F, 0.3F));
}

Json glass(double transmission, const Json& volume = nullptr) {
  Json material = {
      {"pbrMetallicRoughness",
       {{"metallicFactor", 0}, {"roughnessFactor", 0.5}, {"baseColorFactor", {0.9, 1, 1, 1}}}}};
  material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = transmission;
  if (!volume.is_null()) material["extensions"]["KHR_materials_volume"] = volume;
  return material;
}

TEST(GltfMaterials, TransmissionIsThinWithoutAVolume) {
  const desc::Node node = only_material(glass(1.0));
  ASSERT_TRUE(node.is("dielectric"));
  EXPECT_TRUE(node.flag("thin"));
  EXPECT_EQ(node.color("transmittance"), Vec3(0.9F, 1.F, 1.F));
  EXPECT_EQ(node.number("roughness"), 0.25F) << "alpha";
  EXPECT_EQ(node.text("roughness_scale"), "alpha");
}

TEST(GltfMaterials, SolidGlassAbsorbsWithDistance) {
  TestFile file;
  file.add_triangle(glass(
      1.0,
      {{"thicknessFactor", 1}, {"attenuationDistance", 2}, {"attenuationColor", {1, 0.5, 0.25}}}));
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_FALSE(node_of(scene).flag("thin"));
  ASSERT_TRUE(shape_of(scene).has_medium_interface);
  const desc::Medium& medium = scene.media.at(static_cast<std::size_t>(shape_of(scene).inside));
  EXPECT_EQ(medium.sigma_a.x, 0.F);
  EXPECT_NEAR(std::exp(-2.F * medium.sigma_a.y), 0.5F, 1e-6F);
  EXPECT_NEAR(std::exp(-2.F * medium.sigma_a.z), 0.25F, 1e-6F);
  EXPECT_EQ(medium.sigma_s, Vec3(0.F));
}

TEST(GltfMaterials, SheenIsAsStrongAsItsBrightestLane) {
  TestFile file;
  Json material;
  material["extensions"]["KHR_materials_sheen"]["sheenColorFactor"] = {0.25, 0.5, 0.125};
  file.add_triangle(material);
  Warnings warnings;
  const desc::SceneDesc scene = import_with(file.text(), warnings);
  const desc::Node& node =
      scene.materials[static_cast<std::size_t>(scene.shapes.front().material)].node;
  EXPECT_EQ(node.number("sheen"), 0.5F);
  EXPECT_EQ(node.number("sheen_tint"), 1.F);
  EXPECT_TRUE(contains(lines_of(warnings), "a sheen stands in that has the hue of the base"));
}

TEST(GltfMaterials, PartialTransmissionIsAMixWithoutTheMetal) {
  Json material = glass(0.5);
  material["pbrMetallicRoughness"]["metallicFactor"] = 0.25;
  TestFile file;
  file.add_triangle(material);
  const desc::SceneDesc scene = scene_of(file);
  ASSERT_TRUE(node_of(scene).is("mix"));
  EXPECT_EQ(node_of(scene).color("amount"), Vec3(0.375F));
  EXPECT_TRUE(material_at(scene, node_of(scene).material("first")).is("dielectric"));
  EXPECT_TRUE(material_at(scene, node_of(scene).material("second")).is("principled"));
}

TEST(GltfMaterials, MaskCutsWhereAlphaIsBelowTheCutoff) {
  const desc::SceneDesc scene = scene_of(
      textured({{"alphaMode", "MASK"},
                {"alphaCutoff", 0.25},
                {"pbrMetallicRoughness",
                 {{"baseColorTexture", texture(0)}, {"baseColorFactor", {1, 1, 1, 0.5}}}}}));
  const desc::Node& cut = texture_at(scene, shape_of(scene).alpha);
  ASSERT_TRUE(cut.is("threshold"));
  EXPECT_EQ(cut.number("edge"), 0.25F);
  const desc::Node& alpha = texture_at(scene, cut.texture("value"));
  EXPECT_EQ(alpha.text("channel"), "alpha");
  EXPECT_EQ(alpha.number("scale"), 0.5F);
  EXPECT_FALSE(alpha.flag("decode_srgb"));
}

TEST(GltfMaterials, BlendMixesWithATransparentMaterial) {
  TestFile file;
  file.add_triangle(
      {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}}}});
  const desc::SceneDesc scene = scene_of(file);
  ASSERT_TRUE(node_of(scene).is("mix"));
  EXPECT_EQ(node_of(scene).color("amount"), Vec3(0.25F));
  const desc::Node& clear = material_at(scene, node_of(scene).material("second"));
  EXPECT_TRUE(clear.is("composite"));
  EXPECT_EQ(clear.color("opacity"), Vec3(0.F));
}

TEST(GltfMaterials, OpaqueIgnoresAlpha) {
  TestFile file;
  file.add_triangle({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}}}});
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_TRUE(node_of(scene).is("principled"));
  EXPECT_EQ(shape_of(scene).alpha, desc::kNone);
  file.json["materials"][0]["alphaMode"] = "BLENDED";
  EXPECT_TRUE(contains(error_of(file.text()), "#/materials/0/alphaMode: unknown alphaMode"));
  EXPECT_TRUE(contains(error_of(file.text()), "did you mean \"BLEND\""));
}

TEST(GltfMaterials, EmissionIsRadianceOfTheSameNumber) {
  TestFile file;
  file.add_triangle(
      {{"emissiveFactor", {1, 0.5, 0}},
       {"doubleSided", true},
       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 6}}}}}});
  const desc::SceneDesc scene = scene_of(file);
  const desc::Node& emission = shape_of(scene).emission->node;
  EXPECT_EQ(emission.color("scale"), Vec3(6.F, 3.F, 0.F));
  EXPECT_EQ(emission.color("radiance"), Vec3(1.F));
  EXPECT_TRUE(emission.flag("two_sided"));
}

TEST(GltfMaterials, UnlitOnesEmitWithAWarning) {
  TestFile file;
  file.add_triangle({{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 1}}}},
                     {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
  EXPECT_TRUE(contains(warnings_of(file), "#/materials/0: this material is unlit"));
  Warnings warnings;
  const desc::SceneDesc scene = import_with(file.text(), warnings);
  EXPECT_EQ(shape_of(scene).emission->node.color("radiance"), Vec3(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(node_of(scene).color("reflectance"), Vec3(0.F));
}

TEST(GltfMaterials, SpecularFactorIsAFactorAndItsColourAnIndex) {
  const auto with = [](const Json& specular) {
    return only_material({{"extensions", {{"KHR_materials_specular", specular}}}});
  };
  const desc::Node half = with({{"specularFactor", 0.5}});
  EXPECT_EQ(half.number("specular_strength"), 0.5F);
  EXPECT_NEAR(half.number("eta"), 1.5F, 1e-6F);
  const float eta = with({{"specularColorFactor", {0.5, 0.5, 0.5}}}).number("eta");
  EXPECT_NEAR(std::pow((eta - 1.F) / (eta + 1.F), 2.F), 0.02F, 1e-6F);
  EXPECT_EQ(only_material(Json::object()).number("specular_strength"), 1.F);
  const desc::SceneDesc scene = scene_of(
      textured({{"extensions", {{"KHR_materials_specular", {{"specularTexture", texture(0)}}}}}}));
  const desc::Node& image = texture_at(scene, node_of(scene).texture("specular_strength"));
  EXPECT_EQ(image.text("channel"), "alpha");
}

TEST(GltfMaterials, SpecularFactorWeakensTheReflectionOfGlass) {
  Json material = glass(1.0);
  material["extensions"]["KHR_materials_specular"]["specularFactor"] = 0.25;
  TestFile file;
  file.add_triangle(material);
  EXPECT_TRUE(contains(warnings_of(file), "#/materials/0: the factor of its gloss weakens"));
  Warnings warnings;
  const desc::SceneDesc scene = import_with(file.text(), warnings);
  EXPECT_EQ(node_of(scene).color("reflectance"), Vec3(0.25F));
}

TEST(GltfMaterials, BlendsWeightTheEmission) {
  const auto emission = [](const Json& pbr) {
    TestFile file = textured({{"alphaMode", "BLEND"},
                              {"emissiveFactor", {1, 0.5, 0.25}},
                              {"pbrMetallicRoughness", pbr}});
    const desc::SceneDesc scene = scene_of(file);
    return std::pair(shape_of(scene).emission->node, scene);
  };
  const auto [constant, first] = emission({{"baseColorFactor", {1, 1, 1, 0.5}}});
  EXPECT_EQ(constant.color("scale"), Vec3(0.5F, 0.25F, 0.125F));
  const auto [varied, scene] = emission({{"baseColorTexture", texture(0)}});
  const desc::Node& alpha =
      scene.textures.at(static_cast<std::size_t>(varied.texture("radiance"))).node;
  EXPECT_EQ(alpha.text("channel"), "alpha");
}

TEST(GltfMaterials, ClearcoatsOfGlassAreLeftOutWithAWarning) {
  Json material = glass(0.5);
  material["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 1}};
  TestFile file;
  file.add_triangle(material);
  EXPECT_TRUE(contains(warnings_of(file), "a clear coat is only supported on metals"));
  file.json["materials"][0]["extensions"]["KHR_materials_sheen"] = {
      {"sheenColorFactor", {1, 1, 1}}};
  EXPECT_TRUE(contains(warnings_of(file), "a sheen is only supported on metals"));
}

/// All that can be added to a material.
Json all_layers() {
  return {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}},
          {"KHR_materials_sheen", {{"sheenColorFactor", {0, 0.5, 0}}}},
          {"KHR_materials_transmission", {{"transmissionFactor", 1}}},
          {"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 0.5}}}};
}

TEST(GltfMaterials, LayersOfOldAndUnlitMaterialsAreLeftOutWithAWarning) {
  for (const char* model : {"KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"}) {
    Json material = {{"extensions", all_layers()}};
    material["extensions"][model] = Json::object();
    TestFile file;
    file.add_triangle(material);
    const std::string warnings = warnings_of(file);
    const Json layers = all_layers();
    for (const auto& layer : layers.items()) {
      EXPECT_TRUE(contains(warnings, "#/materials/0/extensions/" + layer.key() + ": "))
          << model << "\n"
          << warnings;
    }
    for (auto& layer : file.json["materials"][0]["extensions"]) {
      for (auto& member : layer) member = member.is_array() ? Json({0, 0, 0}) : Json(0);
    }
    EXPECT_FALSE(contains(warnings_of(file), "left out")) << "what is 0 adds nothing";
  }
}

TEST(GltfMaterials, VolumesOfOpaqueMaterialsAreLeftOutWithAWarning) {
  const auto warnings_with = [](const Json& more) {
    Json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"extensions", more}};
    material["extensions"]["KHR_materials_volume"] = {
        {"thicknessFactor", 1}, {"attenuationDistance", 1}, {"attenuationColor", {0.5, 1, 1}}};
    TestFile file;
    file.add_triangle(material);
    return warnings_of(file);
  };
  EXPECT_TRUE(contains(
      warnings_with({{"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 0.5}}}}),
      "KHR_materials_volume: a volume is only supported behind KHR_materials_transmission"));
  EXPECT_TRUE(contains(warnings_with(Json::object()), "a volume of what lets no light in"));
  EXPECT_TRUE(contains(warnings_with({{"KHR_materials_transmission", {{"transmissionFactor", 0}}}}),
                       "a volume of what lets no light in"));
  EXPECT_EQ(warnings_with({{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}), "");
}

TEST(GltfMaterials, ImagesMayBeWebPButNotKtx) {
  TestFile file = textured({{"pbrMetallicRoughness", {{"baseColorTexture", texture(3)}}}});
  file.add("images", {{"uri", "a.webp"}});
  file.add("images", {{"uri", "a.ktx2"}});
  file.add("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 3}}}}}});
  const desc::SceneDesc scene = scene_of(file);
  EXPECT_EQ(texture_at(scene, node_of(scene).texture("base_color")).text("file"), "/scene/a.webp");
  Json& used = file.json["textures"][3];
  used = {{"extensions", {{"KHR_texture_basisu", {{"source", 4}}}}}};
  const std::string warnings = warnings_of(file);
  EXPECT_TRUE(contains(warnings, "KHR_texture_basisu is not read")) << warnings;
  EXPECT_TRUE(contains(warnings, "#/textures/3: this texture has no image that can be read"));
  used["source"] = 0;
  EXPECT_FALSE(contains(warnings_of(file), "no image that can be read"))
      << "the other image stands in";
}

TEST(GltfMaterials, ClearcoatIsACoat) {
  Json material;
  material["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 0.75},
                                                       {"clearcoatRoughnessFactor", 0.25}};
  const desc::Node node = node_of(scene_of(textured(material)));
  EXPECT_EQ(node.number("coat"), 0.75F);
  EXPECT_EQ(node.number("coat_roughness"), 0.25F);
  EXPECT_EQ(node.number("clearcoat"), 0.F);
  material["extensions"]["KHR_materials_clearcoat"]["clearcoatRoughnessTexture"] = texture(0);
  const desc::SceneDesc scene = scene_of(textured(material));
  const desc::Node& rough =
      scene.textures.at(static_cast<std::size_t>(node_of(scene).texture("coat_roughness"))).node;
  EXPECT_EQ(rough.text("channel"), "green");
  EXPECT_EQ(rough.number("scale"), 0.25F);
}

TEST(GltfMaterials, FactorsBeyondTheirRangeAreClampedWithAWarning) {
  TestFile file;
  file.add_triangle({{"pbrMetallicRoughness", {{"roughnessFactor", 1.5}}}});
  EXPECT_TRUE(contains(warnings_of(file),
                       "#/materials/0/pbrMetallicRoughness/roughnessFactor: this must be from 0 "
                       "to 1"));
  file.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = "rough";
  EXPECT_TRUE(contains(error_of(file.text()), ": must be a number, not \"rough\""));
}

TEST(GltfMaterials, NormalMapsAreVectorsForAllPartsOfAMaterial) {
  Json map = texture(1);
  map["scale"] = 0.5;
  const desc::SceneDesc scene = scene_of(
      textured({{"normalTexture", map},
                {"pbrMetallicRoughness", {{"metallicFactor", 0}}},
                {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}}));
  int tilted = 0;
  for (const desc::Material& material : scene.materials) {
    if (material.node.is("mix")) continue;
    const desc::NormalMap& normals = material.normal_map;
    if (normals.texture == desc::kNone) continue;
    ++tilted;
    EXPECT_EQ(normals.strength, 0.5F);
    EXPECT_FALSE(normals.right_handed);
    EXPECT_FALSE(texture_at(scene, normals.texture).flag("decode_srgb"));
    EXPECT_EQ(texture_at(scene, normals.texture).text("channel"), "color");
  }
  EXPECT_EQ(tilted, 2) << "the opaque part and the glass";
  EXPECT_TRUE(contains(
      warnings_of(
          textured({{"extensions",
                     {{"KHR_materials_clearcoat", {{"clearcoatNormalTexture", texture(0)}}}}}})),
      "the coat has the normals of what it is on"));
}

TEST(GltfMaterials, ReferencesThatLeadNowhereAreErrors) {
  EXPECT_TRUE(contains(
      error_of(textured({{"pbrMetallicRoughness", {{"baseColorTexture", texture(9)}}}}).text()),
      "/baseColorTexture/index: refers to number 9, but there are 3, counted from 0"));
}

TEST(GltfMaterials, TexturesWithoutTheirFactorAreWarnings) {
  const Json texture = {{"index", 0}};
  const std::vector<std::tuple<const char*, const char*, const char*>> cases = {
      {"", "emissiveFactor", "emissiveTexture"},
      {"KHR_materials_transmission", "transmissionFactor", "transmissionTexture"},
      {"KHR_materials_clearcoat", "clearcoatFactor", "clearcoatTexture"},
      {"KHR_materials_sheen", "sheenColorFactor", "sheenColorTexture"},
      {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor",
       "diffuseTransmissionTexture"}};
  for (const auto& [extension, factor, member] : cases) {
    const bool is_core = std::string_view(extension).empty();
    const auto told = [&](const Json& members) {
      TestFile file;
      file.add("images", {{"uri", "data:image/png;base64,AAAA"}});
      file.add("textures", {{"source", 0}});
      file.add_triangle(is_core ? members : Json{{"extensions", {{extension, members}}}});
      file.json["extensionsUsed"] = {"KHR_materials_clearcoat"};
      return contains(warnings_of(file), std::string("\"") + member + "\" is multiplied by \"" +
                                             factor + "\", which is 0 where it is not given");
    };
    EXPECT_TRUE(told({{member, texture}})) << member;
    const Json zero =
        is_core || factor == std::string_view("sheenColorFactor") ? Json{0, 0, 0} : Json(0);
    EXPECT_FALSE(told({{member, texture}, {factor, zero}})) << member << ": as the file says";
  }
}

}  // namespace
}  // namespace ajar::gltf
