#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "mcmc/primary/chain_source.h"

namespace ajar {

/// Serves the numbers of one of several proposals of a step (`ChainSettings::tries`). Scratch
/// memory of one thread.
class TrySource final : public SampleSource {
 public:
  /// `centre` must outlive this.
  TrySource(ChainSource& centre, const PrimaryShape& shape);

  /// The next try is the fresh vector named by `key`.
  void make_fresh(std::uint64_t key);
  /// The next try is one small step away from the proposal of `centre`, which it shares with other
  /// tries; `key` names the randomness of this step.
  void move_from_centre(const Change& change, std::uint64_t key);

  /// Use of the raster numbers by the try so far, and their values.
  bool uses_raster() const { return raster_use_.used(); }
  const Vec2& raster() const { return raster_; }

  float get(SampleAddress address) override {
    const Vec2 pair = get_pair(address);
    return (static_cast<unsigned>(address.slot()) & 1U) == 0 ? pair.x : pair.y;
  }
  Vec2 get_pair(SampleAddress address) override;

 private:
  Vec2 pair_at(SampleAddress address);

  ChainSource& centre_;
  bool fresh_ = true;
  Change change_;
  std::uint64_t key_ = 0;
  RasterUse raster_use_;
  Vec2 raster_{0.F, 0.F};
  std::uint64_t try_ = 0;            ///< number of the try
  std::vector<std::uint64_t> made_;  ///< for which try each block holds numbers
  std::vector<std::array<float, kBlockSize>> blocks_;
};

}  // namespace ajar
