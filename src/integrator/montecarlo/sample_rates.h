#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/archive_forward.h"
#include "core/spectrum.h"
#include "core/vector.h"
#include "image/pixel_at.h"

namespace ajar {

/// Distribution of camera samples over pixels: one per pixel and sample of the picture on average,
/// more where there is more noise. A pixel's rate r is its mean number of samples, and each weighs
/// 1/r, so that every sample of the picture covers the whole of it. The rates may depend on samples
/// that are kept, and change between passes, without bias.
///
/// In each replicate a pixel has k · r samples after k, rounded up or down: the start of the count
/// is random, so that this is right on average. That alone would be noise of up to one sample, and
/// seen where there is no other. So there is a control variate m: it is put into the picture once
/// per sample of it, and camera samples contribute their value less m, each times 1/r. No m changes
/// the expectation.
class SampleRates {
 public:
  /// One each for all pixels of `crop`, until `adjust`. `replicates`: at least one.
  SampleRates(const Box2i& crop, int replicates, std::uint64_t seed);

  /// Camera samples `first` to `last` of those that a pixel has in a replicate.
  struct Batch {
    std::uint64_t first;
    std::uint64_t last;  ///< not one of them any more
    float weight;        ///< 1/r
  };
  /// Camera samples of number `round` of the picture's samples in a replicate; not before the last
  /// `adjust`.
  Batch batch(Vec2i pixel, std::uint64_t replicate, std::uint64_t round) const;
  /// Weight of light subpaths, traced along with all camera samples, that may land anywhere.
  float light_weight() const { return light_weight_; }

  /// Control variate: the estimated light of a pixel's camera samples.
  struct Guess {
    Spectrum direct;
    Spectrum indirect;
  };
  Guess guess(Vec2i pixel) const;
  /// Control variates of all pixels: 3 floats each, row by row; empty if black.
  struct Guesses {
    std::vector<float> direct;
    std::vector<float> indirect;
  };

  /// Minimises the visible error (visible_error.h) over camera samples. `variance`: of the mean of
  /// the first `samples` samples of the picture (a multiple of the number of replicates, no fewer
  /// than before), pixel by pixel, row by row.
  void adjust(std::span<const double> variance, Guesses guesses, std::uint64_t samples);

  std::uint64_t memory_bytes() const;
  void save_state(OutputArchive& archive) const;
  /// Raises a std::exception if that cannot be after `samples` samples of the picture.
  void load_state(InputArchive& archive, std::uint64_t samples);

 private:
  /// Pixels of one rate.
  struct Cell {
    double before = 0.0;   ///< camera samples per pixel and replicate until `since_`
    double inverse = 0.0;  ///< sum of 1/r over the picture's samples in a replicate until then
    double rate = 1.0;     ///< since then
  };
  std::size_t cell_of(Vec2i pixel) const;
  /// In 0..1: initial fraction of a pixel's first camera sample.
  double start_of(Vec2i pixel, std::uint64_t replicate) const;
  double upto(const Cell& cell, std::uint64_t round) const {
    return cell.before + cell.rate * static_cast<double>(round - since_);
  }
  /// Mean over the pixels of each cell.
  std::vector<double> means(const std::vector<double>& pixels) const;
  std::vector<double> with_neighbours(const std::vector<double>& cells) const;
  double mean(const std::vector<double>& cells) const;

  Box2i crop_;
  Vec2i cells_;  ///< across and down
  std::uint64_t replicates_;
  std::uint64_t since_ = 0;  ///< the picture's samples in a replicate
  float light_weight_ = 1.F;
  std::vector<Cell> grid_;
  std::vector<double> pixels_;  ///< pixels of each cell
  std::vector<float> starts_;   ///< start of each pixel, row by row, in the first replicate
  Guesses guesses_;
};

}  // namespace ajar
