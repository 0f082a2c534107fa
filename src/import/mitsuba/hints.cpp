#include <algorithm>
#include <array>

#include "import/common/printable.h"
#include "import/mitsuba/sensor.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kIntegrator{Effect::None, "integrators are not supported: others stand in"};
constexpr WarningKind kSampleCount{Effect::Slight, "numbers of samples are below 1 and ignored"};
constexpr WarningKind kDepth{Effect::Slight, "depths make no sense and are ignored"};
constexpr WarningKind kHideEmitters{Effect::Surface,
                                    "lights are hidden from the camera, which is not supported"};

struct IntegratorName {
  std::string_view theirs;
  std::string_view ours;
};
/// Those that estimate in the same way. Others are left to the renderer's choice.
constexpr std::array<IntegratorName, 10> kIntegrators = {{{"path", "pt"},
                                                          {"volpath", "pt"},
                                                          {"volpath_simple", "pt"},
                                                          {"volpathmis", "pt"},
                                                          {"direct", "pt"},
                                                          {"ptracer", "lt"},
                                                          {"bdpt", "bdpt"},
                                                          {"pssmlt", "pssmlt"},
                                                          {"mlt", "mmlt"},
                                                          {"erpt", "mmlt"}}};

}  // namespace

void read_sampler(Context& context, const Element& element) {
  Arguments arguments(context, element);
  desc::RenderHints& hints = context.scene.hints;
  hints.sampler = element.type == "independent" ? "independent" : "sobol";
  if (const std::optional<long long> count = arguments.integer("sample_count")) {
    constexpr long long kMost = 1'000'000'000;
    if (*count >= 1) {
      hints.samples_per_pixel = static_cast<int>(std::min(*count, kMost));
    } else {
      context.warnings.add(kSampleCount, element.where,
                           "the number of samples must be 1 or more: ignored");
    }
  }
  // How a sampler of another kind distributes its numbers has no meaning for ours.
  arguments.accept({"seed", "scramble", "dimension", "jitter", "strength", "sample_shuffle"});
  arguments.report_unused();
}

void read_integrator(Context& context, const Element& element) {
  Arguments arguments(context, element);
  // Some integrators only watch over another.
  const std::vector<const Element*> nested = arguments.children("integrator");
  if (!nested.empty()) return read_integrator(context, *nested.front());
  desc::RenderHints& hints = context.scene.hints;
  const auto known =
      std::find_if(kIntegrators.begin(), kIntegrators.end(),
                   [&](const IntegratorName& name) { return name.theirs == element.type; });
  if (known != kIntegrators.end()) {
    hints.integrator = known->ours;
  } else {
    std::vector<std::string> valid;
    for (const IntegratorName& name : kIntegrators) valid.emplace_back(name.theirs);
    context.warnings.add(
        kIntegrator, element.where,
        unknown_name_message("integrator", printable(element.type), valid) + ". Another stands in",
        printable(element.type));
  }
  // Both count edges; -1 is no limit.
  const std::optional<long long> depth = arguments.integer("max_depth");
  if (element.type == "direct") hints.max_depth = 2;
  if (depth && *depth >= 1 && *depth <= 1'000'000) {
    hints.max_depth = static_cast<int>(*depth);
  } else if (depth && *depth != -1) {
    context.warnings.add(kDepth, element.where,
                         "\"max_depth\" of " + std::to_string(*depth) + " makes no sense: ignored");
  }
  if (arguments.flag("hide_emitters", false)) {
    context.warnings.add(kHideEmitters, element.where,
                         "\"hide_emitters\" is not supported: lights can be seen");
  }
  // What only the methods themselves know.
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
  if (known == kIntegrators.end()) arguments.accept_all();
  arguments.report_unused();
}

}  // namespace ajar::mitsuba
