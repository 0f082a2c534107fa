#include "ajar/c.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

// The library as programs in other languages see it: no header but its own.
namespace {

using Json = nlohmann::ordered_json;

std::string taken(char* text) {
  std::string copy = text;
  ajar_text_free(text);
  return copy;
}

template <typename Function, typename... Arguments>
Json json_of(Function function, Arguments... arguments) {
  char* text = nullptr;
  if (function(arguments..., &text) != AJAR_OK) {
    ADD_FAILURE() << ajar_last_error();
    return {};
  }
  return Json::parse(taken(text));
}

using Scene = std::unique_ptr<ajar_scene, decltype(&ajar_scene_free)>;
using Render = std::unique_ptr<ajar_render, decltype(&ajar_render_free)>;
using Picture = std::unique_ptr<ajar_picture, decltype(&ajar_picture_free)>;

Scene scene_of(const std::string& name) {
  ajar_scene* scene = nullptr;
  EXPECT_EQ(ajar_scene_load(name.c_str(), &scene), AJAR_OK) << ajar_last_error();
  return {scene, ajar_scene_free};
}

Scene changed(const ajar_scene* base, const std::string& changes,
              const std::vector<ajar_array>& arrays = {}) {
  ajar_scene* scene = nullptr;
  EXPECT_EQ(ajar_scene_change(base, changes.c_str(), arrays.data(), arrays.size(), &scene), AJAR_OK)
      << ajar_last_error();
  return {scene, ajar_scene_free};
}

Render started(const Scene& scene, const std::string& settings) {
  ajar_render* render = nullptr;
  EXPECT_EQ(ajar_render_start(scene.get(), settings.c_str(), &render), AJAR_OK)
      << ajar_last_error();
  return {render, ajar_render_free};
}

Picture picture_of(const Render& render) {
  ajar_picture* picture = nullptr;
  EXPECT_EQ(ajar_render_picture(render.get(), &picture), AJAR_OK) << ajar_last_error();
  return {picture, ajar_picture_free};
}

std::vector<float> pixels_of(const Picture& picture, const char* layer = "") {
  int channels = 0;
  const float* pixels = nullptr;
  EXPECT_EQ(ajar_picture_pixels(picture.get(), layer, &channels, &pixels), AJAR_OK)
      << ajar_last_error();
  const int count =
      ajar_picture_width(picture.get()) * ajar_picture_height(picture.get()) * channels;
  return {pixels, pixels + count};
}

const std::string kSmall = R"({"integrator": "pt", "resolution": [12, 9], "samples_per_pixel": 4})";

std::vector<float> rendered(const Scene& scene, const std::string& settings = kSmall) {
  const Render render = started(scene, settings);
  EXPECT_EQ(ajar_render_wait(render.get(), -1.0, nullptr), AJAR_OK) << ajar_last_error();
  return pixels_of(picture_of(render));
}

/// Message of a call that must fail.
std::string complaint(int code, int expected) {
  EXPECT_EQ(code, expected) << ajar_last_error();
  return code == AJAR_OK ? "" : ajar_last_error();
}

TEST(CFace, ListsWhatThereIs) {
  EXPECT_GE(ajar_c_version(), AJAR_C_VERSION);
  EXPECT_STRNE(ajar_version(), "");
  EXPECT_GT(json_of(ajar_catalog, "integrators").size(), 3U);
  char* text = nullptr;
  EXPECT_NE(complaint(ajar_catalog("material", &text), AJAR_USAGE).find("\"materials\"?"),
            std::string::npos);
}

TEST(CFace, RendersAScene) {
  const Scene scene = scene_of("builtin:cornell");
  EXPECT_EQ(json_of(ajar_scene_information, scene.get())["name"], "builtin:cornell");
  const Render render = started(
      scene,
      R"({"integrator": "pt", "resolution": [12, 9], "samples_per_pixel": 4, "layers": ["depth"]})");
  int done = 0;
  EXPECT_EQ(ajar_render_wait(render.get(), -1.0, &done), AJAR_OK);
  EXPECT_EQ(done, 1);
  EXPECT_EQ(json_of(ajar_render_progress, render.get())["done"], true);
  EXPECT_EQ(json_of(ajar_render_statistics, render.get())["integrator"], "pt");
  EXPECT_EQ(json_of(ajar_render_messages, render.get())["warnings"].size(), 0U);
  const Picture picture = picture_of(render);
  const Json layers = json_of(ajar_picture_layers, picture.get());
  EXPECT_EQ(layers.front(), "");
  EXPECT_EQ(layers.back(), "depth");
  EXPECT_EQ(json_of(ajar_picture_metadata, picture.get())["ajar:integrator"], "pt");
  EXPECT_EQ(pixels_of(picture).size(), 12U * 9U * 3U);
  EXPECT_EQ(pixels_of(picture), rendered(scene));
  const std::string path =
      (std::filesystem::temp_directory_path() / ("ajar-c-" + std::to_string(getpid()) + ".exr"))
          .string();
  EXPECT_EQ(ajar_picture_save(picture.get(), path.c_str(), nullptr), AJAR_OK) << ajar_last_error();
  ajar_picture* loaded = nullptr;
  ASSERT_EQ(ajar_picture_load(path.c_str(), &loaded), AJAR_OK) << ajar_last_error();
  EXPECT_EQ(pixels_of({loaded, ajar_picture_free}), pixels_of(picture));
  const Json request{{"reference", path}, {"pictures", {path}}, {"metrics", {"mse"}}};
  const std::string text = request.dump();
  EXPECT_EQ(json_of(ajar_compare, text.c_str())["pictures"][0]["metrics"]["mse"], 0.0);
  std::filesystem::remove(path);
}

TEST(CFace, SaysWhatIsWrong) {
  ajar_scene* none = nullptr;
  complaint(ajar_scene_load("/no/such/file.pbrt", &none), AJAR_FILE);
  complaint(ajar_scene_load("builtin:cornel", &none), AJAR_USAGE);
  const Scene scene = scene_of("builtin:cornell");
  ajar_render* render = nullptr;
  const auto refused = [&](const char* settings) {
    return complaint(ajar_render_start(scene.get(), settings, &render), AJAR_USAGE);
  };
  EXPECT_NE(refused(R"({"integrater": "pt"})").find("\"integrator\"?"), std::string::npos);
  EXPECT_NE(refused(R"({"integrator": "ptt"})").find("\"pt\"?"), std::string::npos);
  EXPECT_NE(refused(R"({"seed": -1})").find("seed: must be"), std::string::npos);
  EXPECT_NE(refused(R"({"resolution": [3]})").find("resolution: must be 2 numbers"),
            std::string::npos);
  EXPECT_NE(refused("[1]").find("must be an object"), std::string::npos);
  refused("{");
  // Errors that need the scene come later.
  const Render wrong = started(scene, R"({"parameters": {"nothing": 1}})");
  EXPECT_NE(complaint(ajar_render_wait(wrong.get(), -1.0, nullptr), AJAR_USAGE).find("\"nothing\""),
            std::string::npos);
  EXPECT_EQ(picture_of(wrong), nullptr);
}

TEST(CFace, IsStoppedAndAskedMeanwhile) {
  const Scene scene = scene_of("builtin:cornell");
  const Render render =
      started(scene, R"({"integrator": "pt", "resolution": [12, 9], "seconds": 86400})");
  int done = 1;
  EXPECT_EQ(ajar_render_wait(render.get(), 0.0, &done), AJAR_OK);
  EXPECT_EQ(done, 0);
  while (!picture_of(render)) std::this_thread::yield();
  EXPECT_EQ(ajar_render_stop(render.get()), AJAR_OK);
  EXPECT_EQ(ajar_render_wait(render.get(), -1.0, &done), AJAR_OK) << ajar_last_error();
  EXPECT_EQ(done, 1);
  // One that is let go while it renders.
  started(scene, R"({"integrator": "pt", "seconds": 86400})");
}

constexpr std::array<float, 12> kCorners = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
constexpr std::array<std::uint32_t, 6> kTriangles = {0, 2, 1, 0, 3, 2};
constexpr std::array<std::uint8_t, 12> kImage = {255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9};
constexpr std::array<float, 6> kSky = {1, 1, 1, 4, 4, 4};

const std::vector<ajar_array>& arrays() {
  static const std::vector<ajar_array> kArrays = {{kCorners.data(), AJAR_FLOAT32, 2, {4, 3, 1}},
                                                  {kTriangles.data(), AJAR_UINT32, 2, {2, 3, 1}},
                                                  {kImage.data(), AJAR_UINT8, 3, {2, 2, 3}},
                                                  {kSky.data(), AJAR_FLOAT32, 3, {2, 1, 3}}};
  return kArrays;
}

/// A floor under a sky, from above.
const std::string kFloor = R"({
  "film": {"resolution": [12, 9]},
  "camera": {"model": "perspective", "fov": 40,
             "to_world": [1,0,0,0, 0,0,-1,4, 0,-1,0,0, 0,0,0,1]},
  "materials": [{"name": "paint", "model": "diffuse", "parameters": {"reflectance": 0.5}}],
  "shapes": [{"name": "floor", "where": ["floor.py", 7], "model": "mesh",
              "parameters": {"mesh": {"positions": 0, "indices": 1}}, "material": 0}],
  "lights": [{"model": "environment", "parameters": {"radiance": [2, 2, 2]}}]})";

TEST(CFace, MakesAndEditsScenes) {
  const Scene grey = changed(nullptr, kFloor, arrays());
  const std::vector<float> before = rendered(grey);
  // In the middle there is nothing but the floor: half of the light.
  EXPECT_NEAR(before[3 * (4 * 12 + 6)], 1.F, 0.25F);
  const Scene red = changed(grey.get(), R"({"edits": [
    {"kind": "material", "which": "paint", "parameters": {"reflectance": [0.5, 0, 0]}}]})");
  const std::vector<float> after = rendered(red);
  EXPECT_EQ(after[3 * (4 * 12 + 6)], before[3 * (4 * 12 + 6)]);
  EXPECT_EQ(after[3 * (4 * 12 + 6) + 1], 0.F);
  EXPECT_EQ(rendered(grey), before) << "the other has not changed";
  const Json parts = json_of(ajar_scene_parts, red.get());
  EXPECT_EQ(parts["materials"][0]["parameters"]["reflectance"], Json({0.5, 0.0, 0.0}));
  EXPECT_EQ(parts["shapes"][0]["name"], "floor");
}

TEST(CFace, TakesImagesOfArrays) {
  const Scene grey = changed(nullptr, kFloor, arrays());
  const Scene painted =
      changed(grey.get(),
              R"({"textures": [{"model": "image", "parameters": {"file": {"image": 2}}}],
          "edits": [{"kind": "material", "which": 0, "parameters": {"reflectance": {"texture": 0}}},
                    {"kind": "light", "which": 0, "parameters": {"radiance": 1, "image": {"image": 3}}}]})",
              arrays());
  EXPECT_TRUE(json_of(ajar_scene_information, painted.get())["warnings"].empty());
  const Render render = started(painted, kSmall);
  EXPECT_EQ(ajar_render_wait(render.get(), -1.0, nullptr), AJAR_OK);
  EXPECT_TRUE(json_of(ajar_render_messages, render.get())["warnings"].empty())
      << json_of(ajar_render_messages, render.get());
  EXPECT_NE(pixels_of(picture_of(render)), rendered(grey));
}

TEST(CFace, SaysWhereASceneIsWrong) {
  const auto refused = [](const std::string& changes) {
    ajar_scene* scene = nullptr;
    return complaint(
        ajar_scene_change(nullptr, changes.c_str(), arrays().data(), arrays().size(), &scene),
        AJAR_SCENE);
  };
  const auto has = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const auto shape = [&](const std::string& members) {
    return refused(R"({"shapes": [{"where": ["a.py", 3], )" + members + "}]}");
  };
  has(shape(R"("model": "sphere", "parameters": {"radios": 1})"),
      "a.py:3: shape: unknown parameter");
  has(shape(R"("model": "sphere", "parameters": {"radios": 1})"), "\"radius\"?");
  has(shape(R"("model": "spere")"), "\"sphere\"?");
  has(shape(R"("model": "sphere", "parameters": {"radius": "1"})"), "must be a number");
  has(shape(R"("model": "mesh")"), "it needs \"mesh\"");
  has(shape(R"("model": "mesh", "parameters": {"mesh": {"positions": 1, "indices": 0}})"), "N x 3");
  has(shape(R"("model": "mesh", "parameters": {"mesh": {"positions": 9, "indices": 0}})"),
      "positions: refers to number 9, but there are 4");
  has(shape(R"("model": "sphere", "material": "none")"), "unknown material");
  has(shape(R"("model": "sphere", "material": 0)"), "there is no material 0");
  has(shape(R"("model": "sphere", "to_world": [1])"), "4 x 4");
  has(refused(R"({"lights": [{"model": "projection", "parameters": {"fov": 200}}]})"), "must be");
  has(refused(R"({"camera": {"fov": 200}})"), "below 180");
  has(refused(R"({"camera": {"fov": -1}})"), "above 0");
  has(refused(R"({"film": {"resolution": [0, 1]}})"), "from 1 to 65536");
  has(refused(R"({"edits": [{"kind": "material", "which": 3}]})"), "there is no material 3");
  has(refused(R"({"lihgts": []})"), "\"lights\"?");
  has(refused("{"), "no JSON");
  EXPECT_EQ(ajar_node_check("material", R"({"model": "diffuse"})"), AJAR_OK);
  complaint(ajar_node_check("material", R"({"model": "difuse"})"), AJAR_SCENE);
  complaint(ajar_node_check("thing", "{}"), AJAR_USAGE);
}

}  // namespace
