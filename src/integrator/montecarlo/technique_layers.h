#pragma once
#include <string>
#include <vector>

#include "image/film.h"
#include "transport/path_sampler.h"

namespace ajar {

/// The pyramid of techniques (AOV "techniques"): for each technique a picture of its contribution
/// after MIS weighting, `techniques.weighted.sXtY`, which add up to the picture, and of its
/// unweighted estimate, `techniques.unweighted.sXtY`, which is right wherever the technique
/// reaches. Paths of up to `kMaxDepth` edges. Source: Veach 1997, figure 10.2.
class TechniqueLayers {
 public:
  static constexpr int kMaxDepth = 6;
  static const std::string& aov_name();
  static std::vector<LayerSpec> specs(const PathSamplerSettings& settings, double magnitude);

  explicit TechniqueLayers(const Film& film);
  bool empty() const { return layers_.empty(); }
  /// `weight`: the camera sample's filter weight. False if a value is too large to represent.
  bool add(Film& film, Vec2i pixel, float weight, const Contribution& contribution) const;

 private:
  struct Pair {
    int weighted = -1;
    int unweighted = -1;
  };
  static std::size_t slot(Technique technique);
  std::vector<Pair> layers_;  // indexed by `slot`; empty if the film has none of them
};

}  // namespace ajar
