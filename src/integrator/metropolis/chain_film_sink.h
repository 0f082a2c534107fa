#pragma once
#include <array>
#include <string>
#include <vector>

#include "image/film.h"
#include "image/importance_map.h"
#include "integrator/integrator.h"
#include "integrator/metropolis/path_target.h"
#include "mcmc/primary/primary_runner.h"

namespace ajar {

inline const std::string kDensityLayer = "density";
inline const std::string kAcceptanceLayer = "acceptance";
inline bool is_chain_layer(const std::string& name) {
  return name == kDensityLayer || name == kAcceptanceLayer;
}
/// Settings of ordinary Monte Carlo beside chains: without the layers that it does not make there.
RenderSettings beside_chains(RenderSettings settings);
/// Adds the requested ones.
void add_chain_layers(std::vector<LayerSpec>& specs, const std::vector<std::string>& aovs);

/// Learns where chains are. Thread-safe.
class VisitSink {
 public:
  virtual ~VisitSink() = default;
  /// A visit of this weight to the pixel of a raster position, and the light it brought.
  virtual void add(int replicate, const Vec2& raster, double visits, double light) = 0;
};

/// Puts what chains deposit on the film, as far as `part` keeps it, and tells `visits` if it is
/// there.
class ChainFilmSink final : public DepositSink {
 public:
  /// `target` is null for states that are of no technique.
  ChainFilmSink(Film& film, int replicate, const ImportanceMap& importance,
                const PathTarget* target, Counters& counters, VisitSink* visits = nullptr,
                const ChainWeight* part = nullptr);

  /// `scale` multiplies what is deposited; what is `proposed` is counted in `by_technique`.
  void begin(double scale, std::vector<MoveCount>* by_technique) {
    scale_ = scale;
    by_technique_ = by_technique;
  }
  void deposit(std::span<const Splat> splats, double factor) override;
  void proposed(std::span<const Splat> current, double acceptance) override;

 private:
  Film& film_;
  std::array<int, 2> light_;
  int density_;
  int acceptance_;
  int replicate_;
  const ImportanceMap& importance_;
  const PathTarget* target_;
  Counters& counters_;
  VisitSink* visits_;
  const ChainWeight* part_;
  double scale_ = 1.0;
  std::vector<MoveCount>* by_technique_ = nullptr;
};

}  // namespace ajar
