#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "mcmc/splat.h"

namespace ajar {

/// Why a proposal counts as one without light.
enum class Fault : std::uint8_t { None, NotANumber, Infinite, Negative };

/// A state that a chain may go to.
struct Candidate {
  double scalar = 0.0;       ///< I; 0 if there is a fault
  double probability = 0.0;  ///< to be the next state
  Fault fault = Fault::None;
  SplatBuffer splats;  ///< appended to as the state is evaluated

  /// Stores a target's I; values whose inverse would not be finite count as 0.
  void take(double value);
};

/// One of the moves that a kernel mixes.
struct Move {
  std::string_view name;  ///< for statistics
  /// True if its candidates are independent samples of density 1, whatever the current state is
  /// (large steps of primary sample space).
  bool independent = false;
};

/// Outcome of a manifold walk to a proposal.
enum class WalkEnd : std::uint8_t {
  None,    ///< not tried, or there and back
  Lost,    ///< did not arrive
  OneWay,  ///< one from the proposal did not come back to the current state
};

/// Proposal of a step: one state, or several of which one at most becomes the next.
struct Proposal {
  std::optional<std::size_t> move;  ///< in `Kernel::moves`; empty if none was for the state
  std::span<const Candidate> candidates;
  std::uint64_t rays = 0;  ///< rays traced; 0 where kernels do not count them
  WalkEnd walk = WalkEnd::None;
  /// True if it is rejected because its density is 0 or NaN, or the reverse density is NaN: a
  /// mistake, or a rounding at the ends of a reach.
  bool without_density = false;
};

/// A transition of Markov chains that keeps the density I / b: proposes from its current state,
/// returns the probability of each candidate to be the next, and accepts or stays. Holds the
/// scratch memory of one thread. Kernels set the state of a chain in their own ways.
///
/// A kernel that mixes moves chooses among them independently of the state, or has the choice in
/// its probabilities: then each may be right by itself.
class Kernel {
 public:
  virtual ~Kernel() = default;
  /// Constant.
  virtual std::span<const Move> moves() const = 0;
  /// Independent candidates per step, on average.
  virtual double independent_candidates() const { return 0.0; }
  /// Splats of the current state.
  virtual std::span<const Splat> current() const = 0;
  /// A step. `key` names its randomness. The candidates are the kernel's until its next function is
  /// called.
  virtual Proposal propose(std::uint64_t key) = 0;
  /// One of these two follows: the candidate of that number is the current state from now on, or
  /// none is.
  virtual void accept(std::size_t candidate) = 0;
  virtual void reject() = 0;
};

/// Metropolis & Hastings: min(1, I(y) T(y → x) / (I(x) T(x → y))), with the logarithm of T(y → x) /
/// T(x → y).
double metropolis_hastings(double current, double proposal, double log_ratio);

}  // namespace ajar
