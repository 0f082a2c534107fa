#include "session/output/output.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "image/identities.h"
#include "imageio/image_file.h"
#include "session/testing/test_integrator.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

const Vec2i kOutputSize(4, 3);

/// A folder of its own that is gone after the test; the current folder meanwhile.
class OutputTest : public ::testing::Test {
 protected:
  void SetUp() override {
    previous_ = fs::current_path();
    folder_ = fs::temp_directory_path() / ("ajar-output-test-" + std::to_string(getpid()));
    fs::create_directories(folder_);
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(previous_);
    fs::remove_all(folder_);
  }
  fs::path previous_, folder_;
};

Film rendered_film(TestIntegrator& integrator, std::uint64_t samples) {
  Film film(kOutputSize, Box2i(Vec2i(0, 0), kOutputSize - Vec2i(1, 1)), Filter::box(), 4,
            integrator.layers());
  Counters counters;
  for (std::uint64_t i = 0; i < integrator.items_in_round(); ++i) {
    integrator.run_item(i, 0, samples, film, counters);
  }
  return film;
}

TEST_F(OutputTest, PictureIsTheMeanOfSamplesTimesTheFilmScale) {
  TestIntegrator integrator(kOutputSize, 4);
  const Film film = rendered_film(integrator, 8);
  const Picture picture = develop(film, integrator, 8, 3.0, {"samples", "standard-error"});
  double mean = 0.25;
  for (std::uint64_t i = 0; i < 8; ++i) mean += TestIntegrator::value(5, i) / 8.0;
  ASSERT_EQ(picture.layers.size(), 5U);
  EXPECT_EQ(picture.layers[0].name, "");
  EXPECT_NEAR(picture.layers[0].pixels.at(15), 3.0 * mean, 1e-5);
  EXPECT_EQ(picture.layers[1].name, "direct");
  EXPECT_NEAR(picture.layers[1].pixels.at(15), 3.0 * (mean - 0.25), 1e-5);
  EXPECT_EQ(picture.layers[3].name, "samples");
  EXPECT_EQ(picture.layers[3].pixels, std::vector<float>(12, 8.F));
}

TEST_F(OutputTest, PartsOfALayerAreShownInItAndInThePicture) {
  TestIntegrator integrator(kOutputSize, 4);
  integrator.has_part = true;
  const Film film = rendered_film(integrator, 8);
  const Picture picture = develop(film, integrator, 8, 1.0, {"standard-error"});
  ASSERT_EQ(picture.layers.size(), 4U);
  EXPECT_EQ(picture.layers[2].name, "indirect");
  EXPECT_NEAR(picture.layers[2].pixels.at(15), 0.75F, 1e-5);
  EXPECT_NEAR(picture.layers[0].pixels.at(15), picture.layers[1].pixels.at(15) + 0.75F, 1e-5);
}

/// Mean of one pixel, in the samples of the picture `first`, `first + step`, …
double mean_seen(const TestIntegrator& integrator, std::uint64_t pixel, std::uint64_t first,
                 std::uint64_t step, std::uint64_t samples) {
  double sum = 0.0;
  std::uint64_t count = 0;
  for (std::uint64_t i = first; i < samples; i += step) {
    for (std::uint64_t k = 0; k < integrator.camera_samples(pixel); ++k, ++count) {
      sum += TestIntegrator::value(pixel, i + 1000 * k);
    }
  }
  return sum / static_cast<double>(count);
}

TEST_F(OutputTest, PixelsOfUnevenNumbersOfSamplesAreMeansOfTheirOwn) {
  TestIntegrator integrator(kOutputSize, 4);
  integrator.uneven = true;
  const Film film = rendered_film(integrator, 8);
  const Picture picture = develop(film, integrator, 8, 3.0, {"standard-error", "replicates"});
  ASSERT_EQ(picture.layers.size(), 9U);
  EXPECT_EQ(picture.layers[3].name, "albedo");
  EXPECT_EQ(picture.layers[4].name, "standard-error");
  for (std::uint64_t pixel = 0; pixel < 12; ++pixel) {
    const double mean = mean_seen(integrator, pixel, 0, 1, 8);
    EXPECT_NEAR(picture.layers[0].pixels[3 * pixel], 3.0 * (mean + 0.25), 1e-5);
    EXPECT_NEAR(picture.layers[1].pixels[3 * pixel], 3.0 * mean, 1e-5);
    EXPECT_EQ(picture.layers[2].pixels[3 * pixel], 0.75F) << "a layer with one factor for all";
    EXPECT_NEAR(picture.layers[3].pixels[3 * pixel], mean, 1e-5) << "has no replicates";
    double squares = 0.0;
    for (std::uint64_t r = 0; r < 4; ++r) {
      const double own = mean_seen(integrator, pixel, r, 4, 8);
      EXPECT_NEAR(picture.layers[5 + r].pixels[3 * pixel], 3.0 * (own + 0.25), 1e-5);
      squares += 9.0 * (own - mean) * (own - mean);
    }
    EXPECT_NEAR(picture.layers[4].pixels[3 * pixel], std::sqrt(squares / 12.0), 1e-5);
  }
  EXPECT_GT(estimate_error(film, integrator, 8).value().value, 0.0);
}

TEST_F(OutputTest, IdentifiersAreMajoritiesAndOneLayerWhateverTheFilmKeeps) {
  TestIntegrator integrator(kOutputSize, 4);
  std::vector<LayerSpec> specs = integrator.layers();
  for (LayerSpec& spec : IdentityLayers::specs("object-id")) specs.push_back(std::move(spec));
  Film film(kOutputSize, Box2i(Vec2i(0, 0), kOutputSize - Vec2i(1, 1)), Filter::box(), 4, specs);
  const IdentityLayers identities(film, "object-id");
  const std::array<std::uint32_t, 4> seen = {7, 3, 0, 3};
  for (std::uint64_t i = 0; i < seen.size(); ++i) identities.add(film, {1, 2}, i, seen[i]);
  const Picture picture = develop(film, integrator, 4, 5.0, {});
  ASSERT_EQ(picture.layers.size(), 4U);
  EXPECT_EQ(picture.layers[3].name, "object-id");
  EXPECT_EQ(picture.layers[3].channels, 1);
  std::vector<float> expected(12, 0.F);
  expected[9] = 3.F;
  EXPECT_EQ(picture.layers[3].pixels, expected) << "neither film scale nor samples count";
}

TEST_F(OutputTest, StandardErrorComesFromTheReplicates) {
  TestIntegrator integrator(kOutputSize, 4);
  const Film film = rendered_film(integrator, 4);
  const Picture picture = develop(film, integrator, 4, 1.0, {"standard-error"});
  double mean = 0.0;
  double squares = 0.0;
  for (std::uint64_t i = 0; i < 4; ++i) mean += TestIntegrator::value(2, i) / 4.0;
  for (std::uint64_t i = 0; i < 4; ++i) squares += std::pow(TestIntegrator::value(2, i) - mean, 2);
  ASSERT_EQ(picture.layers.back().name, "standard-error");
  EXPECT_NEAR(picture.layers.back().pixels.at(6), std::sqrt(squares / 12.0), 1e-5);
  EXPECT_GT(estimate_error(film, integrator, 4).value().value, 0.0);
}

TEST_F(OutputTest, ReplicatesAverageToThePicture) {
  TestIntegrator integrator(kOutputSize, 4);
  const Film film = rendered_film(integrator, 8);
  const Picture picture = develop(film, integrator, 8, 3.0, {"replicates"});
  ASSERT_EQ(picture.layers.size(), 3U + 4U);
  EXPECT_EQ(picture.layers[6].name, "replicates.3");
  for (std::size_t i = 0; i < 36; ++i) {
    double mean = 0.0;
    for (std::size_t r = 3; r < 7; ++r) mean += picture.layers[r].pixels.at(i) / 4.0;
    EXPECT_NEAR(mean, picture.layers[0].pixels.at(i), 1e-5);
  }
}

TEST_F(OutputTest, DefaultsAreInTheCurrentFolder) {
  EXPECT_EQ(default_outputs("renders/far/away.png", "room"),
            (std::vector<std::string>{"away.exr", "away.png"}));
  EXPECT_EQ(default_outputs("", "room"), (std::vector<std::string>{"room.exr", "room.png"}));
}

TEST_F(OutputTest, ImpossiblePathsAreFoundBeforeRendering) {
  EXPECT_NO_THROW(check_picture_paths({"a.exr", "b.png", "c.pfm", "d.hdr", "e.jpg"}));
  EXPECT_TRUE(fs::is_empty(folder_)) << "the check leaves nothing behind";
  EXPECT_THROW(check_picture_paths({"a.exe"}), UsageError);
  EXPECT_THROW(check_picture_paths({"no/such/folder/a.exr"}), IoError);
  fs::create_directory("folder.exr");
  EXPECT_THROW(check_picture_paths({"folder.exr"}), IoError);
}

TEST_F(OutputTest, NamesTooLongForTheFolderAreFoundBeforeRendering) {
  EXPECT_NO_THROW(check_writable(std::string(255, 'n')));
  EXPECT_THROW(check_writable(std::string(256, 'n')), IoError);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(OutputTest, WritesWhatWasAskedFor) {
  TestIntegrator integrator(kOutputSize, 4);
  const Picture picture = develop(rendered_film(integrator, 4), integrator, 4, 1.0, {});
  const auto files = write_final_files(picture_files(picture, {"a.exr", "a.png"}, {}), nullptr);
  ASSERT_EQ(files.size(), 2U);
  for (const WrittenFile& file : files) {
    EXPECT_EQ(file.error, "");
    EXPECT_TRUE(fs::exists(file.path));
  }
  const Image image = read_image("a.exr");
  EXPECT_EQ(image.width, 4);
  EXPECT_EQ(image.rgb(), picture.layers[0].pixels);
}

TEST_F(OutputTest, APictureThatCannotBeWrittenIsRescued) {
  TestIntegrator integrator(kOutputSize, 4);
  const Picture picture = develop(rendered_film(integrator, 4), integrator, 4, 1.0, {});
  // The folder vanishes while the render runs.
  const auto files = write_final_files(picture_files(picture, {"gone/a.exr"}, {}), nullptr);
  ASSERT_EQ(files.size(), 1U);
  EXPECT_NE(files[0].error, "");
  EXPECT_NE(files[0].path, "gone/a.exr");
  ASSERT_FALSE(files[0].path.empty());
  EXPECT_EQ(read_image(files[0].path).rgb(), picture.layers[0].pixels);
}

}  // namespace
}  // namespace ajar
