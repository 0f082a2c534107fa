#pragma once
#include "core/warnings.h"
#include "scene/desc/node.h"

namespace ajar {

/// A layer of a dielectric on a metal.
struct MetalCoat {
  float eta = 1.5F;
  Vec3 depth{0.F};        ///< optical thickness along the normal
  bool is_rough = false;  ///< has facets of its own, as the caller knows
};

/// The metal `conductor`, a node of that model with colours as its indices, under a coat as formats
/// have it that lay one on any material: the metal has the reflectance that it has in air, so its
/// indices grow with that of the coat, and light meets it once. Deviations in weakening are a
/// warning at `where`.
desc::Node coated_metal(const desc::Node& conductor, const MetalCoat& coat,
                        const SourceLocation& where, Warnings& warnings);

}  // namespace ajar
