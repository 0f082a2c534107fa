#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "ajar/c.h"

// Arguments that a program in another language may pass by mistake.
namespace {

namespace fs = std::filesystem;

/// The functions of ajar/c.h and the names of their arguments.
std::map<std::string, std::vector<std::string>> functions_of_header() {
  std::ifstream file(fs::path(AJAR_SOURCE_DIR) / "include" / "ajar" / "c.h");
  std::stringstream text;
  text << file.rdbuf();
  static const std::regex kFunction(R"(AJAR_API\s[^;(]*?\b(ajar_\w+)\(([^)]*)\);)");
  static const std::regex kArgument(R"((\w+)\s*(,|$))");
  const std::string header = text.str();
  std::map<std::string, std::vector<std::string>> functions;
  for (std::sregex_iterator found(header.begin(), header.end(), kFunction), end; found != end;
       ++found) {
    const std::string arguments = (*found)[2];
    std::vector<std::string>& names = functions[(*found)[1]];
    if (arguments == "void") continue;
    for (std::sregex_iterator name(arguments.begin(), arguments.end(), kArgument);
         name != std::sregex_iterator(); ++name) {
      names.push_back((*name)[1]);
    }
  }
  return functions;
}

/// Calls functions with each of their pointers as NULL, one after the other.
class NullCaller {
 public:
  /// `optional`: arguments that may be NULL.
  template <typename Result, typename... Arguments>
  void call(const std::string& name, Result (*function)(Arguments...),
            const std::set<std::string>& optional, std::type_identity_t<Arguments>... good) {
    called_.insert(name);
    ASSERT_TRUE(functions_.contains(name)) << name;
    const std::vector<std::string>& names = functions_.at(name);
    ASSERT_EQ(names.size(), sizeof...(Arguments)) << name;
    const std::tuple<Arguments...> all(good...);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (call_without<I>(name, function, all, optional.contains(names[I]), names[I]), ...);
    }
    (std::index_sequence_for<Arguments...>());
  }

  const std::set<std::string>& called() const { return called_; }
  const std::map<std::string, std::vector<std::string>>& functions() const { return functions_; }

 private:
  template <std::size_t I, typename Function, typename Tuple>
  static void call_without(const std::string& name, Function function, Tuple arguments,
                           bool is_optional, const std::string& argument) {
    if constexpr (std::is_pointer_v<std::tuple_element_t<I, Tuple>>) {
      std::get<I>(arguments) = nullptr;
      if (is_optional) return;
      const int result = std::apply(function, arguments);
      const bool tells_size = name == "ajar_picture_width" || name == "ajar_picture_height";
      EXPECT_EQ(result, tells_size ? 0 : AJAR_USAGE) << name << " without " << argument;
      EXPECT_EQ(std::string(ajar_last_error()), argument + " is NULL") << name;
    }
  }

  std::map<std::string, std::vector<std::string>> functions_ = functions_of_header();
  std::set<std::string> called_;
};

using SceneHandle = std::unique_ptr<ajar_scene, decltype(&ajar_scene_free)>;
using RenderHandle = std::unique_ptr<ajar_render, decltype(&ajar_render_free)>;
using PictureHandle = std::unique_ptr<ajar_picture, decltype(&ajar_picture_free)>;

SceneHandle cornell() {
  ajar_scene* scene = nullptr;
  EXPECT_EQ(ajar_scene_load("builtin:cornell", &scene), AJAR_OK) << ajar_last_error();
  return {scene, ajar_scene_free};
}

RenderHandle begun(const SceneHandle& scene, const std::string& settings) {
  ajar_render* render = nullptr;
  EXPECT_EQ(ajar_render_start(scene.get(), settings.c_str(), &render), AJAR_OK)
      << ajar_last_error();
  return {render, ajar_render_free};
}

const std::string kTiny = R"({"integrator": "pt", "resolution": [4, 3], "samples_per_pixel": 4})";

PictureHandle tiny_picture(const SceneHandle& scene) {
  const RenderHandle render = begun(scene, kTiny);
  EXPECT_EQ(ajar_render_wait(render.get(), -1.0, nullptr), AJAR_OK) << ajar_last_error();
  ajar_picture* picture = nullptr;
  EXPECT_EQ(ajar_render_picture(render.get(), &picture), AJAR_OK) << ajar_last_error();
  return {picture, ajar_picture_free};
}

TEST(CFaceRefuses, NullOfEveryFunction) {
  const SceneHandle scene = cornell();
  const RenderHandle render = begun(scene, kTiny);
  const PictureHandle picture = tiny_picture(scene);
  char* text = nullptr;
  ajar_scene* new_scene = nullptr;
  ajar_render* new_render = nullptr;
  ajar_picture* new_picture = nullptr;
  int number = 0;
  const float* pixels = nullptr;
  const ajar_array array{&number, AJAR_UINT8, 1, {1, 1, 1}};
  const std::string path = (fs::temp_directory_path() / "ajar-never-written.exr").string();
  NullCaller caller;
  caller.call("ajar_catalog", ajar_catalog, {}, "scenes", &text);
  caller.call("ajar_node_check", ajar_node_check, {}, "shape", "{}");
  caller.call("ajar_scene_load", ajar_scene_load, {}, "builtin:cornell", &new_scene);
  caller.call("ajar_scene_change", ajar_scene_change, {"base"}, scene.get(), "{}", &array, 1,
              &new_scene);
  caller.call("ajar_scene_information", ajar_scene_information, {}, scene.get(), &text);
  caller.call("ajar_scene_parts", ajar_scene_parts, {}, scene.get(), &text);
  caller.call("ajar_render_start", ajar_render_start, {"settings"}, scene.get(), kTiny.c_str(),
              &new_render);
  caller.call("ajar_render_wait", ajar_render_wait, {"done"}, render.get(), -1.0, &number);
  caller.call("ajar_render_stop", ajar_render_stop, {}, render.get());
  caller.call("ajar_render_picture", ajar_render_picture, {}, render.get(), &new_picture);
  caller.call("ajar_render_progress", ajar_render_progress, {}, render.get(), &text);
  caller.call("ajar_render_statistics", ajar_render_statistics, {}, render.get(), &text);
  caller.call("ajar_render_messages", ajar_render_messages, {}, render.get(), &text);
  caller.call("ajar_picture_width", ajar_picture_width, {}, picture.get());
  caller.call("ajar_picture_height", ajar_picture_height, {}, picture.get());
  caller.call("ajar_picture_layers", ajar_picture_layers, {}, picture.get(), &text);
  caller.call("ajar_picture_pixels", ajar_picture_pixels, {}, picture.get(), "", &number, &pixels);
  caller.call("ajar_picture_metadata", ajar_picture_metadata, {}, picture.get(), &text);
  caller.call("ajar_picture_save", ajar_picture_save, {"display"}, picture.get(), path.c_str(),
              "{}");
  caller.call("ajar_picture_load", ajar_picture_load, {}, path.c_str(), &new_picture);
  caller.call("ajar_compare", ajar_compare, {}, R"({"reference": "a", "pictures": ["b"]})", &text);

  EXPECT_EQ(text, nullptr);
  EXPECT_EQ(new_scene, nullptr);
  EXPECT_EQ(new_render, nullptr);
  EXPECT_EQ(new_picture, nullptr);
  // These free what they are given, or take no pointers.
  std::set<std::string> rest = {"ajar_text_free",    "ajar_scene_free", "ajar_render_free",
                                "ajar_picture_free", "ajar_last_error", "ajar_version",
                                "ajar_c_version"};
  ajar_text_free(nullptr);
  ajar_scene_free(nullptr);
  ajar_render_free(nullptr);
  ajar_picture_free(nullptr);
  for (const auto& [name, arguments] : caller.functions()) {
    EXPECT_TRUE(caller.called().contains(name) || rest.contains(name))
        << name << " of ajar/c.h is not tried here";
  }
}

/// Messages about settings that must be refused.
std::string complaint_about(const std::string& settings) {
  static const SceneHandle kScene = cornell();
  ajar_render* render = nullptr;
  const int code = ajar_render_start(kScene.get(), settings.c_str(), &render);
  EXPECT_EQ(code, AJAR_USAGE) << settings;
  EXPECT_EQ(render, nullptr);
  ajar_render_free(render);
  return code == AJAR_OK ? "" : ajar_last_error();
}

TEST(CFaceRefuses, NumbersBeyondTheBoundsOfTheCommandLine) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> settings = {
      {"threads", {"-1", "4097", "1000000", "1e6", "2147483648", "1e300", "0.5", "true", "\"2\""}},
      {"samples_per_pixel", {"0", "-1", "2147483649", "1.5", "1e30", "\"many\""}},
      {"seconds", {"0", "-1", "1e10", "1e300", "\"1\"", "[1]"}},
      {"target_error", {"0", "-0.1", "1.5", "{}"}},
      {"resolution", {"[0, 1]", "[1, 65537]", "[1]", "[1, 2, 3]", "[1.5, 2]", "5", "[1, null]"}},
      {"scale", {"0", "-1", "1e-6", "1e6", "\"2\""}},
      {"crop", {"[0, 0, 0, 1]", "[-1, 0, 4, 4]", "[0, 0, 4, 65537]", "[0, 0, 0.5, 0.5]", "[1]"}},
      {"min_depth", {"0", "1001", "-1", "1.5"}},
      {"max_depth", {"0", "1001", "1e9"}},
      {"seed", {"-1", "18446744073709551616", "0.5", "\"1\""}},
      {"checkpoint_every", {"0", "-1", "1e300", "\"1s\""}},
      {"checkpoint", {"5", "true", "[]", R"("a\u0000b")"}},
      {"denoise", {"5", "true", "\"yes\""}},
      {"resume", {"1", "\"yes\""}},
      {"denoised_target", {"1"}},
      {"integrator", {"5", "[]", "\"ptt\""}},
      {"filter", {"5", "\"round\"", "\"box:-1\"", "\"box:1000\"", "\"box:nan\""}},
      {"parameters", {"5", "[]", "\"a=b\""}},
      {"layers", {"\"depth\"", "[5]", "[\"deepth\"]"}}};
  for (const auto& [name, values] : settings) {
    for (const std::string& value : values) {
      std::string text = "{\"" + name + "\": ";
      text += value;
      const std::string said = complaint_about(text + "}");
      // Such messages name the value.
      const bool names_value = said.find('"') != std::string::npos;
      EXPECT_TRUE(said.starts_with(name) || names_value) << text << ": " << said;
    }
  }
  EXPECT_NE(complaint_about(R"({"threads": 1000000})").find("from 0 to 4096, not 1000000"),
            std::string::npos);
  EXPECT_NE(complaint_about(R"({"min_depth": 5, "max_depth": 3})").find("min_depth"),
            std::string::npos);
}

TEST(CFaceRefuses, TimesAndDisplaysThatAreNoNumbers) {
  const SceneHandle scene = cornell();
  const RenderHandle render = begun(scene, kTiny);
  EXPECT_EQ(ajar_render_wait(render.get(), std::nan(""), nullptr), AJAR_USAGE);
  EXPECT_EQ(ajar_render_wait(render.get(), std::numeric_limits<double>::infinity(), nullptr),
            AJAR_OK);
  const PictureHandle picture = tiny_picture(scene);
  const std::string path = (fs::temp_directory_path() / "ajar-never-written.png").string();
  for (const char* display :
       {R"({"exposure": 65})", R"({"exposure": -1e300})", R"({"exposure": "1"})",
        R"({"exposure": NaN})", R"({"tone_map": 5})", R"({"tone_map": "none"})", "5", "[]", ""}) {
    EXPECT_EQ(ajar_picture_save(picture.get(), path.c_str(), display), AJAR_USAGE) << display;
  }
  EXPECT_FALSE(fs::exists(path));
}

/// Arrays or objects in one another.
std::string nested(const std::string& open, const std::string& close, int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += open;
  for (int i = 0; i < depth; ++i) text += close;
  return text;
}

TEST(CFaceRefuses, JsonOfAnyDepth) {
  const SceneHandle scene = cornell();
  constexpr int kDepth = 200000;
  ajar_scene* new_scene = nullptr;
  char* text = nullptr;
  for (const std::string& deep : {nested("[", "]", kDepth), nested("{\"a\":[", "]}", kDepth),
                                  nested("[", "", kDepth), nested("{\"layers\":", "", kDepth)}) {
    for (const std::string& whole :
         {deep, "{\"layers\": " + deep + "}", "{\"parameters\": " + deep + "}"}) {
      complaint_about(whole);
      EXPECT_EQ(ajar_compare(whole.c_str(), &text), AJAR_USAGE);
      EXPECT_EQ(ajar_scene_change(scene.get(), whole.c_str(), nullptr, 0, &new_scene), AJAR_SCENE);
      EXPECT_EQ(ajar_node_check("material", whole.c_str()), AJAR_SCENE);
    }
  }
  EXPECT_NE(complaint_about(nested("[", "]", kDepth)).find("64 deep"), std::string::npos);
  // Deep, but not too deep, is told by what is wrong.
  EXPECT_NE(complaint_about("{\"layers\": " + nested("[", "]", 60) + "}").find("layers"),
            std::string::npos);
}

TEST(CFaceRefuses, ArraysThatCannotBe) {
  const std::vector<float> corners(9, 0.F);
  const std::uint32_t beyond[] = {0, 1, 2147483648U};
  const auto refused = [&](std::vector<ajar_array> arrays, int code) {
    ajar_scene* scene = nullptr;
    EXPECT_EQ(ajar_scene_change(nullptr,
                                R"({"shapes": [{"model": "mesh",
                                   "parameters": {"mesh": {"positions": 0, "indices": 1}}}]})",
                                arrays.data(), arrays.size(), &scene),
              code);
    EXPECT_EQ(scene, nullptr);
    ajar_scene_free(scene);
    return std::string(ajar_last_error());
  };
  const ajar_array positions{corners.data(), AJAR_FLOAT32, 2, {3, 3, 1}};
  const ajar_array indices{beyond, AJAR_UINT32, 2, {1, 3, 1}};
  const auto has = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(refused({positions, indices}, AJAR_SCENE), "refers to vertex 2147483648 of 3");
  has(refused({positions}, AJAR_SCENE),
      "mesh: indices: refers to number 1, but there are 1, counted from 0");
  has(refused({}, AJAR_SCENE), "mesh: positions: is array 0, but no arrays are given");
  has(refused({positions, {beyond, 7, 2, {1, 3, 1}}}, AJAR_USAGE), "arrays[1]");
  has(refused({positions, {beyond, AJAR_UINT32, 0, {1, 3, 1}}}, AJAR_USAGE), "arrays[1]");
  has(refused({positions, {beyond, AJAR_UINT32, -5, {1, 3, 1}}}, AJAR_USAGE), "arrays[1]");
  has(refused({positions, {nullptr, AJAR_UINT32, 2, {1, 3, 1}}}, AJAR_USAGE), "arrays[1]");
  has(refused({positions, {beyond, AJAR_UINT32, 2, {SIZE_MAX / 2, 3, 1}}}, AJAR_USAGE),
      "arrays[1]");
  has(refused({positions, {beyond, AJAR_UINT32, 3, {SIZE_MAX, SIZE_MAX, SIZE_MAX}}}, AJAR_USAGE),
      "arrays[1]");
}

TEST(CFace, SaysThatACheckpointCouldNotBeWritten) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const fs::path folder =
      fs::temp_directory_path() / ("ajar-c-troubles-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const fs::path before = fs::current_path();
  fs::current_path(folder);  // where it is rescued
  fs::create_symlink("/dev/full", folder / "room.checkpoint");
  const SceneHandle scene = cornell();
  nlohmann::json settings = nlohmann::json::parse(kTiny);
  settings["checkpoint"] = (folder / "room.checkpoint").string();
  const RenderHandle render = begun(scene, settings.dump());
  EXPECT_EQ(ajar_render_wait(render.get(), -1.0, nullptr), AJAR_OK) << ajar_last_error();
  char* text = nullptr;
  ASSERT_EQ(ajar_render_messages(render.get(), &text), AJAR_OK);
  const auto troubles = nlohmann::json::parse(text)["troubles"];
  ajar_text_free(text);
  ASSERT_EQ(troubles.size(), 1U);
  const std::string rescued =
      (folder / ("room-rescued-" + std::to_string(getpid()) + ".checkpoint")).string();
  const std::string said = troubles[0];
  EXPECT_NE(said.find("room.checkpoint\": No space left"), std::string::npos) << said;
  EXPECT_NE(said.find("the checkpoint is in " + rescued), std::string::npos) << said;
  EXPECT_TRUE(fs::exists(rescued));
  fs::current_path(before);
  fs::remove_all(folder);
}

}  // namespace
