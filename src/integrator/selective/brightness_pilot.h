#pragma once
#include <memory>
#include <vector>

#include "integrator/preparation_stage.h"
#include "integrator/sample_block.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Brightness of the picture from a few samples, none of which stay: for the importance map, and
/// for the scale of thresholds.
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
  /// RGB of the layer "direct" or "indirect".
  std::vector<float> colors(const char* layer) const;

  const SelectivePreparation& prepared_;
  std::unique_ptr<Integrator> omc_;
  std::unique_ptr<Film> film_;
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
