#pragma once
#include "scene/material/material.h"

namespace ajar {

/// No surface at all, only a change of medium.
class Interface final : public Material {
 public:
  void add_lobes(const SurfacePoint&, const Spectrum&, Bsdf&) const override {}
  int max_lobes() const override { return 0; }
  bool is_interface() const override { return true; }
};

}  // namespace ajar
