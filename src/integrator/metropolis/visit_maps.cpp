#include "integrator/metropolis/visit_maps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/archive.h"

namespace ajar {

namespace {

Vec2 origin_of(const ChainView& view) { return {std::floor(view.low.x), std::floor(view.low.y)}; }

Vec2i pixels_of(const ChainView& view) {
  const Vec2 end = view.low + view.size - origin_of(view);
  return {static_cast<int>(std::ceil(end.x)), static_cast<int>(std::ceil(end.y))};
}

}  // namespace

VisitMaps::VisitMaps(const PlaneRule& rule, const ChainView& view, int replicates, double magnitude,
                     const Mutation& mutation)
    : rule_(rule),
      mutation_(mutation),
      origin_(origin_of(view)),
      magnitude_(magnitude),
      grid_(view.low - origin_of(view), view.size, pixels_of(view)),
      film_(pixels_of(view), Box2i(Vec2i(0, 0), pixels_of(view) - Vec2i(1, 1)), Filter::box(),
            replicates, {{.name = "visits"}}),
      moves_(static_cast<std::size_t>(replicates)) {}

void VisitMaps::add(int replicate, const Vec2& raster, double visits, double light) {
  film_.splat(0, replicate, raster - origin_,
              Spectrum(static_cast<float>(visits), static_cast<float>(light / magnitude_), 0.F));
}

std::vector<PixelVisits> VisitMaps::visits_without(int replicate) const {
  std::vector<PixelVisits> result(static_cast<std::size_t>(film_.width()) *
                                  static_cast<std::size_t>(film_.height()));
  const int replicates = film_.replicates();
  const double scale = replicate < 0 ? 1.0 : replicates / (replicates - 1.0);
  for (int r = 0; r < replicates; ++r) {
    if (r == replicate) continue;
    const std::vector<float> sums = film_.develop_replicate(0, r, scale);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i].visits += sums[3 * i];
      result[i].light += sums[3 * i + 1];
    }
  }
  return result;
}

void VisitMaps::end_epoch(double mutations) {
  if (!gathers_ || mutations < rule_.visits_needed()) return;
  gathers_ = rule_.published;
  learned_.assign(film_.raw().begin(), film_.raw().end());
  make_moves();
}

void VisitMaps::make_moves() {
  if (rule_.published) {
    const auto shared =
        std::make_shared<const PlaneMoves>(grid_, rule_, visits_without(-1), mutation_);
    moves_.assign(moves_.size(), shared);
    return;
  }
  if (film_.replicates() < 2) return;
  for (int r = 0; r < film_.replicates(); ++r) {
    moves_[static_cast<std::size_t>(r)] =
        std::make_shared<const PlaneMoves>(grid_, rule_, visits_without(r), mutation_);
  }
}

void VisitMaps::save_state(OutputArchive& archive) const {
  archive(gathers_, learned_, std::vector<std::int64_t>(film_.raw().begin(), film_.raw().end()));
}

void VisitMaps::load_state(InputArchive& archive) {
  std::vector<std::int64_t> sums;
  archive(gathers_, learned_, sums);
  if (!learned_.empty()) {
    film_.take_raw(learned_);
    make_moves();
  }
  film_.take_raw(std::move(sums));
  known_.assign(film_.raw().begin(), film_.raw().end());
}

void VisitMaps::export_delta(OutputArchive& archive) {
  known_.resize(film_.raw().size());
  std::vector<std::int64_t> delta;
  // Once nothing is gathered there are none.
  if (gathers_) {
    delta.resize(known_.size());
    std::transform(film_.raw().begin(), film_.raw().end(), known_.begin(), delta.begin(),
                   std::minus<>());
    std::copy(known_.begin(), known_.end(), film_.raw().begin());
  }
  archive(delta);
}

void VisitMaps::import_delta(InputArchive& archive) {
  std::vector<std::int64_t> delta;
  archive(delta);
  if (delta.empty()) return;
  std::transform(delta.begin(), delta.end(), known_.begin(), known_.begin(), std::plus<>());
  std::copy(known_.begin(), known_.end(), film_.raw().begin());
}

}  // namespace ajar
