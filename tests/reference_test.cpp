#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

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

constexpr int kBlock = 16;

/// Blocks of both pictures, compared by luminance-like means. Pixels err independently in both
/// (path tracing, box filter), so the error of a block's difference is known from the spread of the
/// difference within the block: fireflies of either picture count, a deviation of the whole block
/// does not hide.
struct BlockTest {
  double worst_z = 0.0;
  Vec2i worst{0, 0};
  int blocks = 0;
  double median_relative_error =
      0.0;  ///< standard error of a block's difference over the block's mean
};

BlockTest compare(const std::vector<float>& a, const std::vector<float>& b, int width, int height) {
  BlockTest test;
  std::vector<double> relative_errors;
  for (int y0 = 0; y0 + kBlock <= height; y0 += kBlock) {
    for (int x0 = 0; x0 + kBlock <= width; x0 += kBlock) {
      double sum = 0.0;
      double squares = 0.0;
      double level = 0.0;
      for (int y = y0; y < y0 + kBlock; ++y) {
        for (int x = x0; x < x0 + kBlock; ++x) {
          const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x));
          const double reference = (b[i] + b[i + 1] + b[i + 2]) / 3.0;
          const double difference = (a[i] + a[i + 1] + a[i + 2]) / 3.0 - reference;
          sum += difference;
          squares += difference * difference;
          level += reference;
        }
      }
      constexpr double kCount = kBlock * kBlock;
      const double mean = sum / kCount;
      // Half floats round by up to 2^-12 of the value, together in the same direction at worst.
      const double rounding = level / kCount * 0x1p-12;
      const double error =
          std::sqrt((squares / kCount - mean * mean) / (kCount - 1.0)) + rounding / 5.5;
      const double z = error > 0.0 ? std::abs(mean) / error : 0.0;
      if (z > test.worst_z) {
        test.worst_z = z;
        test.worst = {x0, y0};
      }
      ++test.blocks;
      if (level > 0.0) relative_errors.push_back(error / (level / kCount));
    }
  }
  std::sort(relative_errors.begin(), relative_errors.end());
  test.median_relative_error = relative_errors[relative_errors.size() / 2];
  return test;
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
    for (const std::string& message : warnings.messages()) {
      EXPECT_NE(message.find("triangles have no area"), std::string::npos) << message;
    }

    test::RenderOptions options;
    options.samples = 64;
    options.max_depth = reference.max_depth;
    const std::vector<float> ours = test::render(scene, options).image();
    const Image image = read_image((*shared / "references" / (reference.name + ".exr")).string());
    ASSERT_EQ(image.width, reference.resolution.x);
    ASSERT_EQ(image.height, reference.resolution.y);
    const std::vector<float> theirs = image.rgb();
    const double ratio = std::accumulate(ours.begin(), ours.end(), 0.0) /
                         std::accumulate(theirs.begin(), theirs.end(), 0.0);
    EXPECT_NEAR(ratio, 1.0, reference.tolerance) << reference.name;

    const BlockTest test = compare(ours, theirs, image.width, image.height);
    EXPECT_LT(test.worst_z, 5.5) << reference.name << ": block at " << test.worst.x << ", "
                                 << test.worst.y << " of " << test.blocks;
    // Power: half of the blocks would show a deviation of 6 %, however it arises.
    EXPECT_LT(5.5 * test.median_relative_error, 0.06) << reference.name;
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
