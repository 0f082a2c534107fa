#pragma once
#include <memory>
#include <vector>

#include "integrator/preparation_stage.h"
#include "integrator/sample_block.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Brightness of the picture from a few samples, none of which stay: for the importance map, and
/// for the scale of thresholds. The picture is cut into squares, of which each has a sample: as
/// many tell enough of a large picture as of a small one.
class BrightnessPilot final : public PreparationStage {
 public:
  struct Result {
    double brightness = 0.0;
    ImportanceMap importance;  ///< importance of the configuration, or relative to the brightness
    PictureScale scale;
    std::vector<float> first_look;  ///< RGB, row by row of the crop
  };

  explicit BrightnessPilot(const SelectivePreparation& prepared);
  double effort() const override;
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  /// After `end`.
  Result take() { return std::move(result_); }

 private:
  class Sink;
  /// Light that fell into a square.
  struct Splat {
    std::size_t square;
    Spectrum value;
  };
  /// Samples of an item: every so many of the squares, so that they are all over the picture.
  struct Found {
    std::vector<Splat> camera;
    std::vector<Splat> light;
    double largest_lanes = 0.0;
  };
  std::uint64_t squares() const {
    return static_cast<std::uint64_t>(count_.x) * static_cast<std::uint64_t>(count_.y);
  }
  Vec2i square_at(const Vec2& raster) const;
  /// Pixels of the crop in a square.
  Box2i pixels_of(Vec2i square) const;
  PictureScale scale() const;
  /// Mean of each square.
  std::vector<Spectrum> mean_light() const;

  const SelectivePreparation& prepared_;
  int side_;  ///< pixels
  Vec2i count_;
  PathSamplerSettings sampler_;
  std::vector<Found> found_;  ///< item by item
  Result result_;
};

/// Brightness of a picture that `BrightnessPilot` has found black: of the samples that chains of
/// explicit paths start from, manifold connections among them, which find what camera samples miss.
class DarkPilot final : public PreparationStage {
 public:
  explicit DarkPilot(const SelectivePreparation& prepared) : prepared_(prepared) {}
  double effort() const override { return 0.0; }
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  /// After `end`; 0 if it has found no light either, or was not needed.
  double brightness() const { return brightness_; }

 private:
  const SelectivePreparation& prepared_;
  std::vector<SampleBlock> blocks_;
  std::vector<std::vector<double>> weights_;  ///< I of the samples of each group
  double brightness_ = 0.0;
};

}  // namespace ajar
