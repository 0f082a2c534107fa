#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "image/importance_map.h"
#include "integrator/chain_weight.h"
#include "integrator/metropolis/path_class.h"
#include "mcmc/primary/target.h"
#include "path/raster_area.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Where chains look for light: a rectangle of raster positions, the film's pixels and as far
/// beyond as their filter reaches, and how much each place matters.
struct ChainView : RasterArea {
  ImportanceMap importance;
  /// Number of the film's pixels: ordinary Monte Carlo traces one light subpath for each (and only
  /// those count), chains look over the whole area.
  double pixels = 1.0;

  /// By which a mean over the film's pixels is larger than b, a mean over all the area.
  double area_per_pixel() const { return area() / pixels; }
};

/// Layers of splats as targets number them.
enum SplatLayer : std::int32_t { kDirectSplat = 0, kIndirectSplat = 1 };
constexpr std::int32_t splat_layer(int depth) { return depth <= 2 ? kDirectSplat : kIndirectSplat; }

/// Σ luminance · importance over splats: the contribution function I.
double contribution(std::span<const Splat> splats, const ImportanceMap& importance);

/// True if light subpaths are connected to the lens only: then a sample has one without a camera
/// subpath.
bool traces_light_alone(const PathSamplerSettings& settings);

/// The number of `Stream::Connection`, vertex 0, that chooses the technique of a state.
inline constexpr Slot kTechniqueChoice = Slot::BsdfDirectionX;

/// Among which techniques of one depth a state chooses, all equally likely. (Likelihoods in
/// proportion to the light a technique carries on the whole make large steps better, but a chain
/// gets stuck, for as many times longer, on paths of a technique that is rare elsewhere.)
class TechniqueChoice {
 public:
  /// All techniques of the set.
  TechniqueChoice(const TechniqueSet& set, int depth);
  bool empty() const { return techniques_.empty(); }
  std::size_t size() const { return techniques_.size(); }
  Technique operator[](std::size_t number) const { return techniques_[number]; }
  struct Chosen {
    std::size_t number;
    Technique technique;
    float probability;
  };
  Chosen choose(float u) const;
  /// A number by which `technique`, which must be one of them, is chosen; uniform among those if
  /// `u` in [0, 1) is uniform.
  float number_of(Technique technique, float u) const;

 private:
  std::vector<Technique> techniques_;
};

/// A target over paths, or over the `part` of their light that chains are to make.
class PathTarget : public Target {
 public:
  /// Traced so far.
  virtual const RayCounts& ray_counts() const = 0;
  std::uint64_t rays() const { return ray_counts().rays; }
  /// The technique of the state evaluated last, for targets whose states are of one.
  virtual const TechniqueChoice::Chosen* technique() const { return nullptr; }
};

/// A state is a camera subpath and a light subpath with all their connections (`pssmlt`).
/// Source: Kelemen et al. 2002.
class WholePathTarget final : public PathTarget {
 public:
  /// `view`, and `part` if it is not null, must outlive the target.
  WholePathTarget(const Scene& scene, const PathSamplerSettings& settings, const ChainView& view,
                  const ChainWeight* part = nullptr, PathClass paths = PathClass::All);
  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override;
  void accepted() override { directions_.accept(); }
  const RayCounts& ray_counts() const override { return sampler_.ray_counts(); }

 private:
  const ChainView& view_;
  const ChainWeight* part_;
  PathClass paths_;
  bool light_alone_;
  PathSampler sampler_;
  KeptDirections directions_;
};

/// A state is one path of one depth and technique (`mmlt`). The technique is chosen by one more
/// number. A half of the path that a step does not move is not
/// traced again. Source: Hachisuka, Kaplanyan, Dachsbacher 2014.
class OnePathTarget final : public PathTarget {
 public:
  /// All paths have `settings.max_depth` edges, which must equal `settings.min_depth`; the choice
  /// is among techniques of that depth. A state has one light subpath, which stands for
  /// `settings.light_subpaths` of ordinary Monte Carlo.
  OnePathTarget(const Scene& scene, const PathSamplerSettings& settings,
                const TechniqueChoice& choice, const ChainView& view,
                const ChainWeight* part = nullptr, PathClass paths = PathClass::All);
  double evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) override;
  void accepted() override;
  void rejected() override;
  const RayCounts& ray_counts() const override { return sampler_.ray_counts(); }
  const TechniqueChoice::Chosen* technique() const override { return &chosen_; }

 private:
  /// One half of a path: the vertex it ends with, if it gets there.
  struct Half {
    int vertices = 0;  ///< number of vertices of its trace; 0: not known
    int lane = 0;      ///< by which it was traced
    bool complete = false;
    PathVertex end;
  };
  /// Current and proposed halves are swapped without a copy: ends are large, and those never
  /// reached hold nothing that may be read.
  struct Halves {
    Half& current() { return both[now]; }
    Half& proposal() { return both[1 - now]; }
    std::array<Half, 2> both;
    std::size_t now = 0;
  };
  /// Traces a half for the proposal by `lane`, or takes the current one; null if it is not
  /// complete.
  template <typename Trace>
  const PathVertex* half(Halves& halves, int vertices, int lane, bool moved, const Trace& trace);
  static void keep(Halves& halves, bool moved);

  const ChainView& view_;
  const ChainWeight* part_;
  PathClass paths_;
  double light_subpaths_;
  bool uses_lane_;
  PathSampler sampler_;
  const TechniqueChoice& choice_;
  TechniqueChoice::Chosen chosen_{0, {0, 2}, 1.F};
  Change change_;
  KeptDirections directions_;
  Halves light_;
  Halves camera_;
};

}  // namespace ajar
