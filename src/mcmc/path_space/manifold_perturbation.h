#pragma once
#include "mcmc/path_space/constraint_perturbation.h"

namespace ajar {

/// Through specular vertices alone, from the first other one on: for paths (L|D) S+ D S* E. Source:
/// Jakob & Marschner 2012, "Manifold exploration", section 4.4.
class ManifoldPerturbation final : public ConstraintPerturbation {
 public:
  using ConstraintPerturbation::ConstraintPerturbation;
  std::string_view name() const override { return "manifold"; }

 private:
  std::optional<Span> span_of(const Path& path) const override;
};

}  // namespace ajar
