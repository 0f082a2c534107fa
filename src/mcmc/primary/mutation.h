#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace ajar {

/// A small step in primary sample space: moves each number on the unit interval, whose ends are
/// joined, independently of the others. Stateless; shared by all threads.
class Mutation {
 public:
  virtual ~Mutation() = default;
  /// Name that users type.
  virtual std::string_view name() const = 0;

  /// Moves every number of a block as `steps` > 0 small steps in a row would. `scales` multiplies
  /// the length of the steps, number by number; `key` names the randomness to use.
  virtual void perturb(std::span<float> numbers, std::span<const float> scales, double steps,
                       std::uint64_t key) const = 0;
  /// True if `steps` may be a fraction: a step then is the sum of independent shorter ones.
  virtual bool divisible() const { return false; }

  /// Transition density of one step of one number, with respect to length on the unit interval.
  virtual double density(float from, float to, float scale) const = 0;

  /// log T(to → from) − log T(from → to) for one step of one block; 0 if the mutation is symmetric.
  /// It is asked only for blocks that the proposal used, so a mutation that is not symmetric may be
  /// so only in numbers that every state uses.
  virtual double log_ratio(std::span<const float> /*from*/, std::span<const float> /*to*/,
                           std::span<const float> /*scales*/) const {
    return 0.0;
  }
};

}  // namespace ajar
