#include "integrator/technique_shares.h"

#include <algorithm>
#include <stdexcept>

namespace ajar {

namespace {
constexpr int kSide = TechniqueShares::kMaxVertices + 2;
}  // namespace

std::size_t TechniqueShares::slot(Technique technique) {
  const bool deep = std::max(technique.s, technique.t) > kMaxVertices;
  const int s = deep ? kSide - 1 : technique.s;
  const int t = deep ? kSide - 1 : technique.t;
  return static_cast<std::size_t>(s) * kSide + static_cast<std::size_t>(t);
}

void TechniqueShares::add(std::size_t slot, double light, double variance) {
  if (sums_.empty()) sums_.resize(kSlots);
  sums_[slot].light += light;
  sums_[slot].variance += variance;
}

TechniqueShares& TechniqueShares::operator+=(const TechniqueShares& other) {
  for (std::size_t i = 0; i < other.sums_.size(); ++i) {
    add(i, other.sums_[i].light, other.sums_[i].variance);
  }
  return *this;
}

std::vector<double> TechniqueShares::sums() const {
  std::vector<double> sums;
  for (const Sums& slot : sums_) {
    sums.push_back(slot.light);
    sums.push_back(slot.variance);
  }
  return sums;
}

void TechniqueShares::add_sums(std::span<const double> sums) {
  if (sums.size() > 2 * kSlots) throw std::invalid_argument("technique shares: too many");
  for (std::size_t i = 0; 2 * i + 1 < sums.size(); ++i) add(i, sums[2 * i], sums[2 * i + 1]);
}

std::vector<TechniqueShares::Share> TechniqueShares::list() const {
  Sums whole;
  for (const Sums& sums : sums_) {
    whole.light += sums.light;
    whole.variance += sums.variance;
  }
  const auto share = [](double part, double all) { return all > 0.0 ? part / all : 0.0; };
  std::vector<Share> result;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (sums_[i].light == 0.0 && sums_[i].variance == 0.0) continue;
    result.push_back({{static_cast<int>(i) / kSide, static_cast<int>(i) % kSide},
                      share(sums_[i].light, whole.light),
                      share(sums_[i].variance, whole.variance)});
  }
  return result;
}

}  // namespace ajar
