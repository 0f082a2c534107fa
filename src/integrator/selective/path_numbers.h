#pragma once
#include <vector>

#include "integrator/outlier_paths.h"
#include "integrator/selective/preparation.h"
#include "mcmc/primary/primary_chain.h"

namespace ajar {

/// The numbers that ordinary Monte Carlo has made a path of, so that a chain can start there.
class PathNumbers {
 public:
  /// Records both subpaths, of which `path` must know the light's number, for as many vertices as
  /// the path's technique has.
  PathNumbers(SampleSource& source, const OutlierPath& path);
  /// None, to be read from an archive.
  PathNumbers() = default;
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(numbers_);
  }
  /// Tests whether there are as many as the path needs, all of them in [0, 1).
  bool fit(const OutlierPath& path) const;

  /// A chain at the path, with I = 0: its target has yet to be asked. Numbers that the path does
  /// not use, and the place within the technique's share of the choice among techniques, are fresh.
  PrimaryChain start_chain(const SelectivePreparation& prepared, const PathGroup& group,
                           const OutlierPath& path) const;

 private:
  std::vector<float> numbers_;  ///< blocks of the camera's vertices, then the light's
};

}  // namespace ajar
