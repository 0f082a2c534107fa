#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "integrator/integrator.h"
#include "scene/desc/scene_desc.h"
#include "session/checkpoint/checkpoint.h"
#include "session/job/budget.h"
#include "session/options/render_spec.h"

namespace ajar {

/// Specification and scene's wishes put together, complete and checked.
struct ResolvedRender {
  static constexpr int kDefaultSamples = 64;
  static constexpr int kReplicates = 4;

  const IntegratorInfo* integrator = nullptr;
  std::map<std::string, std::string> parameters;  ///< given ones
  Budget budget;
  RenderSettings settings;
  std::vector<std::string>
      aovs;  ///< all asked for; `settings.aovs` has those that the integrator gathers
  Vec2i resolution{0, 0};
  Box2i crop;
  std::vector<std::string> notes;  ///< choices made for the user, one sentence each
};

/// Raises UsageError for what cannot be.
ResolvedRender resolve_render(const RenderSpec& spec, const desc::RenderHints& hints,
                              const desc::Film& film);

/// Raises UsageError for limits that cannot be, or cannot be with so many replicates.
void check_budget(const Budget& budget, int replicates);
/// The setup of a render that goes on. Raises UsageError if this program has no such integrator.
ResolvedRender setup_of(const RenderRecord& record, const Budget& budget);
/// Record of a setup and of `spec`, for checkpoints; `parameters` are the integrator's.
RenderRecord record_of(const ResolvedRender& setup, const Parameters& parameters,
                       const std::string& scene, RenderSpec spec);

/// For the whole picture of a scene that was built, all else as by default.
RenderSettings settings_for(const Scene& scene);
/// The film for what an integrator that is prepared makes of a scene.
Film film_for(const Scene& scene, const RenderSettings& settings, const Integrator& integrator);

/// Raises UsageError if a layer that was asked for is not among `layers`, which the integrator
/// makes.
void check_layers(const ResolvedRender& setup, const std::vector<LayerSpec>& layers);

}  // namespace ajar
