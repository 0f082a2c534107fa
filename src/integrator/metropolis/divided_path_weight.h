#pragma once
#include <utility>

#include "image/importance_map.h"
#include "integrator/chain_weight.h"
#include "integrator/metropolis/path_class.h"
#include "mcmc/path_space/path_weight.h"
#include "path/technique_parts.h"

namespace ajar {

/// The part of explicit paths that chains make where others make the rest of what each technique
/// finds (docs/methods/selective.md, "States without a technique"):
///
///     W(x) = Σ_t w_t · share(g_t)
///
/// over the techniques of a sampler, with what `ChainWeight` leaves of each, and w_t its MIS
/// weight.
class DividedPathWeight final : public PathWeight {
 public:
  /// All arguments must outlive it; `part` is null if techniques leave all they find: then W
  /// is 1 on paths that any of them makes, and 0 elsewhere. Chains of a sampler that runs into
  /// lights start from manifold connections, too; what these find that no technique can make is all
  /// theirs: W is 1. Outside of `paths` it is 0.
  DividedPathWeight(const Scene& scene, PathSamplerSettings settings,
                    const ImportanceMap& importance, const ChainWeight* part,
                    PathClass paths = PathClass::All)
      : scene_(scene),
        makes_hits_(settings.techniques.any(TechniqueClass::Implicit)),
        parts_(scene, std::move(settings)),
        importance_(importance),
        part_(part),
        paths_(paths) {}

  double part(const Path& path, double log_light) override;
  float importance(const Vec2& raster) const override { return importance_(raster); }

 private:
  const Scene& scene_;
  bool makes_hits_;
  TechniqueParts parts_;
  const ImportanceMap& importance_;
  const ChainWeight* part_;
  PathClass paths_;
};

}  // namespace ajar
