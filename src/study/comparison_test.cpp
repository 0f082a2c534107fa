#include "study/comparison.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.h"
#include "imageio/image_file.h"
#include "study/comparison_output.h"

namespace ajar::study {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 40;
constexpr int kHeight = 24;
constexpr std::size_t kValues = 3 * kWidth * kHeight;

/// Replicates of a uniform picture with relative noise that all channels of a pixel share.
Replicates noisy(float mean, double noise, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(1.0, noise);
  Replicates replicates(4, std::vector<float>(kValues));
  for (auto& image : replicates) {
    for (std::size_t i = 0; i < kValues; i += 3) {
      const auto value = static_cast<float>(mean * normal(generator));
      for (std::size_t c = 0; c < 3; ++c) image[i + c] = value;
    }
  }
  return replicates;
}

enum class Layers { Replicates, StandardError, None };

LoadedPicture picture(const Replicates& replicates, Layers layers) {
  LoadedPicture result;
  result.path = "picture";
  result.size = {kWidth, kHeight};
  result.linear = replicate_mean(replicates);
  if (layers == Layers::Replicates) result.replicates = replicates;
  if (layers == Layers::StandardError) result.standard_error = standard_error(replicates);
  return result;
}

TEST(BiasTest, IsNotMadeWithoutErrors) {
  const Replicates replicates = noisy(1.F, 0.2, 1);
  EXPECT_FALSE(
      test_bias(picture(replicates, Layers::None), picture(replicates, Layers::Replicates)));
}

TEST(BiasTest, AcceptsEqualPicturesAndHasItsStatedPower) {
  // Each kind of error, 40 trials of two equal pictures at level 2·10⁻³: more than one alarm has a
  // probability of 0.3 %. Then the smallest difference of the mean that is promised to be found in
  // 90 % of cases: at least 26 of 40 (binomial: mean 36, σ 1.9).
  for (const Layers layers : {Layers::Replicates, Layers::StandardError}) {
    int alarms = 0;
    int found = 0;
    for (unsigned trial = 0; trial < 40; ++trial) {
      const LoadedPicture reference = picture(noisy(1.F, 0.2, 3 * trial), layers);
      const auto equal = test_bias(picture(noisy(1.F, 0.2, 3 * trial + 1), layers), reference);
      ASSERT_TRUE(equal);
      alarms += equal->differs ? 1 : 0;
      const auto brighter = static_cast<float>(1.0 + equal->detectable_mean);
      const auto wrong = test_bias(picture(noisy(brighter, 0.2, 3 * trial + 2), layers), reference);
      found += wrong->differs ? 1 : 0;
    }
    EXPECT_LE(alarms, 1) << to_string(
        test_bias(picture(noisy(1.F, 0.2, 0), layers), picture(noisy(1.F, 0.2, 1), layers))
            ->picture);
    EXPECT_GE(found, 26);
  }
}

TEST(BiasTest, TakesAReferenceWithoutErrorsAsExact) {
  const LoadedPicture exact = picture(noisy(1.F, 0.0, 0), Layers::None);
  const auto equal = test_bias(picture(noisy(1.F, 0.2, 5), Layers::Replicates), exact);
  ASSERT_TRUE(equal);
  EXPECT_EQ(equal->reference, ErrorSource::None);
  EXPECT_FALSE(equal->differs);
  EXPECT_TRUE(test_bias(picture(noisy(1.3F, 0.2, 6), Layers::StandardError), exact)->differs);
}

TEST(Metrics, HaveDistinctNamesAndUnknownOnesAreRefused) {
  EXPECT_EQ(metrics_by_name({}).size(), metrics().size());
  const auto two = metrics_by_name({"flip", "mse"});
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0]->name, "mse") << "in the order of tables";
  try {
    metrics_by_name({"rmsse"});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("\"rmse\""), std::string::npos) << error.what();
  }
}

TEST(AlignedTable, PadsEveryCell) {
  EXPECT_EQ(aligned_table({{"name", "x"}, {"a", "12.5"}}), "name     x\na     12.5\n");
}

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("ajar-comparison-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const Box2i& crop) const {
    const std::vector<float> pixels(3 * 16, 0.5F);
    std::string path = (folder_ / name).string();
    write_image(path, {{16, 16}, crop, {{"", 3, pixels}, {"replicates.0", 3, pixels}}, {}});
    return path;
  }
  fs::path folder_;
};

TEST_F(Files, NamesOfAnyBytesMakeValidJsonAndHarmlessTables) {
  const Box2i whole(Vec2i(0, 0), Vec2i(3, 3));
  const std::string odd = write("caf\xe9\x1b[31m\n.pfm", whole);
  Comparison comparison = compare_files(odd, {odd}, metrics_by_name({"mse"}), 67.0);
  comparison.warnings.push_back(odd);
  const auto json = to_json(comparison);
  EXPECT_NE(json.dump().find("caf\xef\xbf\xbd"), std::string::npos);
  EXPECT_EQ(json.at("warnings").back(), json.at("reference"));
  const std::string text = to_text(comparison);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("caf\\xe9\\x1b[31m\\n.pfm\n"), std::string::npos) << text;
}

TEST_F(Files, OtherPartsOfAPictureAreNotCompared) {
  const std::string left = write("left.exr", {{0, 0}, {3, 3}});
  const std::string right = write("right.exr", {{4, 0}, {7, 3}});
  const std::string anywhere = write("anywhere.pfm", {{4, 0}, {7, 3}});
  EXPECT_THROW(compare_files(left, {right}, metrics_by_name({"mse"}), 67.0), UsageError);
  const Comparison comparison =
      compare_files(left, {anywhere}, metrics_by_name({"ssim", "mse"}), 67);
  EXPECT_EQ(comparison.pictures.at(0).values.at(0), 0.0);
  EXPECT_FALSE(comparison.pictures.at(0).values.at(1)) << "smaller than a window";
  EXPECT_NE(to_text(comparison).find(" -  structural"), std::string::npos) << to_text(comparison);
}

TEST_F(Files, ASingleReplicateIsNoError) {
  const std::string path = write("left.exr", {{0, 0}, {3, 3}});
  EXPECT_EQ(load_picture(path).replicates.size(), 1U);
  EXPECT_FALSE(compare_files(path, {path}, metrics_by_name({"mse"}), 67.0).pictures.at(0).bias);
}

}  // namespace
}  // namespace ajar::study
