#include "mcmc/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace ajar {

namespace {

/// The weights with a largest value of 1, so that sums cannot overflow; empty if all are zero.
std::vector<double> normalised(std::span<const double> weights) {
  double largest = 0.0;
  for (const double weight : weights) {
    if (!(weight >= 0.0 && std::isfinite(weight))) {
      throw std::invalid_argument("weights must be finite and not negative");
    }
    largest = std::max(largest, weight);
  }
  if (largest == 0.0) return {};
  std::vector<double> result(weights.begin(), weights.end());
  for (double& weight : result) weight /= largest;
  return result;
}

}  // namespace

Moments bootstrap_moments(std::span<const double> weights) {
  Moments moments;
  for (const double weight : weights) {
    if (!(weight >= 0.0 && std::isfinite(weight))) {
      throw std::invalid_argument("weights must be finite and not negative");
    }
    moments.add(weight);
  }
  return moments;
}

std::vector<std::size_t> choose_seeds(std::span<const double> weights, std::size_t count,
                                      double u) {
  if (!(u >= 0.0 && u < 1.0)) throw std::invalid_argument("u must be in [0, 1)");
  const std::vector<double> shares = normalised(weights);
  if (shares.empty()) return {};
  const double total = std::accumulate(shares.begin(), shares.end(), 0.0);

  std::vector<std::size_t> seeds;
  seeds.reserve(count);
  double before = 0.0;   // sum of the shares before the candidate
  std::size_t last = 0;  // the last candidate with a share
  const auto place = [&] {
    return (static_cast<double>(seeds.size()) + u) / static_cast<double>(count) * total;
  };
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] == 0.0) continue;
    last = i;
    before += shares[i];
    while (seeds.size() < count && place() < before) seeds.push_back(i);
  }
  // Rounding can put the last place at the very end.
  seeds.resize(count, last);
  return seeds;
}

std::vector<double> filter_weights(std::span<const double> weights, SeedFilter filter,
                                   double spread) {
  std::vector<double> result(weights.begin(), weights.end());
  if (filter == SeedFilter::None) return result;
  const Moments moments = bootstrap_moments(weights);
  const double deviation = moments.standard_error() * std::sqrt(static_cast<double>(moments.count));
  const double limit = moments.mean() + spread * deviation;
  double left = 0.0;
  for (double& weight : result) {
    if (weight > limit) weight = filter == SeedFilter::Dropped ? 0.0 : limit;
    left += weight;
  }
  if (left == 0.0) result.assign(weights.begin(), weights.end());
  return result;
}

double seed_weight(std::span<const double> weights, std::span<const double> filtered,
                   SeedFilter filter, std::size_t index) {
  if (filter != SeedFilter::Weighted) return 1.0;
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double all_filtered = std::accumulate(filtered.begin(), filtered.end(), 0.0);
  return weights[index] / all / (filtered[index] / all_filtered);
}

std::vector<std::size_t> apportion(std::span<const double> b, std::size_t count) {
  std::vector<std::size_t> result(b.size(), 0);
  const std::vector<double> shares = normalised(b);
  if (shares.empty()) return result;

  // Depths whose quota is below one get one chain and leave the competition, which lowers the
  // quotas of the others, until all that remain have one at least.
  std::vector<std::size_t> competing;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (b[i] > 0.0) competing.push_back(i);
  }
  if (competing.size() >= count) {
    for (const std::size_t i : competing) result[i] = 1;
    return result;
  }
  double total = 0.0;
  const auto quota = [&](std::size_t i) { return static_cast<double>(count) * shares[i] / total; };
  for (bool settled = false; !settled;) {
    total = 0.0;
    for (const std::size_t i : competing) total += shares[i];
    const auto small = std::stable_partition(competing.begin(), competing.end(),
                                             [&](std::size_t i) { return quota(i) >= 1.0; });
    settled = small == competing.end();
    for (auto i = small; i != competing.end(); ++i) result[*i] = 1;
    count -= static_cast<std::size_t>(competing.end() - small);
    competing.erase(small, competing.end());
  }

  std::size_t given = 0;
  std::vector<double> remainders(b.size(), 0.0);
  for (const std::size_t i : competing) {
    result[i] = static_cast<std::size_t>(quota(i));
    remainders[i] = quota(i) - static_cast<double>(result[i]);
    given += result[i];
  }
  std::stable_sort(competing.begin(), competing.end(),
                   [&](std::size_t i, std::size_t j) { return remainders[i] > remainders[j]; });
  for (std::size_t k = 0; given < count; k = (k + 1) % competing.size(), ++given) {
    ++result[competing[k]];
  }
  return result;
}

}  // namespace ajar
