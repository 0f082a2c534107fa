#include "image/visible_error.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "image/heuristics.h"

namespace ajar {

namespace {
constexpr double kExponent = ImageHeuristics::kVisibleExponent;
}  // namespace

double visible_error(double variance) { return std::pow(variance, kExponent); }

double variance_of(double visible_error) { return std::pow(visible_error, 1.0 / kExponent); }

double samples_for(double mean_visible_error) {
  return std::pow(mean_visible_error, 1.0 / (1.0 + kExponent));
}

std::optional<double> visible_correlation(std::span<const float> a, std::span<const float> b) {
  if (a.size() != b.size()) {
    throw std::invalid_argument("visible error: pictures of different sizes");
  }
  const auto seen = [](float error) {
    return std::copysign(std::pow(std::abs(static_cast<double>(error)), kExponent),
                         static_cast<double>(error));
  };
  double products = 0.0;
  double squares_a = 0.0;
  double squares_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double of_a = seen(a[i]);
    const double of_b = seen(b[i]);
    products += of_a * of_b;
    squares_a += of_a * of_a;
    squares_b += of_b * of_b;
  }
  if (!(squares_a > 0.0 && squares_b > 0.0)) return std::nullopt;
  return products / std::sqrt(squares_a * squares_b);
}

double mutations_of_least_visible_error(std::span<const double> omc, std::span<const double> chains,
                                        double lasting, double usual, double sample_cost,
                                        double mutation_cost, double lowest, double highest) {
  // Written so that NaN fails.
  if (omc.size() != chains.size() || !(usual > 0.0 && sample_cost > 0.0 && mutation_cost > 0.0) ||
      !(lowest > 0.0 && highest >= lowest && lasting >= 0.0 && lasting <= 1.0)) {
    throw std::invalid_argument("visible error: costs, bounds or a share make no sense");
  }
  double best = lowest;
  double least = std::numeric_limits<double>::infinity();
  const int steps =
      static_cast<int>(std::floor(ImageHeuristics::kTriedPerOctave * std::log2(highest / lowest)));
  for (int i = 0; i <= steps; ++i) {
    const double ratio = lowest * std::exp2(i / ImageHeuristics::kTriedPerOctave);
    const double of_chains = lasting + (1.0 - lasting) * usual / ratio;
    double sum = 0.0;
    for (std::size_t j = 0; j < omc.size(); ++j) {
      sum += visible_error(omc[j] + chains[j] * of_chains);
    }
    // After one unit of time, n is 1 over the cost of a sample with its mutations.
    const double error = sum * visible_error(sample_cost + ratio * mutation_cost);
    if (error >= least) continue;
    least = error;
    best = ratio;
  }
  return best;
}

}  // namespace ajar
