#include "session/output/denoise_file.h"

#include <gtest/gtest.h>

#include <optional>

#include "core/error.h"

namespace ajar {
namespace {

/// Takes so many bytes for each pixel.
class Hungry final : public Denoiser {
 public:
  explicit Hungry(std::uint64_t bytes) : bytes_(bytes) {}
  std::string name() const override { return "hungry"; }
  std::uint64_t memory_bytes(std::uint64_t pixels) const override { return bytes_ * pixels; }
  Features prepare(Vec2i, Features features) const override { return features; }
  std::optional<std::vector<float>> filter(const NoisyPicture& picture, const Features&,
                                           const Progress&) const override {
    return std::vector<float>(picture.colour.begin(), picture.colour.end());
  }

 private:
  std::uint64_t bytes_;
};

Picture picture_with(const std::vector<std::string>& layers) {
  Picture picture;
  picture.resolution = {10, 5};
  picture.crop = Box2i(Vec2i(0, 0), Vec2i(9, 4));
  picture.layers.push_back({"", 3, std::vector<float>(150, 1.F)});
  for (const std::string& name : layers) {
    picture.layers.push_back({name, 3, std::vector<float>(150, 1.F)});
  }
  return picture;
}

const std::vector<std::string> kFourReplicates = {"replicates.0", "replicates.1", "replicates.2",
                                                  "replicates.3"};

TEST(DenoiseFile, NeedsMoreMemoryForMoreThatIsKnown) {
  const Hungry denoiser(1000);
  const std::uint64_t alone = denoising_bytes(picture_with({}), denoiser);
  EXPECT_GE(alone, 50U * (1000U + 2 * 12U));
  EXPECT_LT(alone, 50U * (1000U + 4 * 12U));
  const std::uint64_t with_features = denoising_bytes(picture_with({"albedo", "normal"}), denoiser);
  EXPECT_GT(with_features, alone);
  EXPECT_GT(denoising_bytes(picture_with(kFourReplicates), denoiser), with_features);
}

TEST(DenoiseFile, TakesTheBuiltinFilterWhereThatNeedsLess) {
  const Picture picture = picture_with({});
  const auto hungry = std::make_shared<const Hungry>(100000);
  const std::uint64_t needed = denoising_bytes(picture, *hungry);
  std::string note;
  EXPECT_EQ(fitting_denoiser(picture, hungry, true, 2 * needed, note), hungry);
  EXPECT_EQ(fitting_denoiser(picture, hungry, false, 0, note), hungry) << "nobody knows";
  EXPECT_EQ(note, "");
  EXPECT_EQ(fitting_denoiser(picture, hungry, true, needed / 2, note)->name(),
            find_denoiser("builtin")->name());
  EXPECT_NE(note.find("built-in filter"), std::string::npos) << note;
  EXPECT_THROW(fitting_denoiser(picture, hungry, false, needed / 2, note), UsageError);
  EXPECT_THROW(fitting_denoiser(picture, hungry, true, 100, note), UsageError);
}

}  // namespace
}  // namespace ajar
