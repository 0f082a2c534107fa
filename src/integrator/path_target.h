#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "image/importance_map.h"
#include "mcmc/target.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Where chains look for light: a rectangle of raster positions, the film's pixels and as far
/// beyond as their filter reaches, and how much each place matters.
struct ChainView {
  Vec2 low{0.F, 0.F};
  Vec2 size{1.F, 1.F};
  ImportanceMap importance;

  Vec2 raster(const Vec2& u) const { return low + u * size; }
  bool contains(const Vec2& raster) const {
    return raster.x >= low.x && raster.y >= low.y && raster.x < low.x + size.x &&
           raster.y < low.y + size.y;
  }
  /// Pixels².
  double area() const { return static_cast<double>(size.x) * static_cast<double>(size.y); }
};

/// Layers of splats as targets number them.
enum SplatLayer : std::int32_t { kDirectSplat = 0, kIndirectSplat = 1 };
constexpr std::int32_t splat_layer(int depth) { return depth <= 2 ? kDirectSplat : kIndirectSplat; }

/// Σ luminance · importance over splats: the contribution function I.
double contribution(std::span<const Splat> splats, const ImportanceMap& importance);

/// A target over paths.
class PathTarget : public Target {
 public:
  virtual std::uint64_t rays() const = 0;
  /// The technique of the state evaluated last, for targets whose states are of one.
  virtual const Technique* technique() const { return nullptr; }
};

/// A state is a camera subpath and a light subpath with all their connections (`pssmlt`).
/// Source: Kelemen et al. 2002.
class WholePathTarget final : public PathTarget {
 public:
  WholePathTarget(const Scene& scene, const PathSamplerSettings& settings, const ChainView& view);
  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override;
  std::uint64_t rays() const override { return sampler_.rays(); }

 private:
  const ChainView& view_;
  bool light_alone_;
  PathSampler sampler_;
};

/// A state is one path of one depth and technique (`mmlt`). The technique is chosen by one more
/// number, uniformly among those of the set. A half of the path that a step does not move is not
/// traced again. Source: Hachisuka, Kaplanyan, Dachsbacher 2014.
class OnePathTarget final : public PathTarget {
 public:
  /// All paths have `settings.max_depth` edges, which must equal `settings.min_depth`, and some
  /// technique of that depth must belong to the set.
  OnePathTarget(const Scene& scene, const PathSamplerSettings& settings, const ChainView& view);
  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override;
  void accepted() override;
  void rejected() override;
  std::uint64_t rays() const override { return sampler_.rays(); }
  const Technique* technique() const override { return &technique_; }

  static std::vector<Technique> techniques_of(const TechniqueSet& set, int depth);

 private:
  /// One half of a path: the vertex it ends with, if it gets there.
  struct Half {
    int vertices = 0;  ///< that it was traced for; 0: not known
    bool complete = false;
    PathVertex end;
  };
  /// Traces a half for the proposal, or takes the current one; null if it is not complete.
  template <typename Trace>
  const PathVertex* half(Half& current, Half& proposal, int vertices, bool moved,
                         const Trace& trace);
  static void keep(Half& current, Half& proposal, bool moved);

  const ChainView& view_;
  PathSampler sampler_;
  std::vector<Technique> techniques_;
  Technique technique_{0, 2};
  Change change_;
  Half light_;
  Half light_proposal_;
  Half camera_;
  Half camera_proposal_;
};

}  // namespace ajar
