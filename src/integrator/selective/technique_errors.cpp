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
  for (Offer& offer : offers_) offer.first = {};
}

void TechniqueErrors::begin_sample() {
  for (Offer& offer : offers_) offer.now = {};
}

void TechniqueErrors::add(double light, TechniqueClass found_by,
                          const ByTechniqueClass<float>& shares) {
  if (!(light > 0.0)) return;
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
    // Light paths that reach the lens land on other pixels.
    if (found_by == TechniqueClass::Light) continue;
    const bool inner = found_by == TechniqueClass::Inner;
    (inner ? offer.now.inner : offer.now.own) += part;
    (inner ? offer.now.inner_squares : offer.now.own_squares) += part * part;
  }
}

void TechniqueErrors::end_sample() {
  ++samples_;
  for (Offer& offer : offers_) {
    const Sample& now = offer.now;
    const Sample& first = offer.first;
    const double subpaths = offer.counts[index_of(TechniqueClass::Inner)];
    const double own = now.own * now.own - now.own_squares;
    offer.second_moment += own + 2.0 * subpaths * now.own * now.inner +
                           subpaths * (now.inner * now.inner - now.inner_squares);
    // Pairs of light subpaths: each sample of this place has one.
    offer.second_moment +=
        2.0 * std::max(0.0, subpaths * (subpaths - 1.0)) * first.inner * now.inner;
    offer.mean_square += (first.own + subpaths * first.inner) * (now.own + subpaths * now.inner);
    offer.first = now;
  }
}

double TechniqueErrors::variance(std::size_t offer) const {
  const auto samples = static_cast<double>(samples_);
  const Offer& sums = offers_[offer];
  return sums.second_moment / samples - sums.mean_square / (samples / 2.0);
}

}  // namespace ajar
