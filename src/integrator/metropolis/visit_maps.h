#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/archive_forward.h"
#include "image/film.h"
#include "integrator/metropolis/chain_film_sink.h"
#include "integrator/metropolis/path_target.h"
#include "mcmc/primary/plane_moves.h"

namespace ajar {

/// Where chains have been and what light they found, pixel by pixel, and the moves that follow from
/// it. Maps change between epochs only, which end at counts fixed in advance: each is the same for
/// any number of threads.
///
/// Exact rules adapt once, at the end of the first epoch that brings enough visits, and each
/// replicate takes its maps from the others, which have not adapted by then: they are independent
/// of all it has done and will do. (A chain whose moves depend on its own past need not keep its
/// distribution, even if each of these moves does.) A single replicate never adapts.
///
/// Published rules take all visits so far of all replicates, and adapt at the end of every epoch.
/// (Published maps are live. Here that would make the picture depend on the number of threads.)
class VisitMaps final : public VisitSink {
 public:
  /// `mutation` must outlive this. `magnitude`: of the light on a pixel.
  VisitMaps(const PlaneRule& rule, const ChainView& view, int replicates, double magnitude,
            const Mutation& mutation);

  /// False once nothing more is to be learned.
  bool gathers() const { return gathers_; }
  void add(int replicate, const Vec2& raster, double visits, double light) override;
  /// After so many mutations per pixel over all replicates. On one thread.
  void end_epoch(double mutations);
  /// All that it has learned, between passes.
  void save_state(OutputArchive& archive) const;
  void load_state(InputArchive& archive);
  /// Gives away what this process has counted since it did so last; and takes what one of the
  /// processes has given, which may have been this one.
  void export_delta(OutputArchive& archive);
  void import_delta(InputArchive& archive);
  std::uint64_t memory_bytes() const { return film_.bytes(); }
  /// Null as long as steps are ordinary.
  const PlaneMoves* moves(int replicate) const {
    return moves_[static_cast<std::size_t>(replicate)].get();
  }

 private:
  /// The moves that follow from the film as it is.
  void make_moves();
  /// Visits of all replicates but one (-1: of all), scaled to the number of all.
  std::vector<PixelVisits> visits_without(int replicate) const;

  PlaneRule rule_;
  const Mutation& mutation_;
  Vec2 origin_;
  double magnitude_;
  RasterGrid grid_;
  Film film_;  ///< visits and light in two channels
  bool gathers_ = true;
  std::vector<std::int64_t> learned_;  ///< the film's sums that moves were made of; may be empty
  std::vector<std::int64_t> known_;    ///< sums that all processes have; empty: none
  std::vector<std::shared_ptr<const PlaneMoves>> moves_;  ///< moves of each replicate
};

}  // namespace ajar
