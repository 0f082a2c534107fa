// Scenes of glTF whose pictures are known in closed form: units, sides, directions, colours.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "import/gltf/gltf_import.h"
#include "support/temporary_file.h"
#include "support/tiny_picture.h"

namespace ajar {
namespace {

using test::expect_color;
using test::MayWarn;
using test::TinyPicture;
using Json = nlohmann::json;

constexpr int kFloat = 5126;
constexpr int kNearest = 9728;

/// A camera at z = 5 that sees a width of 4 of the plane z = 0, and squares of 4 × 4 that face it,
/// images upright on them.
class Gltf : public ::testing::Test {
 protected:
  Gltf() {
    const std::vector<float> corners = {-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0};
    // v counts from the top row of an image.
    const std::vector<float> uvs = {0, 1, 1, 1, 1, 0, 0, 0};
    add_accessor(corners, "VEC3", 4);
    add_accessor(uvs, "VEC2", 4);
    const std::vector<std::uint16_t> indices = {0, 1, 2, 0, 2, 3};
    add_accessor(indices, "SCALAR", 6, 5123);
    look_from(5.F, 4.F);
  }

  template <typename T>
  std::size_t add_accessor(const std::vector<T>& values, const char* type, std::size_t count,
                           int component = kFloat) {
    const std::size_t offset = (bytes_.size() + 3) / 4 * 4;
    bytes_.resize(offset);
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", component},
                                  {"count", count},
                                  {"type", type}});
    return json_["accessors"].size() - 1;
  }
  void look_from(float distance, float width) {
    json_["cameras"] = Json::array(
        {{{"type", "perspective"},
          {"perspective", {{"yfov", 2.0 * std::atan(0.5 * width / distance)}, {"znear", 0.1}}}}});
    json_["nodes"][0] = {{"camera", 0}, {"translation", {0, 0, distance}}};
  }
  void add_light(const Json& light, Json node = Json::object()) {
    Json& lights = json_["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(light);
    node["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
    json_["nodes"].push_back(node);
  }
  void add_square(const Json& material, Json node = Json::object(),
                  const Json& attributes = Json::object()) {
    Json all = {{"POSITION", 0}, {"TEXCOORD_0", 1}};
    all.update(attributes);
    json_["materials"].push_back(material);
    json_["meshes"].push_back(
        {{"primitives", Json::array({{{"attributes", all},
                                      {"indices", 2},
                                      {"material", json_["materials"].size() - 1}}})}});
    node["mesh"] = json_["meshes"].size() - 1;
    json_["nodes"].push_back(node);
  }
  /// The number of a texture that shows its texels as squares.
  std::size_t add_image(const std::string& file) {
    json_["samplers"] = Json::array({{{"magFilter", kNearest}}});
    json_["images"].push_back({{"uri", file}});
    json_["textures"].push_back({{"source", json_["images"].size() - 1}, {"sampler", 0}});
    return json_["textures"].size() - 1;
  }
  TinyPicture picture(int samples = 1, MayWarn may_warn = MayWarn::No) {
    if (!json_.contains("extensions")) {
      // Far away and of hardly any light: it keeps the studio out.
      add_light({{"type", "point"}, {"intensity", 1e-9}}, {{"translation", {0, 0, 1e4}}});
    }
    json_["asset"] = {{"version", "2.0"}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"nodes", Json::array()}}});
    for (std::size_t i = 0; i < json_["nodes"].size(); ++i) {
      json_["scenes"][0]["nodes"].push_back(i);
    }
    json_["buffers"] = Json::array({{{"uri", "squares.bin"}, {"byteLength", bytes_.size()}}});
    return test::picture_of(
        [&](Warnings& warnings) {
          desc::SceneDesc scene =
              import_gltf_bytes(json_.dump(), "test.gltf", "/tmp", warnings,
                                [&](const std::string& path) -> std::optional<std::string_view> {
                                  if (path.ends_with("squares.bin")) return bytes_;
                                  return std::nullopt;
                                });
          scene.film.resolution = Vec2i(16, 16);
          scene.film.filter = {};
          return scene;
        },
        samples, may_warn);
  }

  Json json_;
  std::string bytes_;
};

/// Shines with this radiance and reflects nothing.
Json shining(const Json& color, double strength = 1.0) {
  return {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}},
          {"emissiveFactor", color},
          {"extensions",
           {{"KHR_materials_emissive_strength", {{"emissiveStrength", strength}}},
            {"KHR_materials_specular", {{"specularFactor", 0}}}}}};
}
/// Reflects this diffusely and nothing else.
Json matt(const Json& color) {
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", color}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
          {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0}}}}}};
}

TEST_F(Gltf, EmissionIsRadianceOfTheFrontUnlessDoubleSided) {
  add_square(shining({0.1, 0.2, 0.3}, 10));
  expect_color(picture().mean(), {1, 2, 3});
  // Turned about y.
  json_["nodes"][1]["rotation"] = {0, 1, 0, 0};
  EXPECT_LT(picture().mean().x, 1e-6F);
  json_["materials"][0]["doubleSided"] = true;
  expect_color(picture().mean(), {1, 2, 3});
}

TEST_F(Gltf, WallsGoWhereWeightsAndJointsMoveThem) {
  add_square(shining({0.1, 0.2, 0.3}, 10));
  Json& primitive = json_["meshes"][0]["primitives"][0];
  const std::vector<float> shift = {4, 0, 0, 4, 0, 0, 4, 0, 0, 4, 0, 0};
  primitive["targets"] = Json::array({{{"POSITION", add_accessor(shift, "VEC3", 4)}}});
  const auto expect_seen = [&](bool left, bool right) {
    const TinyPicture seen = picture(16);
    expect_color(seen.mean(0.F, 0.45F), left ? Vec3(1, 2, 3) : Vec3(0.F), 1e-3F);
    expect_color(seen.mean(0.55F, 1.F), right ? Vec3(1, 2, 3) : Vec3(0.F), 1e-3F);
  };
  expect_seen(true, true);
  json_["meshes"][0]["weights"] = {0.5};
  expect_seen(false, true);
  // A joint that is 4 to the left of where it was bound, and so 2 to the left in all.
  primitive["attributes"]["JOINTS_0"] =
      add_accessor(std::vector<std::uint8_t>(16, 0), "VEC4", 4, 5121);
  const std::vector<float> whole = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  primitive["attributes"]["WEIGHTS_0"] = add_accessor(whole, "VEC4", 4);
  json_["nodes"].push_back({{"translation", {-4, 0, 0}}});
  json_["skins"] = Json::array({{{"joints", {json_["nodes"].size() - 1}}}});
  json_["nodes"][1]["skin"] = 0;
  expect_seen(true, false);
}

TEST_F(Gltf, PointLightLightsAWallByTheInverseSquare) {
  // E = I / d² of I candela; a base without gloss is even.
  look_from(5.F, 0.05F);
  add_square(matt({0.5, 0.5, 0.5, 1}));
  add_light({{"type", "point"}, {"intensity", 10}, {"color", {1, 0.5, 0.25}}},
            {{"translation", {0, 0, 2}}});
  expect_color(picture(4).mean(), Vec3(10, 5, 2.5F) * (0.5F / kPi / 4.F), 2e-3F);
}

TEST_F(Gltf, DirectionalLightShinesAlongMinusZ) {
  look_from(5.F, 0.05F);
  add_square(matt({0.5, 0.5, 0.5, 1}));
  add_light({{"type", "directional"}, {"intensity", 10}, {"color", {1, 0.5, 0.25}}});
  expect_color(picture(4).mean(), Vec3(10, 5, 2.5F) * (0.5F / kPi), 2e-3F);
}

TEST_F(Gltf, SpotsReachAsFarAsTheirCone) {
  add_square(matt({1, 1, 1, 1}));
  add_light({{"type", "spot"},
             {"intensity", 8},
             {"spot", {{"innerConeAngle", kPi / 6.0}, {"outerConeAngle", kPi / 6.0 + 1e-3}}}},
            {{"translation", {0, 0, 2}}});
  const TinyPicture seen = picture(16, MayWarn::Yes);
  // Straight below I / d² / π, and beyond 2 tan 30° = 1.15 nothing.
  EXPECT_NEAR(seen.mean(0.45F, 0.55F, 0.45F, 0.55F).x, 8.F / 4.F / kPi, 0.03F);
  EXPECT_LT(seen.mean(0.F, 0.15F).x, 1e-6F);
}

TEST_F(Gltf, ImagesAreUprightWithVDownward) {
  const test::FourColors image;
  Json material = shining({1, 1, 1});
  material["emissiveTexture"] = {{"index", add_image(image.path().substr(5))}};
  add_square(material);
  test::expect_four_colors(picture());
}

TEST_F(Gltf, PicturesAreNotMirrored) {
  // Space is right-handed: seen along −z with +y up, +x is to the right.
  add_square(shining({1, 0, 0}), {{"translation", {2, 0, 0}}});
  add_square(shining({0, 1, 0}), {{"translation", {-2, 0, 0}}});
  add_square(shining({0, 0, 1}), {{"translation", {0, 2, 0.01}}});
  const TinyPicture seen = picture();
  expect_color(seen.lower_right(), {1, 0, 0});
  expect_color(seen.lower_left(), {0, 1, 0});
  expect_color(seen.mean(0.3F, 0.7F, 0.1F, 0.4F), {0, 0, 1});
}

TEST_F(Gltf, BothSidesReflectWithAnyDoubleSided) {
  // Light along −z, with the irradiance 2π, from the side of the camera.
  add_light({{"type", "directional"}, {"intensity", 2.0 * M_PI}});
  add_square(matt({0.25, 0.5, 0.125, 1}));
  const Vec3 front = picture(16).mean();
  json_["nodes"].back()["rotation"] = {0, 1, 0, 0};
  for (const bool double_sided : {false, true}) {
    json_["materials"][0]["doubleSided"] = double_sided;
    expect_color(picture(16).mean(), front);
  }
  EXPECT_GT(front.x, 0.3F);
}

TEST_F(Gltf, ColorsOfImagesAreDecodedAndFactorsAreLinear) {
  const test::CodedGray image(188);
  Json material = shining({0.5, 0.25, 1});
  material["emissiveTexture"] = {{"index", add_image(image.path().substr(5))}};
  add_square(material);
  expect_color(picture().mean(), Vec3(0.5F, 0.25F, 1) * image.decoded());
}

TEST_F(Gltf, AlphaOfImagesIsNotDecoded) {
  // Images without alpha are opaque, so the share comes from the factor, which is linear.
  add_square(shining({1, 1, 1}), {{"translation", {0, 0, -1}}, {"scale", {2, 2, 1}}});
  Json pane = matt({0, 0, 0, 0.25});
  pane["alphaMode"] = "BLEND";
  add_square(pane);
  expect_color(picture(256).mean(), Vec3(0.75F), 0.02F);
  json_["materials"][1]["alphaMode"] = "OPAQUE";
  EXPECT_LT(picture(4).mean().x, 1e-6F);
  json_["materials"][1]["alphaMode"] = "MASK";
  expect_color(picture(4).mean(), Vec3(1));
  json_["materials"][1]["alphaCutoff"] = 0.2;
  EXPECT_LT(picture(4).mean().x, 1e-6F);
}

TEST_F(Gltf, SmoothMetalsReflectTheirBaseColorAndOthersFourPercent) {
  // A large lamp behind the camera, which it does not hide.
  look_from(5.F, 0.02F);
  add_square(shining({1, 1, 1}),
             {{"translation", {0, 0, 8}}, {"rotation", {0, 1, 0, 0}}, {"scale", {10, 10, 1}}});
  const auto smooth = [](double metallic, const Json& color) -> Json {
    return {
        {"pbrMetallicRoughness",
         {{"baseColorFactor", color}, {"metallicFactor", metallic}, {"roughnessFactor", 0.02}}}};
  };
  add_square(smooth(1, {0.9, 0.5, 0.1, 1}));
  expect_color(picture(64).mean(), {0.9F, 0.5F, 0.1F}, 0.02F);
  json_["materials"][1] = smooth(0, {0, 0, 0, 1});
  expect_color(picture(64).mean(), Vec3(0.04F), 0.03F);
  json_["materials"][1]["extensions"]["KHR_materials_ior"]["ior"] = 2.0;
  expect_color(picture(64).mean(), Vec3(1.F / 9), 0.03F);
}

TEST_F(Gltf, UnlitSurfacesShineInTheirColor) {
  Json material = matt({0.2, 0.4, 0.8, 1});
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  add_square(material);
  expect_color(picture(1, MayWarn::Yes).mean(), {0.2F, 0.4F, 0.8F});
}

TEST_F(Gltf, ThinGlassTransmitsTheRest) {
  // A pane reflects 2R / (1 + R), all orders between its sides in all; light that passes has the
  // base colour.
  look_from(5.F, 0.02F);
  add_square(shining({1, 1, 1}), {{"translation", {0, 0, -1}}});
  Json pane = {
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {1, 0.5, 0.25, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0}}},
      {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}};
  add_square(pane);
  const float r = test::normal_reflectance(1.5F, 0.F);
  expect_color(picture(256).mean(), Vec3(1, 0.5F, 0.25F) * (1.F - 2.F * r / (1.F + r)), 0.02F);
}

TEST_F(Gltf, ColorsOfVerticesRunLinearlyOverTriangles) {
  // Red grows with x, green with y: c = (x + y) / 2 of the corners on either triangle.
  const std::vector<float> colors = {0, 0, 0.5F, 1, 0, 0.5F, 1, 1, 0.5F, 0, 1, 0.5F};
  const std::size_t accessor = add_accessor(colors, "VEC3", 4);
  add_square(matt({1, 0.5, 1, 1}), Json::object(), {{"COLOR_0", accessor}});
  add_light({{"type", "directional"}, {"intensity", kPi}});
  const TinyPicture seen = picture(4);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const std::size_t pixel = 3 * static_cast<std::size_t>(16 * y + x);
      const float fx = (static_cast<float>(x) + 0.5F) / 16.F;
      const float fy = 1.F - (static_cast<float>(y) + 0.5F) / 16.F;
      // Two standard errors of where in the pixel it was looked.
      EXPECT_NEAR(seen.pixels[pixel], fx, 0.03F);
      EXPECT_NEAR(seen.pixels[pixel + 1], 0.5F * fy, 0.02F);
      EXPECT_NEAR(seen.pixels[pixel + 2], 0.5F, 0.01F);
    }
  }
}

TEST_F(Gltf, DiffuseTransmissionSharesLightBetweenTheSides) {
  // Lit from behind: the share f of base / π.
  look_from(5.F, 0.05F);
  Json material = matt({0.8, 0.8, 0.8, 1});
  material["extensions"]["KHR_materials_diffuse_transmission"]["diffuseTransmissionFactor"] = 0.25;
  add_square(material);
  add_light({{"type", "directional"}, {"intensity", kPi}}, {{"rotation", {0, 1, 0, 0}}});
  expect_color(picture(4, MayWarn::Yes).mean(), Vec3(0.8F * 0.25F), 0.02F);
}

TEST_F(Gltf, MirroredSquaresShineToTheirFront) {
  // The order of corners that is the front turns with the sign of the determinant (glTF 2.0,
  // section 3.7.4): the mirrored object, seen from its own front.
  add_square(shining({0.1, 0.2, 0.3}, 10));
  for (const auto& [scale, is_seen] : std::vector<std::pair<Json, bool>>{
           {{-1, 1, 1}, true}, {{1, -1, 1}, true}, {{1, 1, -1}, false}, {{-1, -1, -1}, false}}) {
    json_["nodes"][1]["scale"] = scale;
    const Vec3 seen = picture().mean();
    EXPECT_NEAR(seen.z, is_seen ? 3.F : 0.F, 1e-3F) << scale;
  }
}

TEST_F(Gltf, NormalMapsTiltWhereTheirCoordinatesRun) {
  // Everywhere (0.6, 0, 0.8), lit from (1, 0, 1) / √2.
  const test::TemporaryFile map("tilt.pfm");
  const float texel[] = {0.8F, 0.5F, 0.9F};
  std::ofstream(map.path(), std::ios::binary)
      << "PF\n1 1\n-1\n"
      << std::string_view(reinterpret_cast<const char*>(texel), sizeof(texel));
  Json material = matt({1, 1, 1, 1});
  material["normalTexture"] = {{"index", add_image(map.path().substr(5))}};
  const std::vector<float> up = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::vector<float> mirrored = {1, 1, 0, 1, 0, 0, 1, 0};
  const std::vector<float> left = {-1, 0, 0, -1, -1, 0, 0, -1, -1, 0, 0, -1, -1, 0, 0, -1};
  const std::size_t normals = add_accessor(up, "VEC3", 4);
  add_square(material, {}, {{"NORMAL", normals}});
  add_light({{"type", "directional"}, {"intensity", M_PI}},
            {{"rotation", {0, std::sin(M_PI / 8), 0, std::cos(M_PI / 8)}}});
  Json& attributes = json_["meshes"][0]["primitives"][0]["attributes"];
  const auto expect_lit = [&](double cosine) { EXPECT_NEAR(picture(64).mean().x, cosine, 0.01); };
  const double toward = 1.4 * M_SQRT1_2;
  const double away = 0.2 * M_SQRT1_2;
  expect_lit(toward);
  json_["nodes"][1]["scale"] = {-1, 1, 1};
  expect_lit(away);
  json_["nodes"][1]["scale"] = {1, 1, 1};
  attributes["TANGENT"] = add_accessor(left, "VEC4", 4);
  expect_lit(away);
  attributes.erase("TANGENT");
  attributes["TEXCOORD_0"] = add_accessor(mirrored, "VEC2", 4);
  expect_lit(away);
}

TEST_F(Gltf, LampsAndCamerasDoNotHaveTheScaleOfTheirNodes) {
  add_square(matt({1, 1, 1, 1}));
  add_light({{"type", "directional"}, {"intensity", M_PI / 2}}, {{"scale", {10, 3, 2}}});
  add_light({{"type", "point"}, {"intensity", 1e6 * M_PI / 2}},
            {{"translation", {0, 0, 1000}}, {"scale", {4, 4, 4}}});
  json_["cameras"] =
      Json::array({{{"type", "orthographic"},
                    {"orthographic", {{"xmag", 4}, {"ymag", 4}, {"znear", 0.1}, {"zfar", 9}}}}});
  json_["nodes"][0]["scale"] = {-0.01, 5, 7};
  // The square is half as wide as the picture.
  const TinyPicture seen = picture(64);
  expect_color(seen.mean(0.3F, 0.7F, 0.3F, 0.7F), Vec3(1.F), 0.02F);
  EXPECT_LT(seen.mean(0.F, 0.2F).x, 1e-6F);
  EXPECT_LT(seen.mean(0.F, 1.F, 0.F, 0.2F).x, 1e-6F);
}

}  // namespace
}  // namespace ajar
