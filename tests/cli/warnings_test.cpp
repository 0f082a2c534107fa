#include <gtest/gtest.h>

#include <algorithm>

#include "cli_fixture.h"

/// Warnings on scenes with faults, as a lighting artist reads them.
namespace ajar {
namespace {

class FaultyScenes : public Cli {
 protected:
  static constexpr int kUnknown = 3000;
  static constexpr int kFlat = 300;
  static constexpr int kImages = 12;

  void SetUp() override {
    Cli::SetUp();
    std::string text = "Camera \"perspective\" \"float fov\" 40\nWorldBegin\n";
    for (int i = 0; i < kUnknown; ++i) {
      text += "Material \"matte\" \"float bogus" + std::to_string(i % 7) + "\" 1\n";
    }
    for (int i = 0; i < kFlat; ++i) {
      text +=
          "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 0 1 1 1 2] "
          "\"point P\" [0 0 5 1 0 5 0 1 5]\n";
    }
    for (int i = 0; i < kImages; ++i) {
      const std::string number = std::to_string(i);
      text += "Texture \"t" + number + "\" \"spectrum\" \"imagemap\" \"string filename\" \"wood" +
              number + ".png\"\n";
    }
    text +=
        "Material \"hair\"\nShape \"nurbs\"\n"
        "LightSource \"infinite\" \"string mapname\" \"sky.exr\"\nWorldEnd\n";
    file("scene.pbrt", text);
  }

  static std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }
};

constexpr std::size_t kAll = 3000 + 300 + 12 + 3;

TEST_F(FaultyScenes, AreReportedInTheOrderOfTheirEffect) {
  const Outcome outcome = run({"render", "scene.pbrt", "--spp", "1", "--resolution", "8x8",
                               "--integrator", "pt", "--progress", "none", "-o", "a.pfm"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.err);
  ASSERT_GE(lines.size(), 6U) << outcome.err;
  EXPECT_LE(lines.size(), 20U) << outcome.err;
  const std::vector<std::vector<std::string>> expected = {
      {"warning: scene.pbrt:3317:1: cannot read light map", "sky.exr", "the light is magenta"},
      {"warning: scene.pbrt:3316:1: nurbs are not supported: shape left out"},
      {"warning: scene.pbrt:3303:1: 12 textures cannot be read, shown as magenta: wood0.png, "
       "wood1.png, wood2.png, wood3.png, …"},
      {"warning: scene.pbrt:3315:1: material \"hair\" is not supported"},
      {"warning: scene.pbrt:3:18: 3000 parameters are unknown here and ignored: \"float bogus0\", "
       "\"float bogus1\""},
      {"without visible effect: scene.pbrt:3003:1: 600 triangles have no area and are left out, in "
       "300 meshes",
       "ajar info scene.pbrt lists all " + std::to_string(kAll) + " warnings"}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (const std::string& part : expected[i]) {
      EXPECT_TRUE(contains(lines[i], part)) << part << "\n" << lines[i];
    }
  }
}

TEST_F(FaultyScenes, AreListedByInfoWithoutLeavingOutAny) {
  const Outcome text = run({"info", "scene.pbrt"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  const std::vector<std::string> lines = lines_of(text.err);
  EXPECT_EQ(lines.size(), kAll);
  EXPECT_TRUE(contains(lines.front(), "sky.exr")) << lines.front();
  EXPECT_TRUE(contains(lines.back(), "2 of 3 triangles have no area")) << lines.back();
  EXPECT_TRUE(contains(text.out,
                       "3315: 1 of light, 1 of geometry, 13 of surfaces, 3000 of slight effect, "
                       "300 of no visible effect"))
      << text.out;
  const json info = json::parse(run({"info", "scene.pbrt", "--json"}).out);
  EXPECT_EQ(info.at("warnings"), kAll);
  EXPECT_EQ(info.at("warning_messages").size(), kAll);
  std::size_t by_effect = 0;
  for (const auto& [effect, count] : info.at("warnings_by_effect").items()) {
    by_effect += count.get<std::size_t>();
  }
  EXPECT_EQ(by_effect, kAll);
}

TEST_F(FaultyScenes, HaveTheLargestEffectFirstInTheStatistics) {
  const Outcome outcome =
      run({"render", "scene.pbrt", "--spp", "1", "--resolution", "8x8", "--integrator", "pt",
           "--progress", "none", "-o", "a.pfm", "--stats", "stats.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json stats = statistics();
  EXPECT_EQ(stats.at("warnings"), kAll);
  const json& messages = stats.at("warning_messages");
  ASSERT_EQ(messages.size(), 200U);
  EXPECT_TRUE(contains(messages.at(0), "sky.exr"));
  EXPECT_TRUE(contains(messages.at(1), "nurbs"));
  EXPECT_TRUE(contains(messages.at(13), "wood11.png"));
  EXPECT_TRUE(contains(messages.at(14), "hair"));
  EXPECT_TRUE(contains(messages.at(15), "bogus0"));
}

TEST_F(Cli, AScenesNameIsOneWordOfTheCommandThatListsItsWarnings) {
  fs::create_directory(file("my scenes"));
  file("my scenes/it's.pbrt",
       "Camera \"perspective\" WorldBegin\nLightSource \"point\" \"float a\" 1 \"float b\" 2\n"
       "Shape \"sphere\" WorldEnd");
  const Outcome outcome = run({"convert", "my scenes/it's.pbrt", "b.pbrt"});
  EXPECT_TRUE(contains(outcome.err, "ajar info 'my scenes/it'\\''s.pbrt' lists all 2 warnings"))
      << outcome.err;
}

TEST_F(Cli, ASceneWithoutLightIsAWarning) {
  file("dark.pbrt", "Camera \"perspective\" WorldBegin Shape \"sphere\" WorldEnd");
  const Outcome outcome = run({"info", "dark.pbrt"});
  EXPECT_TRUE(contains(outcome.err, "there is no light in this scene: its picture is black"))
      << outcome.err;
}

TEST_F(Cli, NotesNameTheDifficultiesOfAPicture) {
  const auto notes_of = [&](const std::string& scene) {
    return run({"render", "builtin:" + scene, "--spp", "4", "--resolution", "96x72", "--progress",
                "none", "-o", "a.pfm"})
        .err;
  };
  EXPECT_TRUE(contains(notes_of("cornell"), "ajar: no difficult light found: rendered by plain "));
  const std::string of_torus = notes_of("torus-in-glass");
  EXPECT_TRUE(contains(of_torus, "ajar: difficult light (caustics, light through gaps) in "))
      << of_torus;
  EXPECT_TRUE(contains(of_torus, " % of this picture: Markov chains make it, ")) << of_torus;
}

}  // namespace
}  // namespace ajar
