#pragma once
#include <span>

/// Visibility of errors, and the allocation of time that makes its mean over a picture's pixels
/// smallest.
///
/// The mean squared error depends on the few worst pixels: those around a path that was found once.
/// Reducing it a little costs all others noise that can be seen everywhere. FLIP (Andersson et al.
/// 2020) takes differences of colours to the power of 0.7, hence σ^0.7 for an error σ here.
namespace ajar {

/// σ^0.7 for σ².
double visible_error(double variance);
/// The inverse.
double variance_of(double visible_error);

/// Mutations per sample of the whole picture, among `lowest`, `lowest`·√2, … up to `highest`, that
/// make the sum of the visible errors of V_j/n + K_j/n · `usual`/N smallest after a given time for
/// n samples. `omc`: V_j, variance of one sample of ordinary Monte Carlo in pixel j. `chains`: K_j,
/// variance that chains leave there after n samples with `usual` mutations each, times n.
/// `sample_cost`: of one sample of each pixel; `mutation_cost`: of one mutation, in the same unit.
/// Raises std::invalid_argument if there are not as many of both, or for numbers that are not
/// positive.
double mutations_of_least_visible_error(std::span<const double> omc, std::span<const double> chains,
                                        double usual, double sample_cost, double mutation_cost,
                                        double lowest, double highest);

}  // namespace ajar
