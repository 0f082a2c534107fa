#pragma once
#include <span>

/// How to split time between ordinary Monte Carlo (OMC) and Markov chains so that the *mean* error
/// of a picture's pixels is smallest, not the mean of its square.
///
/// A squared error is decided by the few worst pixels, and these are the chains': those around a
/// path that was found once. What it takes to make them a little better, all other pixels pay for,
/// with noise that can be seen everywhere. Nor do mutations help them as much as the model says
/// that splits time by squares (optimal_thresholds.h): where chains can start depends on OMC.
namespace ajar {

/// N/n, mutations per sample of the whole picture, among `lowest`, `lowest`·√2, … up to `highest`,
/// that makes Σ_j √(V_j/n + M_j/N) smallest for n samples of each pixel and N mutations that
/// together cost a given time. `omc`: V_j, variance of one OMC sample of pixel j. `chains`: M_j,
/// variance that chains leave there after N mutations in the whole picture, times N. `sample_cost`:
/// of one sample of each pixel; `mutation_cost`: of one mutation, in the same unit. Raises
/// std::invalid_argument if there are not as many of both, or for numbers that are not positive.
double mutations_of_least_mean_error(std::span<const double> omc, std::span<const double> chains,
                                     double sample_cost, double mutation_cost, double lowest,
                                     double highest);

}  // namespace ajar
