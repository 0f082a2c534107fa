#pragma once
#include "mcmc/path_space/camera_perturbation.h"

namespace ajar {

/// Up to the first vertex that is not specular: for paths (L|D) D S* E, and L S* E. Source: Veach
/// 1997, section 11.4.3.1; lights that are seen directly, or in mirrors, are ours.
class LensPerturbation final : public CameraPerturbation {
 public:
  using CameraPerturbation::CameraPerturbation;
  std::string_view name() const override { return "lens"; }

 private:
  std::optional<int> end_of(const Path& path) const override;
};

}  // namespace ajar
