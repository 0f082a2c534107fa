#include "session/render/render_plan.h"

#include <utility>

#include "core/error.h"
#include "integrator/make_filter.h"
#include "os/available_memory.h"
#include "session/options/filter_option.h"

namespace ajar {

namespace {

ResolvedRender choose_setup(const RenderRequest& request, const desc::SceneDesc& description) {
  if (request.as_before) return setup_of(request.resumed->render, request.spec.budget());
  ResolvedRender setup = resolve_render(request.spec, description.hints, description.film);
  setup.settings.for_filters = request.spec.denoiser_name() != "none";
  if (request.resumed) {
    setup.settings.replicates = request.resumed->render.settings.replicates;
    setup.settings.for_filters = request.resumed->render.settings.for_filters;
    check_budget(setup.budget, setup.settings.replicates);
  }
  return setup;
}

Parameters read_parameters(const ResolvedRender& setup) {
  try {
    return setup.integrator->read(setup.parameters);
  } catch (const UsageError& error) {
    // The scene may have chosen it.
    throw UsageError("integrator " + setup.integrator->name + ": " + error.what());
  }
}

}  // namespace

void change_film(const RenderRequest& request, desc::SceneDesc& description) {
  const std::string& filter = request.spec.filter;
  if (!filter.empty()) description.film.filter = parse_filter("--filter", filter);
}

RenderPlan make_plan(const RenderRequest& request, const desc::SceneDesc& description) {
  ResolvedRender setup = choose_setup(request, description);
  if (request.spec.share.count > 1 && setup.budget.target_error) {
    throw UsageError("--target-error cannot go with a share: all shares need the same samples");
  }
  if (setup.budget.target_error && setup.budget.denoised_target &&
      request.spec.denoiser_name() == "none") {
    throw UsageError("--target-error denoised:X needs a filter (--denoise auto, oidn or builtin)");
  }
  Parameters parameters = read_parameters(setup);
  RenderRecord record = record_of(setup, parameters, request.scene, request.spec);
  record.film_scale = static_cast<double>(description.film.scale);
  if (request.resumed) check_same_render(request.resumed->render, record, request.resumed_from);
  return {std::move(setup), std::move(parameters), std::move(record),
          make_filter(description.film.filter)};
}

MemoryEstimate memory_of(const RenderPlan& plan, const RenderRequest& request,
                         const std::vector<LayerSpec>& layers) {
  MemoryEstimate estimate;
  const ResolvedRender& setup = plan.setup;
  const int replicates = setup.settings.replicates;
  // The root of several ranks has the sum beside its own part, a preview develops a copy.
  const std::uint64_t films =
      1U + (request.ranks != nullptr ? 1U : 0U) + (request.spec.preview.empty() ? 0U : 1U);
  estimate.film = films * film_bytes(setup.crop, replicates, layers);
  estimate.pictures = picture_bytes(setup.crop, replicates, layers, setup.aovs);
  return estimate;
}

void check_memory(const MemoryEstimate& estimate, const RenderRequest& request,
                  const SourceLocation& film) {
  const std::string complaint = memory_complaint(estimate, available_memory_bytes());
  if (complaint.empty()) return;
  if (!request.as_before && !request.spec.has_size()) throw SceneError(film, complaint);
  throw UsageError(complaint);
}

}  // namespace ajar
