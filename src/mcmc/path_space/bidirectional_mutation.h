#pragma once
#include <vector>

#include "mcmc/path_space/growing_path.h"
#include "mcmc/path_space/path_form.h"
#include "mcmc/path_space/path_mutation.h"

namespace ajar {

/// Takes vertices out of a path, or the whole path, or only the edge between two vertices, lets its
/// two ends grow, by other numbers of vertices as a rule, and joins them again: paths of all
/// lengths are reached from each (docs/methods/mlt.md). Source: Veach 1997, section 11.4.2.
class BidirectionalMutation final : public PathMutation {
 public:
  struct Depths {
    int min = 1;  ///< edges, at least 1
    int max = 1;
  };
  /// `scene` and `area` must outlive it.
  BidirectionalMutation(const Scene& scene, const RasterArea& area, const Depths& depths);

  std::string_view name() const override { return "bidirectional"; }
  /// Paths that no technique makes are not proposed.
  bool suitable(const Path& path) const override { return !no_technique_makes(path); }
  std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) override;
  double log_density(const Path& x, const Path& y, const Kept& kept) const override;
  const RayCounts& ray_counts() const override { return growing_ray_counts_; }

 private:
  /// Where the two ends may meet in a path of `depth` edges of which so much is kept: s, the number
  /// of vertices at the light's side, from `first` to `last`.
  struct Joints {
    int first;
    int last;
    int count() const { return std::max(0, last - first + 1); }
  };
  static Joints joints(int depth, const Kept& kept);

  std::optional<Kept> choose_kept(int depth, double u, double place) const;
  double kept_probability(int depth, const Kept& kept) const;
  std::optional<int> choose_depth(int depth, const Kept& kept, double u) const;
  double depth_probability(int from, int to, const Kept& kept) const;
  /// Probabilities of depths `to`; 0 where there are no paths.
  double depth_weight(int from, int to, const Kept& kept) const;
  bool grow(const Path& x, const Kept& kept, int depth, int s, SampleSource& source);
  /// ln of the density of the vertices of `y` that are not kept, by joint.
  double log_joint(const Path& y, const Kept& kept, int s) const;

  const Scene& scene_;
  const RasterArea& area_;
  Depths depths_;
  GrowingPath growing_;
  RayCounts growing_ray_counts_;
};

}  // namespace ajar
