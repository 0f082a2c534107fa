#pragma once
#include "mcmc/path_space/constraint_perturbation.h"

namespace ajar {

/// Through glossy vertices, too, G: those that scatter their light more densely than any diffuse
/// surface does, by a facet of it. The vertex that moves is the first that is neither specular nor
/// glossy, or, if there is none, the first that is not specular: for paths (L|D) (S|G)* D (S|G)* E
/// and L (S|G)+ G S* E with a glossy vertex besides. Source: Kaplanyan, Hanika & Dachsbacher 2014,
/// "The natural-constraint representation of the path space", whose half vectors move; that the
/// place on the film moves, and which vertices stay, is ours.
class HalfVectorPerturbation final : public ConstraintPerturbation {
 public:
  HalfVectorPerturbation(const Scene& scene, const RasterArea& area)
      : ConstraintPerturbation(scene, area), scene_(scene) {}
  std::string_view name() const override { return "half-vector"; }

 private:
  std::optional<Span> span_of(const Path& path) const override;

  const Scene& scene_;
};

}  // namespace ajar
