#pragma once
#include <optional>
#include <span>

/// What an error in a pixel is to the eye, and how to spend time so that the mean of it over a
/// picture's pixels is smallest.
///
/// A squared error is decided by the few worst pixels: those around a path that was found once.
/// What it takes to make them a little better, all others pay for, with noise that can be seen
/// everywhere. FLIP (Andersson et al. 2020) takes differences of colours to the power of 0.7, and
/// so is σ^0.7 what an error σ counts for here.
namespace ajar {

/// σ^0.7 for σ².
double visible_error(double variance);
/// The inverse.
double variance_of(double visible_error);

/// How many samples a part of the picture deserves in which one sample leaves `visible_error`s of
/// this mean, but for a factor that all parts have: n samples leave (σ²/n)^0.35.
double samples_for(double mean_visible_error);

/// How alike two pictures of errors are to the eye: the correlation of values whose squares are
/// visible errors, √(σ^0.7) with the sign of the error; 1 for errors of which one is a positive
/// multiple of the other. None if all of one are 0.
/// Raises std::invalid_argument if there are not as many of both.
std::optional<double> visible_correlation(std::span<const float> a, std::span<const float> b);

/// Mutations per sample of the whole picture, among `lowest`, `lowest`·√2, … up to `highest`, that
/// make the sum of the visible errors of V_j/n + K_j/n · (s + (1 − s) · `usual`/N) smallest after a
/// given time for n samples. `omc`: V_j, variance of one sample of ordinary Monte Carlo in pixel j.
/// `chains`: K_j, variance that chains leave there after n samples with `usual` mutations each,
/// times n; `lasting`: s, what of that more mutations would not bring away, from 0 to 1.
/// `sample_cost`: of one sample of each pixel; `mutation_cost`: of one mutation, in the same unit.
/// Raises std::invalid_argument if there are not as many of both, or for numbers that are not
/// positive or a share that is none.
double mutations_of_least_visible_error(std::span<const double> omc, std::span<const double> chains,
                                        double lasting, double usual, double sample_cost,
                                        double mutation_cost, double lowest, double highest);

}  // namespace ajar
