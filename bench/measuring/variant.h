#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "integrator/integrator.h"
#include "session/render/render_request.h"

namespace ajar::bench {

/// An integrator with settings, as benchmarks compare them.
struct Variant {
  std::string text;  ///< as written by the user
  const IntegratorInfo* integrator;
  Parameters parameters;

  std::unique_ptr<Integrator> make(const Scene& scene, const RenderSettings& settings) const {
    return integrator->make(scene, settings, parameters);
  }
};

/// A render of such a scene by a variant, as `ajar render --time` makes it.
RenderRequest order_of(const Variant& variant, desc::SceneDesc description,
                       const RenderSettings& settings, double seconds);

/// `bdpt` or `bdpt:heuristic=balance,roulette-start=8`. A piece between commas that has no `=`
/// belongs to the value before it, so that lists can be values. Raises UsageError.
Variant parse_variant(const std::string& text);

std::vector<Variant> parse_variants(const std::vector<std::string>& texts);

}  // namespace ajar::bench
