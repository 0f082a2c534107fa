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

double mutations_of_least_visible_error(std::span<const double> omc, std::span<const double> chains,
                                        double usual, double sample_cost, double mutation_cost,
                                        double lowest, double highest) {
  // Written so that NaN fails.
  if (omc.size() != chains.size() || !(usual > 0.0 && sample_cost > 0.0 && mutation_cost > 0.0) ||
      !(lowest > 0.0 && highest >= lowest)) {
    throw std::invalid_argument("visible error: costs or bounds make no sense");
  }
  double best = lowest;
  double least = std::numeric_limits<double>::infinity();
  const int steps =
      static_cast<int>(std::floor(ImageHeuristics::kTriedPerOctave * std::log2(highest / lowest)));
  for (int i = 0; i <= steps; ++i) {
    const double ratio = lowest * std::exp2(i / ImageHeuristics::kTriedPerOctave);
    double sum = 0.0;
    for (std::size_t j = 0; j < omc.size(); ++j) {
      sum += visible_error(omc[j] + chains[j] * usual / ratio);
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
