#include "measuring/bench_scenes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace ajar::bench {
namespace {

const std::vector<BenchScene> kScenes = {{"first", {}}, {"second", {}}, {"third", {}}};

TEST(BenchScenes, AreChosenByNameInTheOrderAsked) {
  const std::vector<BenchScene> chosen = choose_scenes(kScenes, {"third", "first"});
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen[0].name, "third");
  EXPECT_EQ(chosen[1].name, "first");
}

TEST(BenchScenes, FilesAreAccepted) {
  const std::filesystem::path file =
      std::filesystem::path(::testing::TempDir()) / "one_sphere_for_benches.pbrt";
  std::ofstream(file) << "Camera \"perspective\"\nWorldBegin\nShape \"sphere\"\nWorldEnd\n";
  const std::vector<BenchScene> chosen = choose_scenes(kScenes, {"second", file.string()});
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen[0].name, "second");
  EXPECT_EQ(chosen[1].name, "one_sphere_for_benches");
  Warnings warnings;
  EXPECT_EQ(chosen[1].load(warnings).shapes.size(), 1U);
  std::filesystem::remove(file);
}

TEST(BenchScenes, UnknownNamesAreRefused) {
  EXPECT_THROW(choose_scenes(kScenes, {"first", "secnd"}), UsageError);
}

TEST(BenchScenes, FitIntoTheLongerSide) {
  EXPECT_EQ(fitted_resolution({1280, 720}, 320), Vec2i(320, 180));
  EXPECT_EQ(fitted_resolution({500, 1000}, 256), Vec2i(128, 256));
  EXPECT_EQ(fitted_resolution({10000, 3}, 256), Vec2i(256, 1));
  EXPECT_EQ(scaled_resolution({640, 480}, 0.5), Vec2i(320, 240));
}

}  // namespace
}  // namespace ajar::bench
