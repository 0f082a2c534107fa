#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "image/compare_blocks.h"
#include "image/image_file.h"
#include "import/import.h"
#include "support/render.h"
#include "support/shared.h"

/// Scenes that others made, against pictures that another renderer made of them.
namespace ajar {
namespace {

struct Reference {
  std::string name;
  std::string scene;
  Vec2i resolution;
  int max_depth;
  double tolerance;
};

std::vector<Reference> references(const std::filesystem::path& shared) {
  std::ifstream file(shared / "references" / "index.json");
  std::vector<Reference> found;
  for (const auto& entry : nlohmann::json::parse(file)) {
    // Path tracing is only asked for where the index says that it converges.
    if (entry.at("converges_with") != "path") continue;
    const std::string size = entry.at("resolution");
    const auto times = size.find('x');
    found.push_back({entry.at("name"),
                     entry.at("scene"),
                     {std::stoi(size.substr(0, times)), std::stoi(size.substr(times + 1))},
                     entry.at("max_depth"),
                     entry.at("tolerance")});
  }
  return found;
}

class References : public ::testing::TestWithParam<const char*> {};

TEST_P(References, PathTracingAgreesInMeanAndInBlocks) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << test::kNoSharedFolder;
  for (const Reference& reference : references(*shared)) {
    if (reference.name != GetParam()) continue;
    Warnings warnings;
    desc::SceneDesc description =
        import_scene((*shared / "scenes" / reference.scene).string(), warnings);
    // The references were made with a box filter of one pixel.
    description.film.filter = {};
    const Scene scene(std::move(description), {.resolution = reference.resolution}, warnings);
    EXPECT_EQ(warnings.count(), 0U);

    test::RenderOptions options;
    options.samples = 64;
    options.replicates = 16;
    options.max_depth = reference.max_depth;
    const test::Render ours = test::render(scene, options);
    Replicates replicates;
    for (int r = 0; r < options.replicates; ++r) replicates.push_back(ours.replicate(r));

    const Image image =
        read_image((*shared / "references" / (reference.name + ".exr")).string());
    ASSERT_EQ(image.width, reference.resolution.x);
    ASSERT_EQ(image.height, reference.resolution.y);
    const std::vector<float> theirs = image.rgb();
    const double mean = std::accumulate(theirs.begin(), theirs.end(), 0.0);
    const double our_mean = image_mean(replicates).value * static_cast<double>(theirs.size());
    EXPECT_NEAR(our_mean / mean, 1.0, reference.tolerance) << reference.name;

    // The reference is path-traced too, with at least 256 samples per pixel: its variance is taken as ours at that count, doubled
    // for its plainer sampling, plus the rounding of half floats.
    const std::vector<float> error = standard_error(replicates);
    std::vector<float> variance(error.size());
    for (std::size_t i = 0; i < error.size(); ++i) {
      const float rounding = theirs[i] * 0x1p-12F;
      variance[i] = error[i] * error[i] * 2.F * static_cast<float>(options.samples) / 256.F +
                    rounding * rounding;
    }
    const BlockGrid grid{.width = image.width, .height = image.height, .channels = 3, .block = 16};
    const BlockComparison comparison =
        compare_blocks_to_reference(replicates, theirs, variance, grid);
    EXPECT_TRUE(comparison.equal()) << reference.name << ": worst block at " << comparison.worst_block.min.x
                                    << ", " << comparison.worst_block.min.y << ", z " << comparison.worst_z
                                    << ", difference " << comparison.worst_difference << ", mean z "
                                    << comparison.mean_z << ", relative "
                                    << comparison.mean_relative_difference;
    return;
  }
  FAIL() << "the index does not have " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Shared, References,
                         ::testing::Values("cornell-box", "veach-mis", "staircase2"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace ajar
