#include <algorithm>
#include <array>

#include "core/printable_text.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/sensor.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kIntegrator{Effect::None, "integrators are not supported: others stand in"};
constexpr WarningKind kSampler{Effect::None, "samplers are unknown: another stands in"};
constexpr WarningKind kSampleCount{Effect::Slight, "numbers of samples are below 1 and ignored"};
constexpr WarningKind kDepth{Effect::Slight, "depths make no sense and are ignored"};

constexpr WarningKind kHideEmitters{
    Effect::Slight, "lights are hidden from the camera as in Mitsuba 3: not black, but not there"};

constexpr std::array<IntegratorName, 10> kIntegrators = {{{"path", "pt"},
                                                          {"volpath", "pt"},
                                                          {"volpath_simple", "pt"},
                                                          {"volpathmis", "pt"},
                                                          {"direct", "pt"},
                                                          {"ptracer", "lt"},
                                                          {"bdpt", "bdpt"},
                                                          {"pssmlt", "pssmlt"},
                                                          {"mlt", "mlt"},
                                                          {"erpt", "erpt"}}};

const IntegratorName* find_integrator(std::string_view type) {
  const auto found = std::find_if(kIntegrators.begin(), kIntegrators.end(),
                                  [&](const IntegratorName& name) { return name.theirs == type; });
  return found == kIntegrators.end() ? nullptr : &*found;
}

/// Warns of the replacement of an unknown one, and reads its nested one.
const Element& read_unknown(Arguments& arguments) {
  Context& context = arguments.context();
  const Element& element = arguments.element();
  const Element* nested = arguments.only_child("integrator");
  context.warnings.add(kIntegrator, element.where,
                       nested != nullptr ? "integrator \"" + printable(element.type) +
                                               "\" is not supported: only that in it is used"
                                         : unknown_type_message(element) + ". Another stands in",
                       printable(element.type));
  arguments.accept_all();
  return nested != nullptr ? read_integrator(context, *nested) : element;
}

}  // namespace

std::span<const IntegratorName> integrator_names() { return kIntegrators; }

void read_sampler(Context& context, const Element& element) {
  Arguments arguments(context, element);
  desc::RenderHints& hints = context.scene.hints;
  hints.sampler = element.type == "independent" ? "independent" : "sobol";
  if (!is_known(element)) {
    context.warnings.add(kSampler, element.where,
                         unknown_type_message(element) + ". That of Sobol stands in",
                         printable(element.type));
  }
  if (const std::optional<long long> count = arguments.integer("sample_count")) {
    constexpr long long kMost = 1'000'000'000;
    if (*count >= 1) {
      hints.samples_per_pixel = static_cast<int>(std::min(*count, kMost));
    } else {
      context.warnings.add(kSampleCount, element.where,
                           "the number of samples must be 1 or more: ignored");
    }
  }
  // Options of other samplers have no meaning for ours.
  arguments.accept({"seed", "scramble", "dimension", "jitter", "strength", "sample_shuffle"});
  if (!is_known(element)) arguments.accept_all();
}

const Element& read_integrator(Context& context, const Element& element) {
  Arguments arguments(context, element);
  desc::RenderHints& hints = context.scene.hints;
  const IntegratorName* known = find_integrator(element.type);
  if (known != nullptr) hints.integrator = known->ours;
  // Both count edges; -1 is no limit.
  const std::optional<long long> depth = arguments.integer("max_depth");
  if (element.type == "direct") hints.max_depth = 2;
  if (depth && *depth >= 1 && *depth <= 1'000'000) {
    hints.max_depth = static_cast<int>(*depth);
  } else if (depth && *depth != -1) {
    context.warnings.add(kDepth, element.where,
                         "\"max_depth\" of " + std::to_string(*depth) + " makes no sense: ignored");
  }
  if (hints.max_depth) {
    // "null" events, by which light passes thin dielectrics, masks and boundaries of media. Source:
    // Mitsuba 3, volpath.cpp, volpathmis.cpp; others count every interaction.
    const bool counts_null =
        context.document.major_version == 0 || element.type.find("volpath") == std::string::npos;
    context.counts_boundaries = counts_null;
    context.counts_straight = counts_null;
  }
  desc::Camera& camera = context.scene.camera;
  camera.hides_lights = arguments.flag("hide_emitters", false);
  if (camera.hides_lights && context.document.major_version < 3) {
    context.warnings.add(
        kHideEmitters, element.where,
        "\"hide_emitters\" of this version leaves the shapes of lights black: here "
        "it is what is behind them that is seen");
  }
  // Parameters of single methods.
  arguments.accept({"rr_depth",
                    "strict_normals",
                    "shading_samples",
                    "emitter_samples",
                    "bsdf_samples",
                    "light_samples",
                    "luminaire_samples",
                    "samples_per_pass",
                    "block_size",
                    "timeout",
                    "light_image",
                    "sample_direct",
                    "bidirectional",
                    "direct_samples",
                    "separate_direct",
                    "luminance_samples",
                    "two_stage",
                    "p_large",
                    "bidirectional_mutation",
                    "lens_perturbation",
                    "multi_chain_perturbation",
                    "caustic_perturbation",
                    "manifold_perturbation",
                    "lambda",
                    "num_chains",
                    "max_chains",
                    "chain_length",
                    "granularity",
                    "brute_force"});
  return known != nullptr ? element : read_unknown(arguments);
}

}  // namespace ajar::mitsuba
