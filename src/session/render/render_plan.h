#pragma once
#include <vector>

#include "core/parameters.h"
#include "image/filter.h"
#include "session/render/memory_estimate.h"
#include "session/render/render_request.h"
#include "session/render/resolved_render.h"

namespace ajar {

/// Resolved settings of an order for a scene: all decisions before the scene is built.
struct RenderPlan {
  ResolvedRender setup;
  Parameters parameters;  ///< all parameters of the integrator
  RenderRecord record;    ///< without the scene's hash
  Filter filter;
};

/// Puts in what the user wants of the film instead of what the file says. Raises UsageError.
void change_film(const RenderRequest& request, desc::SceneDesc& description);
/// Raises UsageError for what cannot be, SceneError if that is the scene's fault.
RenderPlan make_plan(const RenderRequest& request, const desc::SceneDesc& description);

/// Memory of a film with these layers and its buffers.
MemoryEstimate memory_of(const RenderPlan& plan, const RenderRequest& request,
                         const std::vector<LayerSpec>& layers);

/// Raises an error if that is more than there is: UsageError if the user chose the size, SceneError
/// at `film` if the scene did.
void check_memory(const MemoryEstimate& estimate, const RenderRequest& request,
                  const SourceLocation& film);

}  // namespace ajar
