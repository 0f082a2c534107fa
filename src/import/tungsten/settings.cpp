#include "import/tungsten/settings.h"

#include <algorithm>
#include <array>

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnknownIntegrator{Effect::Slight,
                                         "integrators are unknown: others stand in"};
constexpr WarningKind kMinimum{Effect::Light,
                               "integrators leave short paths out, which is not supported"};
constexpr WarningKind kPartOfLight{Effect::Light,
                                   "integrators leave out a part of light: not supported"};
constexpr WarningKind kOneSided{Effect::Surface,
                                "surfaces are to be black from behind, which is not supported"};
constexpr WarningKind kSampleCount{Effect::Slight, "numbers of samples are below 1 and ignored"};

struct IntegratorName {
  std::string_view theirs;
  std::string_view ours;
};
constexpr std::array<IntegratorName, 10> kIntegrators = {{{"path_tracer", "pt"},
                                                          {"path_trace", "pt"},
                                                          {"ray_stream", "pt"},
                                                          {"light_tracer", "lt"},
                                                          {"photon_map", "sppm"},
                                                          {"progressive_photon_map", "sppm"},
                                                          {"bidirectional_path_tracer", "bdpt"},
                                                          {"kelemen_mlt", "pssmlt"},
                                                          {"multiplexed_mlt", "mmlt"},
                                                          {"reversible_jump_mlt", "mmlt"}}};

constexpr int kMostBounces = 1000000;

}  // namespace

void read_integrator(Context& context, const LocatedJson& json) {
  const ObjectReader object(context, json, "an integrator");
  desc::RenderHints& hints = context.scene.hints;
  const std::string type = object.text("type").value_or("path_tracer");
  const auto* known = std::find_if(kIntegrators.begin(), kIntegrators.end(),
                                   [&](const IntegratorName& n) { return n.theirs == type; });
  if (known != kIntegrators.end()) {
    hints.integrator = known->ours;
  } else {
    std::vector<std::string> names;
    for (const IntegratorName& name : kIntegrators) names.emplace_back(name.theirs);
    context.warnings.add(
        kUnknownIntegrator, json.where(),
        unknown_name_message("integrator", printable(type), names) + ". Another stands in",
        printable(type));
  }
  // A path that meets one surface, a light, has one bounce for Tungsten, and one edge.
  const int bounces = object.integer("max_bounces").value_or(kUsualPathBounces);
  if (bounces < 0 || bounces > kMostBounces) {
    throw SceneError(json.where(),
                     "\"max_bounces\" of " + std::to_string(bounces) + " makes no sense");
  }
  hints.max_depth = std::max(bounces, 1);
  if (object.integer("min_bounces").value_or(0) > 0) {
    context.warnings.add(kMinimum, json.where(),
                         "\"min_bounces\" is not supported: all paths are there. Use --depth");
  }
  if (!object.flag("enable_two_sided_shading").value_or(true)) {
    context.scene.warnings_if_seen.push_back(
        {desc::WarningIfSeen::If::FromBehind,
         desc::kNone,
         0.F,
         {kOneSided, json.where(),
          "\"enable_two_sided_shading\" cannot be false: surfaces look the same from behind"}});
  }
  for (const char* name : {"low_order_scattering", "include_surfaces"}) {
    if (object.flag(name).value_or(true)) continue;
    context.warnings.add(kPartOfLight, json.where(),
                         "\"" + std::string(name) + "\" cannot be false: all light is rendered");
  }
  // Parameters of single methods.
  object.accept({"enable_light_sampling",
                 "enable_volume_light_sampling",
                 "enable_consistency_checks",
                 "initial_sample_pool",
                 "bidirectional",
                 "large_step_probability",
                 "large_step_prob",
                 "image_pyramid",
                 "enable_jump",
                 "photon_count",
                 "volume_photon_count",
                 "gather_photon_count",
                 "gather_radius",
                 "volume_gather_radius",
                 "alpha",
                 "fixed_volume_radius",
                 "volume_photon_type",
                 "use_grid",
                 "use_frustum_grid",
                 "grid_memory"});
  object.report_unknown();
}

void read_renderer(Context& context, const LocatedJson& json) {
  const ObjectReader object(context, json, "a renderer");
  desc::RenderHints& hints = context.scene.hints;
  if (const std::optional<int> samples = object.integer("spp")) {
    if (*samples >= 1) {
      hints.samples_per_pixel = samples;
    } else {
      context.warnings.add(kSampleCount, json.where(),
                           "the number of samples must be 1 or more: ignored");
    }
  }
  if (const std::optional<bool> stratified = object.flag("stratified_sampler")) {
    hints.sampler = *stratified ? "sobol" : "independent";
  }
  const std::optional<std::string> usual = object.text("output_file");
  const std::optional<std::string> linear = object.text("hdr_output_file");
  if (linear && !linear->empty()) {
    context.scene.film.filename = *linear;
  } else if (usual) {
    context.scene.film.filename = *usual;
  }
  object.accept({"output_directory", "variance_output_file", "resume_render_file",
                 "overwrite_output_files", "adaptive_sampling", "enable_resume_render", "scene_bvh",
                 "spp_step", "checkpoint_interval", "timeout", "output_buffers"});
  object.report_unknown();
}

}  // namespace ajar::tungsten
