#include "integrator/metropolis/path_seeds.h"

#include <cmath>

#include "mcmc/path_space/path_kernel.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/recorder.h"

namespace ajar {

namespace {

/// Keeps one of the paths that it is told of.
class PathLot final : public PathRecorder {
 public:
  PathLot(const Scene& scene, const PathSamplerSettings& settings, const ChainView& view, double u,
          const PathPart* part, PathWeight* weight)
      : PathRecorder(scene, settings), view_(view), part_(part), weight_(weight), u_(u) {}

  bool reaches(const Vec2& raster) const override { return view_.contains(raster); }

  void record(const Path& path, const Contribution& contribution) override {
    auto brings =
        static_cast<double>(luminance(contribution.value) * view_.importance(path.raster));
    if (part_ != nullptr) {
      brings *= static_cast<double>(part_->share(contribution, path.raster));
    }
    if (contribution.technique.t == 1) brings /= view_.area_per_pixel();
    if (!(brings > 0.0) || !std::isfinite(brings)) return;
    splats_.clear();
    if (!std::isfinite(light_on(scene(), path, view_, 0, splats_, weight_))) return;
    total_ += brings;
    // The number that is left of u is uniform again, whichever way this goes.
    const double share = brings / total_;
    if (u_ < share) {
      chosen = path;
      u_ /= share;
    } else {
      u_ = (u_ - share) / (1.0 - share);
    }
  }
  std::optional<Path> chosen;

 private:
  const ChainView& view_;
  const PathPart* part_;
  PathWeight* weight_;
  double u_;
  double total_ = 0.0;
  SplatBuffer splats_;
};

}  // namespace

std::optional<Path> choose_path(const Scene& scene, const PathGroup& group, const ChainView& view,
                                std::uint64_t seed, std::uint64_t index, double u,
                                const PathPart* part, PathWeight* weight) {
  PathSampler sampler(scene, group.sampler);
  PathLot lot(scene, group.sampler, view, u, part, weight);
  BootstrapSource numbers(seed, index);
  const Vec2 raster = view.raster(numbers.get_pair({Stream::Camera, 0, kEmissionDirection}));
  lot.begin(raster);
  sampler.sample(numbers, raster, lot);
  return std::move(lot.chosen);
}

}  // namespace ajar
