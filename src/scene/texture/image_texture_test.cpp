#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "imageio/image_encoder.h"
#include "scene/desc/models.h"
#include "scene/light/map.h"
#include "scene/material/relief.h"
#include "scene/testing/texture_points.h"
#include "scene/texture/image_cache.h"
#include "scene/texture/texture.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;
using testing::at_uv;

class ImageTextureTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("ajar_image_texture_") + test->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  template <typename T>
  std::string write(const std::string& name, int width, int height, int channels,
                    std::vector<T> texels) {
    std::string path = (folder_ / name).string();
    const auto output = OIIO::ImageOutput::create(path);
    OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<T>::value);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    EXPECT_TRUE(output->open(path, spec));
    EXPECT_TRUE(output->write_image(OIIO::BaseTypeFromC<T>::value, texels.data()));
    output->close();
    return path;
  }
  std::unique_ptr<const Texture> make(const desc::Node& node) {
    desc::SceneDesc scene;
    scene.textures.emplace_back().node = node;
    Warnings warnings;
    TextureList textures = build_textures(scene, warnings);
    EXPECT_EQ(warnings.count(), 0U);
    return std::move(textures.front());
  }
  fs::path folder_;
};

/// Rows from the top: 10 20 30 / 40 50 60 (of 255), linear.
std::vector<std::uint8_t> six() { return {10, 20, 30, 40, 50, 60}; }

TEST_F(ImageTextureTest, BottomRowIsAtTZero) {
  desc::Node node = desc::texture_node("image");
  node.set("file", write<std::uint8_t>("a.png", 3, 2, 1, six()));
  node.set("decode_srgb", false);
  node.set("filter", "nearest");
  const auto texture = make(node);
  EXPECT_NEAR(texture->eval_float(at_uv(0.1F, 0.1F)) * 255.F, 40.F, 1e-3F);
  EXPECT_NEAR(texture->eval_float(at_uv(0.9F, 0.9F)) * 255.F, 30.F, 1e-3F);
}

TEST_F(ImageTextureTest, BilinearInterpolatesBetweenTexelCentres) {
  desc::Node node = desc::texture_node("image");
  node.set("file", write<std::uint8_t>("a.png", 3, 2, 1, six()));
  node.set("decode_srgb", false);
  node.set("scale", 2.F);
  const auto texture = make(node);
  EXPECT_NEAR(texture->eval_float(at_uv(0.5F, 0.25F)) * 255.F, 100.F, 1e-3F);
  EXPECT_NEAR(texture->eval_float(at_uv(1.F / 3.F, 0.5F)) * 255.F, 60.F, 1e-3F);
}

TEST_F(ImageTextureTest, WrapModesDifferOutside) {
  desc::Node node = desc::texture_node("image");
  node.set("file", write<std::uint8_t>("a.png", 3, 2, 1, six()));
  node.set("decode_srgb", false);
  node.set("filter", "nearest");
  const auto value = [&](const char* wrap, float u, float v) {
    node.set("wrap", wrap);
    return make(node)->eval_float(at_uv(u, v)) * 255.F;
  };
  EXPECT_NEAR(value("repeat", 1.1F, 0.1F), 40.F, 1e-3F);
  EXPECT_NEAR(value("repeat", -0.1F, -0.1F), 30.F, 1e-3F);
  EXPECT_NEAR(value("clamp", 1.1F, 0.1F), 60.F, 1e-3F);
  EXPECT_NEAR(value("clamp", -5.F, 7.F), 10.F, 1e-3F);
  EXPECT_EQ(value("black", 1.1F, 0.1F), 0.F);
  EXPECT_NEAR(value("black", 0.9F, 0.1F), 60.F, 1e-3F);
  // A bilinear black border fades over half a texel; repetition joins the opposite edges.
  node.set("filter", "bilinear");
  EXPECT_NEAR(value("black", 0.F, 0.25F), 20.F, 1e-3F);
  EXPECT_NEAR(value("repeat", 0.F, 0.25F), 50.F, 1e-3F);
  EXPECT_NEAR(value("clamp", 0.F, 0.25F), 40.F, 1e-3F);
}

TEST_F(ImageTextureTest, IntegersAreDecodedAndFloatsAreNot) {
  desc::Node node = desc::texture_node("image");
  node.set("file", write<std::uint8_t>("b.png", 1, 1, 3, {128, 255, 0}));
  const Spectrum eight = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_NEAR(eight[0], 0.2158605F, 1e-6F);
  EXPECT_EQ(eight[1], 1.F);
  EXPECT_EQ(eight[2], 0.F);
  node.set("file", write<std::uint16_t>("b16.png", 1, 1, 3, {128 * 257, 65535, 0}));
  EXPECT_NEAR(make(node)->eval(at_uv(0.5F, 0.5F))[0], 0.2158605F, 1e-6F);
  node.set("file", write<float>("b.exr", 1, 1, 3, {0.5F, 7.F, 0.25F}));
  const Spectrum linear = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_EQ(linear[0], 0.5F);
  EXPECT_EQ(linear[1], 7.F);
}

TEST_F(ImageTextureTest, IntegersMayBeDecodedByAnExponent) {
  desc::Node node = desc::texture_node("image");
  node.set("decoding_exponent", 2.F);
  node.set("file", write<std::uint8_t>("g.png", 1, 1, 3, {51, 255, 0}));
  const Spectrum eight = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_NEAR(eight[0], 0.04F, 1e-6F);
  EXPECT_EQ(eight[1], 1.F);
  node.set("file", write<float>("g.exr", 1, 1, 3, {0.5F, 7.F, 0.25F}));
  EXPECT_EQ(make(node)->eval(at_uv(0.5F, 0.5F))[0], 0.5F);
}

TEST_F(ImageTextureTest, InvertedOnesAreOneMinusTheScaledValue) {
  desc::Node node = desc::texture_node("image");
  node.set("decode_srgb", false);
  node.set("invert", true);
  node.set("scale", 2.F);
  node.set("file", write<std::uint8_t>("i.png", 1, 1, 3, {51, 255, 0}));
  const Spectrum inverted = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_NEAR(inverted[0], 0.6F, 1e-6F);
  EXPECT_EQ(inverted[1], 0.F);
  EXPECT_EQ(inverted[2], 1.F);
}

TEST_F(ImageTextureTest, AnOffsetIsAddedAfterTheScale) {
  desc::Node node =
      desc::texture_node("image", {{"decode_srgb", false}, {"scale", 2.F}, {"offset", -0.25F}});
  node.set("file", write<float>("o.exr", 1, 1, 3, {0.25F, 0.5F, 1.F}));
  const Spectrum value = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_EQ(Vec3(value[0], value[1], value[2]), Vec3(0.25F, 0.75F, 1.75F));
  node.set("channel", std::string("red"));
  EXPECT_EQ(make(node)->eval_float(at_uv(0.5F, 0.5F)), 0.25F);
}

TEST_F(ImageTextureTest, MayBeClampedAfterTheScale) {
  desc::Node node = desc::texture_node("image");
  node.set("scale", 2.F);
  node.set("clamp", true);
  node.set("file", write<float>("c.exr", 1, 1, 3, {0.25F, 0.75F, -1.F}));
  const Spectrum clamped = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_EQ(clamped[0], 0.5F);
  EXPECT_EQ(clamped[1], 1.F);
  EXPECT_EQ(clamped[2], 0.F);
}

TEST_F(ImageTextureTest, GrayImagesAreGrayAndAlphaIsIgnored) {
  desc::Node node = desc::texture_node("image");
  node.set("decode_srgb", false);
  node.set("file", write<std::uint8_t>("gray.png", 1, 1, 1, {51}));
  const Spectrum gray = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_NEAR(gray[0], 0.2F, 1e-6F);
  EXPECT_EQ(gray[0], gray[2]);
  node.set("file", write<std::uint8_t>("rgba.png", 1, 1, 4, {51, 102, 153, 10}));
  const Spectrum rgba = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_NEAR(rgba[0], 0.2F, 1e-6F);
  EXPECT_NEAR(rgba[2], 0.6F, 1e-6F);
}

/// An EXR file of one pixel.
std::string written_exr(const std::string& path, const std::vector<std::string>& names,
                        const std::vector<float>& values) {
  ImageLayout layout;
  layout.width = layout.height = 1;
  layout.names = names;
  layout.resolution = {1, 1};
  const auto bytes =
      encode_exr(layout, [&](int, float* row) { std::copy(values.begin(), values.end(), row); });
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  return path;
}

TEST_F(ImageTextureTest, ColourLayersAreUsedWithoutAlpha) {
  desc::Node node = desc::texture_node("image");
  const auto color = [&](const std::vector<std::string>& names, const std::vector<float>& values) {
    node.set("file", written_exr((folder_ / "layers.exr").string(), names, values));
    const Spectrum c = make(node)->eval(at_uv(0.5F, 0.5F));
    return Vec3(c[0], c[1], c[2]);
  };
  EXPECT_EQ(color({"A", "Y"}, {0.75F, 0.25F}), Vec3(0.25F));
  Warnings warnings;
  EXPECT_EQ(load_map(node.text("file"), MapEdge::Clamp, {}, warnings).lookup({0.5F, 0.5F}),
            Spectrum(0.25F))
      << "of a light";
  EXPECT_EQ(warnings.count(), 0U);
  EXPECT_EQ(color({"Y", "Z"}, {0.25F, 9.F}), Vec3(0.25F));
  EXPECT_EQ(color({"Z", "diffuse.R", "diffuse.G", "diffuse.B"}, {9.F, 0.25F, 0.5F, 0.75F}),
            Vec3(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(color({"depth"}, {0.5F}), Vec3(0.5F));
  node.set("channel", std::string("alpha"));
  EXPECT_EQ(color({"A", "Y"}, {0.75F, 0.25F}), Vec3(0.75F));
  EXPECT_EQ(color({"beauty.A", "beauty.R", "beauty.G", "beauty.B"}, {0.75F, 0.1F, 0.1F, 0.1F}),
            Vec3(0.75F));
}

TEST_F(ImageTextureTest, AmbiguousLayersAreAWarning) {
  desc::SceneDesc scene;
  scene.textures.push_back(
      {"",
       {},
       desc::texture_node("image", {{"file", written_exr((folder_ / "two.exr").string(),
                                                         {"a.Y", "b.Y"}, {0.25F, 0.5F})}})});
  Warnings warnings;
  const TextureList textures = build_textures(scene, warnings);
  ASSERT_EQ(warnings.count(), 1U);
  EXPECT_NE(warnings.messages().front().find("of its channels \"a.Y\", \"b.Y\", \"a.Y\" is shown"),
            std::string::npos);
  EXPECT_EQ(textures.front()->eval_float(at_uv(0.5F, 0.5F)), 0.25F);
  Warnings of_light;
  EXPECT_EQ(load_map(scene.textures.front().node.text("file"), MapEdge::Clamp, {}, of_light)
                .lookup({0.5F, 0.5F}),
            Spectrum(0.25F));
  EXPECT_EQ(of_light.count(), 1U);
}

TEST_F(ImageTextureTest, AChannelAloneIsANumber) {
  desc::Node node = desc::texture_node("image", {{"decode_srgb", false}});
  const auto value = [&](const std::string& file, const char* channel) {
    node.set("file", file);
    node.set("channel", channel);
    return make(node)->eval_float(at_uv(0.5F, 0.5F)) * 255.F;
  };
  const std::string rgba = write<std::uint8_t>("rgba.png", 1, 1, 4, {51, 102, 153, 10});
  EXPECT_NEAR(value(rgba, "red"), 51.F, 1e-3F);
  EXPECT_NEAR(value(rgba, "green"), 102.F, 1e-3F);
  EXPECT_NEAR(value(rgba, "blue"), 153.F, 1e-3F);
  EXPECT_NEAR(value(rgba, "alpha"), 10.F, 1e-3F);
  const std::string gray_alpha = write<std::uint8_t>("ya.png", 1, 1, 2, {51, 10});
  EXPECT_NEAR(value(gray_alpha, "blue"), 51.F, 1e-3F);
  EXPECT_NEAR(value(gray_alpha, "alpha"), 10.F, 1e-3F);
  const std::string rgb = write<std::uint8_t>("rgb.png", 1, 1, 3, {51, 102, 153});
  EXPECT_NEAR(value(rgb, "alpha"), 255.F, 1e-3F) << "it has none";
}

TEST_F(ImageTextureTest, ColoursMayBeANumberByTheirMeanOrLuminance) {
  desc::Node node = desc::texture_node("image", {{"decoding_exponent", 2.F}});
  node.set("file", write<std::uint8_t>("rgb.png", 1, 1, 3, {51, 102, 204}));
  const auto of = [&](const char* channel) {
    node.set("channel", channel);
    const std::unique_ptr<const Texture> texture = make(node);
    const float value = texture->eval_float(at_uv(0.5F, 0.5F));
    EXPECT_EQ(texture->eval(at_uv(0.5F, 0.5F)), Spectrum(value)) << channel;
    return value;
  };
  // Decoded: .04, .16, .64.
  EXPECT_NEAR(of("mean"), 0.28F, 1e-6F);
  EXPECT_NEAR(of("alpha_or_mean"), 0.28F, 1e-6F) << "no alpha";
  EXPECT_NEAR(of("luminance"), luminance(Spectrum(0.04F, 0.16F, 0.64F)), 1e-6F);
}

TEST_F(ImageTextureTest, AlphaComesBeforeColours) {
  desc::Node node = desc::texture_node("image", {{"decode_srgb", false}, {"filter", "nearest"}});
  const auto second_of = [&](const std::string& file, const char* channel) {
    node.set("file", file);
    node.set("channel", channel);
    return make(node)->eval_float(at_uv(0.75F, 0.5F)) * 255.F;
  };
  const std::string clear =
      write<std::uint8_t>("clear.png", 2, 1, 4, {0, 0, 0, 10, 30, 60, 90, 255});
  const std::string opaque =
      write<std::uint8_t>("opaque.png", 2, 1, 4, {0, 0, 0, 255, 30, 60, 90, 255});
  const std::string floats =
      write<float>("opaque.exr", 2, 1, 4, {0.F, 0.F, 0.F, 1.F, 0.1F, 0.2F, 0.3F, 1.F});
  EXPECT_NEAR(second_of(clear, "alpha_or_mean"), 255.F, 1e-3F);
  EXPECT_NEAR(second_of(clear, "varying_alpha_or_mean"), 255.F, 1e-3F);
  EXPECT_NEAR(second_of(opaque, "alpha_or_mean"), 255.F, 1e-3F);
  EXPECT_NEAR(second_of(opaque, "varying_alpha_or_mean"), 60.F, 1e-3F);
  EXPECT_NEAR(second_of(floats, "varying_alpha_or_mean"), 0.2F * 255.F, 1e-3F);
  const std::string gray = write<std::uint8_t>("gray.png", 2, 1, 2, {10, 20, 30, 40});
  EXPECT_NEAR(second_of(gray, "alpha_or_mean"), 40.F, 1e-3F);
  EXPECT_NEAR(second_of(gray, "varying_alpha_or_mean"), 30.F, 1e-3F);
}

TEST_F(ImageTextureTest, EmbeddedFilesAreReadLikeOthers) {
  for (const char* extension : {"png", "jpg", "tif", "exr", "bmp", "webp"}) {
    const std::string path = write<std::uint8_t>(std::string("a.") + extension, 8, 8, 3,
                                                 std::vector<std::uint8_t>(192, 128));
    const TexelImage expected = read_texel_image({path});
    std::ifstream file(path, std::ios::binary);
    const desc::EmbeddedFiles embedded = {
        {"scene.abc#image",
         std::make_shared<const std::string>(std::istreambuf_iterator<char>(file),
                                             std::istreambuf_iterator<char>())}};
    const TexelImage image = read_texel_image({"scene.abc#image"}, embedded);
    EXPECT_EQ(image.width, 8) << extension;
    EXPECT_EQ(image.channels, expected.channels) << extension;
    EXPECT_TRUE(image.texels == expected.texels) << extension;
    EXPECT_EQ(image_size({"scene.abc#image"}, embedded).texels, 64U) << extension;
  }
}

TEST_F(ImageTextureTest, RotationTurnsFromUToVBeforeTheOffset) {
  // Rows from the top: 10 20 30 / 40 50 60.
  desc::Node node = desc::texture_node("image", {{"decode_srgb", false}, {"filter", "nearest"}});
  node.set("file", write<std::uint8_t>("a.png", 3, 2, 1, six()));
  node.set("rotation", 90.F);
  node.set("offset_u", 1.F);
  // (u, v) becomes (1 − v, u): the left edge of the surface shows the bottom row, from its end.
  const auto texture = make(node);
  EXPECT_NEAR(texture->eval_float(at_uv(0.1F, 0.1F)) * 255.F, 60.F, 1e-3F);
  EXPECT_NEAR(texture->eval_float(at_uv(0.1F, 0.9F)) * 255.F, 40.F, 1e-3F);
  EXPECT_NEAR(texture->eval_float(at_uv(0.9F, 0.1F)) * 255.F, 30.F, 1e-3F);
}

TEST_F(ImageTextureTest, ColourImagesUsedAsFloatsGiveLuminance) {
  desc::Node node = desc::texture_node("image");
  node.set("decode_srgb", false);
  node.set("file", write<std::uint8_t>("c.png", 1, 1, 3, {0, 255, 0}));
  EXPECT_NEAR(make(node)->eval_float(at_uv(0.5F, 0.5F)), 0.71516F, 3e-3F);
}

TEST_F(ImageTextureTest, InvalidTexelsBecomeBlack) {
  desc::Node node = desc::texture_node("image");
  node.set("file", write<float>("nan.exr", 1, 1, 3, {NAN, INFINITY, 2.F}));
  const Spectrum s = make(node)->eval(at_uv(0.5F, 0.5F));
  EXPECT_EQ(s[0], 0.F);
  EXPECT_EQ(s[1], 0.F);
  EXPECT_EQ(s[2], 2.F);
}

TEST_F(ImageTextureTest, FilesAreReadOnceForAllTextures) {
  const std::string path = write<std::uint8_t>("a.png", 3, 2, 1, six());
  const std::string missing = (folder_ / "missing.png").string();
  const ImageRequest requests[] = {{path}, {missing}, {path}, {path}};
  const ImageMap images = read_images(requests);
  ASSERT_EQ(images.size(), 2U);
  ASSERT_TRUE(images.at({path}).image);
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint8_t>>(images.at({path}).image->texels));
  EXPECT_FALSE(images.at({missing}).image);
  EXPECT_FALSE(images.at({missing}).error.empty());
}

TEST_F(ImageTextureTest, UnreadableImagesAreMagentaWithALocatedWarning) {
  const std::string broken = (folder_ / "broken.png").string();
  std::ofstream(broken) << "this is not a picture";
  desc::SceneDesc scene;
  for (const std::string& path : {broken, (folder_ / "missing.exr").string()}) {
    desc::Texture texture;
    texture.where = {std::make_shared<const std::string>("scene.pbrt"), 12, 3};
    desc::Node node = desc::texture_node("image");
    node.set("file", path);
    texture.node = node;
    scene.textures.push_back(texture);
  }
  Warnings warnings;
  const TextureList textures = build_textures(scene, warnings);
  for (const auto& texture : textures) {
    const Spectrum s = texture->eval(at_uv(0.3F, 0.3F));
    EXPECT_EQ(s[0], 1.F);
    EXPECT_EQ(s[1], 0.F);
    EXPECT_EQ(s[2], 1.F);
  }
  ASSERT_EQ(warnings.count(), 2U);
  EXPECT_EQ(warnings.messages().front().rfind("scene.pbrt:12:3: ", 0), 0U);
}

TEST_F(ImageTextureTest, PrimariesOfTheirOwnAreAWarningForColours) {
  // Red, green, blue and white of Rec. 2020 and of Rec. 709.
  const float wide[] = {0.708F, 0.292F, 0.17F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.329F};
  const float usual[] = {0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F};
  const auto warnings = [&](const float* primaries, const desc::Node& settings) {
    const std::string path = (folder_ / "p.exr").string();
    const auto output = OIIO::ImageOutput::create(path);
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), primaries);
    const float texel[] = {1.F, 0.5F, 0.25F};
    EXPECT_TRUE(output->open(path, spec));
    EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, texel));
    output->close();
    desc::SceneDesc scene;
    desc::Node node = settings;
    node.set("file", path);
    scene.textures.push_back({"", {}, node});
    Warnings found;
    build_textures(scene, found);
    load_map(path, MapEdge::Clamp, {}, found);
    return found.count();
  };
  // One warning of the texture, and one of a light with the same file.
  EXPECT_EQ(warnings(wide, desc::texture_node("image")), 2U);
  EXPECT_EQ(warnings(usual, desc::texture_node("image")), 0U);
  // Normals and numbers have none.
  EXPECT_EQ(warnings(wide, desc::texture_node("image", {{"decode_srgb", false}})), 1U);
  EXPECT_EQ(warnings(wide, desc::texture_node("image", {{"channel", std::string("mean")}})), 1U);
}

TEST_F(ImageTextureTest, UnreadableImagesOfNumbersChangeNothingElse) {
  desc::SceneDesc scene;
  desc::Node node = desc::texture_node("image", {{"channel", std::string("alpha_or_mean")}});
  node.set("file", (folder_ / "missing.exr").string());
  scene.textures.push_back({"", {}, node});
  desc::Node normals = desc::texture_node("image", {{"decode_srgb", false}});
  normals.set("file", (folder_ / "missing.exr").string());
  scene.textures.push_back({"", {}, normals});
  Warnings warnings;
  const TextureList textures = build_textures(scene, warnings);
  EXPECT_EQ(textures[0]->eval(at_uv(0.3F, 0.3F)), Spectrum(1.F));
  EXPECT_TRUE(warnings.messages().front().ends_with("it is replaced by 1"));
  // Nor does a normal map tilt the normal.
  desc::Material material;
  material.normal_map.texture = 1;
  EXPECT_TRUE(Relief(material, textures).is_flat());
}

}  // namespace
}  // namespace ajar
