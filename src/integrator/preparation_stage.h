#pragma once
#include <cstdint>

#include "integrator/integrator.h"

namespace ajar {

/// One round of an integrator's preparation (see `Integrator::begin_preparation`).
class PreparationStage {
 public:
  virtual ~PreparationStage() = default;
  /// Upper estimate of its cost, in camera samples per pixel.
  virtual double effort() const = 0;
  /// True if its samples are kept in the picture.
  virtual bool stays() const { return false; }
  /// True if its result is of use even if no later stage runs.
  virtual bool serves_alone() const { return false; }
  /// Number of items; called once.
  virtual std::uint64_t begin() = 0;
  /// On any thread, in any order.
  virtual void run(std::uint64_t item, Counters& counters) = 0;
  /// Called once, after all items.
  virtual void end() = 0;
  /// Adds its samples to the film of the render, if they are kept; called once, before the first
  /// pass.
  virtual void hand_over(Film& /*film*/) {}
};

}  // namespace ajar
