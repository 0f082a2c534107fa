#pragma once
#include "mcmc/path_space/camera_perturbation.h"

namespace ajar {

/// Through more than one specular chain, up to the first vertex that is joined to another that is
/// not specular, or to the light: for paths (L|D) D S+ … D S* E, and L S+ D … S* E. Source: Veach
/// 1997, section 11.4.3.3; chains that end on a light are ours.
class MultiChainPerturbation final : public CameraPerturbation {
 public:
  using CameraPerturbation::CameraPerturbation;
  std::string_view name() const override { return "multi-chain"; }

 private:
  std::optional<int> end_of(const Path& path) const override;
};

}  // namespace ajar
