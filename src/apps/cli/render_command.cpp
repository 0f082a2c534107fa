#include <charconv>
#include <filesystem>
#include <utility>

#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "apps/cli/render_run.h"
#include "core/error.h"
#include "session/options/filter_option.h"
#include "session/options/option_values.h"
#include "session/render/render_setup.h"
#include "session/scenes/catalog.h"

namespace ajar::cli {

namespace {

/// Decimal digits only: a seed that is silently changed would give a picture that another seed
/// gives too.
std::uint64_t parse_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || stopped != end) {
    throw UsageError("--seed: \"" + text +
                     "\" is not a whole number from 0 to 18446744073709551615");
  }
  return seed;
}

RenderRequest request_of(const RenderArguments& a, const Budget& budget) {
  RenderRequest request;
  request.integrator = a.integrator;
  if (!a.integrator.empty()) find_integrator(a.integrator);
  request.parameters = parse_assignments("--set", a.assignments);
  request.budget = budget;
  if (!a.depth.empty()) request.depth = parse_depth("--depth", a.depth);
  if (!a.resolution.empty()) request.resolution = parse_resolution("--resolution", a.resolution);
  request.scale = a.scale;
  if (!a.crop.empty()) request.crop = parse_crop("--crop", a.crop);
  if (!a.filter.empty()) parse_filter("--filter", a.filter);
  request.filter = a.filter;
  request.aovs = checked_aovs(parse_list(a.aovs));
  request.seed = parse_seed(a.seed);
  return request;
}

}  // namespace

int render(const RenderArguments& a) {
  RenderOrder order = order_of(a.run);
  order.scene = a.scene.scene;
  order.definitions = parse_assignments("-D", a.scene.definitions);
  if (order.files.denoiser.empty()) order.files.denoiser = "auto";
  order.request = request_of(a, order.budget);
  order.all_aovs = parse_list(a.aovs) == std::vector<std::string>{"all"};
  order.size_from_scene = a.resolution.empty() && !a.scale;
  if (!a.share.empty()) {
    order.share = parse_share("--share", a.share);
    if (a.run.checkpoint.empty()) {
      throw UsageError("--share needs --checkpoint: a share is of no use but for ajar merge");
    }
    if (a.run.target_error) {
      throw UsageError("--share cannot go with --target-error: all shares need the same samples");
    }
  }
  lock_checkpoint_of(order);
  if (!a.resume.empty() && !resume_if_there(a.resume, order)) {
    print_note("there is no " + a.resume + " yet: the render begins anew");
  }
  return carry_out(std::move(order), a.run.progress);
}

int resume(const ResumeArguments& a) {
  RenderOrder order = order_of(a.run);
  order.scene = a.scene;
  resume_from(a.checkpoint, order);
  return carry_out(std::move(order), a.run.progress);
}

}  // namespace ajar::cli
