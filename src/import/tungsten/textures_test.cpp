#include "import/tungsten/textures.h"

#include <gtest/gtest.h>

#include "import/tungsten/import_test_support.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

/// The reflectance of a diffuse bsdf with this albedo.
desc::Value albedo(const std::string& text) {
  return material_of(scene_with_bsdf("'type': 'lambert', 'albedo': " + text)).get("reflectance");
}
desc::Node texture_with(const std::string& text) {
  const desc::SceneDesc scene = scene_with_bsdf("'type': 'lambert', 'albedo': " + text);
  return scene.textures.at(static_cast<std::size_t>(material_of(scene).texture("reflectance")))
      .node;
}

TEST(TungstenTextures, MayBeConstants) {
  EXPECT_EQ(albedo("0.25"), desc::Value(Vec3(0.25F)));
  EXPECT_EQ(albedo("[0.1, 0.2, 0.3]"), desc::Value(Vec3(0.1F, 0.2F, 0.3F)));
  EXPECT_EQ(albedo("{'type': 'constant', 'value': 0.5}"), desc::Value(Vec3(0.5F)));
}

TEST(TungstenTextures, MayBeImages) {
  const desc::Node plain = texture_with("'a.png'");
  EXPECT_TRUE(plain.is("image"));
  EXPECT_TRUE(contains(plain.text("file"), "a.png"));
  EXPECT_EQ(plain.number("decoding_exponent"), 2.2F) << "colours are not sRGB";
  EXPECT_EQ(plain.text("wrap"), "repeat");
  EXPECT_EQ(plain.text("filter"), "bilinear");
  const desc::Node other = texture_with(
      "{'type': 'bitmap', 'file': 'a.png', 'gamma_correct': false, 'interpolate': false, "
      "'clamp': true, 'scale': 2}");
  EXPECT_EQ(other.number("decoding_exponent"), 1.F);
  EXPECT_EQ(other.text("wrap"), "clamp");
  EXPECT_EQ(other.text("filter"), "nearest");
  EXPECT_EQ(other.number("scale"), 2.F);
}

TEST(TungstenTextures, AsNumbersAreNotDecoded) {
  const auto ratio = [](const std::string& text) {
    const desc::SceneDesc scene = scene_with_bsdf(
        "'type': 'mixed', 'bsdf0': {'type': 'mirror'}, 'bsdf1': {'type': 'null'}, 'ratio': " +
        text);
    const desc::Value& value = material_of(scene).get("amount");
    const auto* texture = std::get_if<desc::TextureRef>(&value);
    return texture == nullptr ? desc::texture_node("constant", {{"value", value}})
                              : scene.textures.at(static_cast<std::size_t>(texture->id)).node;
  };
  const desc::Node image = ratio("{'type': 'bitmap', 'file': 'a.png', 'scale': 0.5}");
  EXPECT_EQ(image.text("channel"), "mean");
  EXPECT_EQ(image.number("decoding_exponent"), 1.F);
  EXPECT_EQ(image.number("scale"), 0.5F);
  EXPECT_EQ(ratio("[0.25, 0.5, 1]").color("value"), Vec3(0.25F)) << "the first, not the mean";
  const desc::Node checker = ratio("{'type': 'checker', 'on_color': [1, 0, 0], 'off_color': 0.5}");
  EXPECT_EQ(checker.color("first"), Vec3(0.5F));
  EXPECT_EQ(checker.color("second"), Vec3(1.F));
}

TEST(TungstenTextures, CheckersAreOffAtTheOrigin) {
  const desc::Node checker = texture_with(
      "{'type': 'checker', 'on_color': [1, 0, 0], 'off_color': 0.5, 'res_u': 4, 'res_v': 8}");
  EXPECT_TRUE(checker.is("checkerboard"));
  EXPECT_EQ(checker.get("first"), desc::Value(Vec3(0.5F)));
  EXPECT_EQ(checker.get("second"), desc::Value(Vec3(1.F, 0.F, 0.F)));
  EXPECT_EQ(checker.number("scale_u"), 4.F);
  EXPECT_EQ(checker.number("scale_v"), 8.F);
}

TEST(TungstenTextures, OfOtherTypesAreReplacedWithAWarning) {
  const auto with = [](const std::string& texture) {
    return scene_text("{'name': 'm', 'type': 'lambert', 'albedo': " + texture + "}",
                      "{'type': 'sphere', 'bsdf': 'm'}");
  };
  EXPECT_TRUE(
      contains(warnings_of(with("{'type': 'blade'}")),
               "test.json:2:54#/bsdfs/0/albedo: textures of type \"blade\" are not supported"))
      << warnings_of(with("{'type': 'blade'}"));
  EXPECT_TRUE(contains(warnings_of(with("{'type': 'chequer'}")), "did you mean \"checker\"?"));
  EXPECT_TRUE(contains(warnings_of(with("''")), "names no file"));
  EXPECT_TRUE(contains(error_of(with("{'res_u': 2}")), "a texture needs \"type\""));
  EXPECT_TRUE(contains(error_of(with("true")), "must be a texture"));
  EXPECT_TRUE(contains(error_of(with("[1, 2]")), "must be 3 numbers, not [1, 2]"));
}

}  // namespace
}  // namespace ajar::tungsten
