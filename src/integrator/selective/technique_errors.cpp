#include "integrator/selective/technique_errors.h"

#include <algorithm>
#include <limits>

namespace ajar {

TechniqueErrors::TechniqueErrors(const std::vector<ByTechniqueClass<double>>& counts) {
  for (const ByTechniqueClass<double>& of_offer : counts) {
    offers_.emplace_back().counts = of_offer;
  }
}

void TechniqueErrors::begin_place() {
  of_place_ = 0;
  for (Offer& offer : offers_) {
    offer.before = {};
    offer.own_sums = {};
    offer.own_differences = 0.0;
  }
}

void TechniqueErrors::begin_sample() {
  for (Offer& offer : offers_) offer.now = {};
}

void TechniqueErrors::add(double light, TechniqueClass found_by,
                          const ByTechniqueClass<float>& shares) {
  if (!(light > 0.0)) return;
  const auto by_camera = static_cast<double>(shares[index_of(TechniqueClass::Implicit)] +
                                             shares[index_of(TechniqueClass::NextEvent)]);
  for (Offer& offer : offers_) {
    double often = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      often += offer.counts[k] * static_cast<double>(shares[k]);
    }
    if (!(often > 0.0)) {
      offer.second_moment = std::numeric_limits<double>::infinity();
      continue;
    }
    const double part = light / often;
    offer.second_moment += light * part;
    offer.own_second_moment += light * part * by_camera / often;
    // Light paths that reach the lens land on other pixels.
    if (found_by == TechniqueClass::Light) continue;
    const bool inner = found_by == TechniqueClass::Inner;
    (inner ? offer.now.inner : offer.now.own) += part;
    (inner ? offer.now.inner_squares : offer.now.own_squares) += part * part;
  }
}

void TechniqueErrors::end_sample() {
  ++samples_;
  const bool is_second = of_place_++ % 2 == 1;
  for (Offer& offer : offers_) {
    const Sample& now = offer.now;
    const Sample& before = offer.before;
    const double subpaths = offer.counts[index_of(TechniqueClass::Inner)];
    const double own = now.own * now.own - now.own_squares;
    offer.own_second_moment += own;
    offer.second_moment += own + 2.0 * subpaths * now.own * now.inner +
                           subpaths * (now.inner * now.inner - now.inner_squares);
    offer.own_sums[is_second ? 1 : 0] += now.own;
    if (is_second) {
      // Pairs of light subpaths: each of the two samples has one.
      offer.second_moment +=
          2.0 * std::max(0.0, subpaths * (subpaths - 1.0)) * before.inner * now.inner;
      offer.own_mean_square += before.own * now.own;
      offer.mean_square +=
          (before.own + subpaths * before.inner) * (now.own + subpaths * now.inner);
      offer.own_differences += (before.own - now.own) * (before.own - now.own);
    }
    offer.before = now;
  }
}

void TechniqueErrors::end_place() {
  for (Offer& offer : offers_) {
    const double difference = offer.own_sums[0] - offer.own_sums[1];
    offer.spread.of_samples += offer.own_differences;
    offer.spread.of_groups += difference * difference;
  }
}

double TechniqueErrors::variance(std::size_t offer, double left_of_own) const {
  const auto samples = static_cast<double>(samples_);
  const auto of = [&](double second_moment, double mean_square) {
    return second_moment / samples - mean_square / (samples / 2.0);
  };
  const Offer& sums = offers_[offer];
  const double own = of(sums.own_second_moment, sums.own_mean_square);
  return of(sums.second_moment, sums.mean_square) - (1.0 - left_of_own) * own;
}

}  // namespace ajar
