#include "session/render/memory_estimate.h"

#include <gtest/gtest.h>

#include "image/filter.h"
#include "image/relative_error.h"
#include "session/job/resources.h"

namespace ajar {
namespace {

const Box2i kEstimatedCrop(Vec2i(10, 20), Vec2i(109, 69));  // 100 × 50

TEST(MemoryEstimate, OfAFilmIsWhatAFilmTakes) {
  const std::vector<LayerSpec> layers = {LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"},
                                         LayerSpec{.name = "albedo", .has_replicates = false}};
  const Film film(Vec2i(200, 100), kEstimatedCrop, Filter::box(), 4, layers);
  EXPECT_EQ(film_bytes(kEstimatedCrop, 4, layers), film.bytes());
  EXPECT_EQ(film.bytes(), 100U * 50U * 3U * 8U * 9U);
}

TEST(MemoryEstimate, OfPicturesCountsWhatIsShown) {
  const std::vector<LayerSpec> layers = {LayerSpec{.name = "direct"}, LayerSpec{.name = "indirect"},
                                         LayerSpec{.name = "weak", .part_of = "indirect"}};
  const std::uint64_t plain = picture_bytes(kEstimatedCrop, 4, layers, {});
  EXPECT_EQ(plain, 100U * 50U * error_estimate_bytes(4)) << "more than 12 · 3 · 3";
  EXPECT_EQ(picture_bytes(kEstimatedCrop, 4, layers, {"replicates", "samples"}),
            100U * 50U * 12U * 3U * 8U);
}

TEST(MemoryEstimate, ComplainsOnlyOfWhatIsNotThere) {
  const MemoryEstimate estimate{0, 3'000'000'000, 200'000'000, 0};
  EXPECT_EQ(memory_complaint(estimate, 0), "") << "unknown";
  EXPECT_EQ(memory_complaint(estimate, 3'500'000'000), "");
  const std::string complaint = memory_complaint(estimate, 3'300'000'000);
  EXPECT_NE(complaint.find("3.2 GB (film 3.0 GB, writing pictures 200 MB)"), std::string::npos)
      << complaint;
  EXPECT_NE(complaint.find("3.3 GB are free"), std::string::npos) << complaint;
}

TEST(MemoryEstimate, AvailableMemoryIsSomeButNotMoreThanThereIs) {
  const std::uint64_t available = available_memory_bytes();
  EXPECT_GT(available, 1'000'000U);
  // With swap there can be more than the machine's own.
  EXPECT_LT(available, 100 * physical_memory_bytes());
}

}  // namespace
}  // namespace ajar
