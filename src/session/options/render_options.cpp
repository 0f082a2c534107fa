#include "session/options/render_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.h"
#include "core/number_text.h"
#include "image/tone_curve.h"
#include "integrator/integrator.h"
#include "post/denoise/denoiser.h"
#include "session/options/filter_option.h"
#include "session/options/limits.h"
#include "session/preview/tcp_stream.h"
#include "session/scenes/catalog.h"

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;
using S = RenderSpec;
using Check = decltype(RenderOption::check);
using Read = decltype(RenderOption::read);

/// Reads a text by `parse(flag, text, more…)`.
template <typename Class, typename Value, typename Parse, typename... More>
Read reads(Value Class::*member, Parse parse, More... more) {
  return [=](S& spec, const std::string& flag, const std::string& text) {
    spec.*member = parse(flag, text, more...);
  };
}

template <typename Number>
Number parse_whole_number(const std::string& flag, const std::string& text,
                          const Limits<Number>& limits) {
  return parse_whole(flag, text, limits);
}

/// Decimal digits only: a seed that is silently changed would give a picture that another seed
/// gives too.
std::uint64_t parse_seed(const std::string& flag, const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || stopped != end) {
    throw UsageError(flag + ": \"" + text +
                     "\" is not a whole number from 0 to 18446744073709551615");
  }
  return seed;
}

void read_target(S& spec, const std::string& flag, const std::string& text) {
  const TargetError target = parse_target_error(flag, text);
  spec.target_error = target.value;
  spec.denoised_target = target.is_denoised;
}

void read_resolution(S& spec, const std::string& flag, const std::string& text) {
  const Vec2i size = parse_resolution(flag, text);
  spec.resolution = {size.x, size.y};
}

void read_depth(S& spec, const std::string& flag, const std::string& text) {
  const DepthRange range = parse_depth(flag, text);
  spec.min_depth = range.minimum;
  spec.max_depth = range.maximum;
}

/// KEY=VALUE, of which the last stays.
template <typename Class>
Read assigns(std::map<std::string, std::string> Class::*member) {
  return [=](S& spec, const std::string& flag, const std::string& text) {
    for (const auto& [key, value] : parse_assignments(flag, {text})) (spec.*member)[key] = value;
  };
}

template <typename Class, typename Number>
Check is_within(std::optional<Number> Class::*member, const Limits<Number>& limits) {
  return [=](const S& spec, const std::string& name) {
    if (spec.*member) check_within(limits, *(spec.*member), name);
  };
}

template <typename Class, typename Number>
Check is_within(Number Class::*member, const Limits<Number>& limits) {
  return [=](const S& spec, const std::string& name) { check_within(limits, spec.*member, name); };
}

/// Lets `check` look at a text that is given.
template <typename Class, typename Look>
Check is_known(std::string Class::*member, Look look) {
  return [=](const S& spec, const std::string& /*name*/) {
    if (!(spec.*member).empty()) look(spec.*member);
  };
}

void check_depths(const S& spec, const std::string& name) {
  is_within(&S::min_depth, limits::kDepth)(spec, name);
  if (spec.min_depth && spec.max_depth && *spec.min_depth > *spec.max_depth) {
    throw UsageError(fmt::format("{}: must be at most max_depth, {}, not {}", name, *spec.max_depth,
                                 *spec.min_depth));
  }
}

void check_resolution(const S& spec, const std::string& name) {
  if (!spec.resolution) return;
  for (const int side : *spec.resolution) check_within(limits::kResolution, side, name);
}

void check_crop(const S& spec, const std::string& name) {
  if (!spec.crop) return;
  for (const int edge : *spec.crop) check_within(limits::kCropEdge, edge, name);
  const auto [x0, y0, x1, y1] = *spec.crop;
  if (x1 <= x0 || y1 <= y0) {
    throw UsageError(
        name + ": x0, y0, x1, y1 are pixels from the top left corner, with x0 < x1 and y0 < y1");
  }
}

void check_share(const S& spec, const std::string& name) {
  if (spec.share.index >= spec.share.count || spec.share.count > kMostShares) {
    throw UsageError(fmt::format("{}: there is no share {} of {}", name, spec.share.index + 1,
                                 spec.share.count));
  }
}

void check_denoiser(const std::string& name) {
  const auto names = denoiser_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw UsageError(unknown_name_message("denoiser", name, names));
  }
}

template <typename Entries>
std::vector<std::string> names_of(const Entries& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  return names;
}

constexpr unsigned kRun = commands::kRender | commands::kResume;
constexpr unsigned kShow = kRun | commands::kMerge | commands::kDenoise;

std::vector<RenderOption> options_of_scenes() {
  return {{.name = "definitions",
           .member = &S::definitions,
           .help =
               "Give a parameter that the scene leaves open a value ($NAME in scenes of Mitsuba); "
               "may be given several times",
           .is_kept = true,
           .flags = "-D,--define",
           .value_name = "NAME=VALUE",
           .group = OptionGroup::Scene,
           .commands = commands::kScene,
           .may_repeat = true,
           .read = assigns(&S::definitions)}};
}

/// Pictures as files, and how they are shown.
std::vector<RenderOption> options_of_files() {
  const auto denoisers = denoiser_names();
  return {
      {.name = "outputs",
       .member = &S::outputs,
       .help = "Picture to write; may be given several times. The extension decides: .exr "
               "(scene-linear, all layers), .png .jpg (tone-mapped), .pfm .hdr",
       .is_kept = true,
       .flags = "-o,--output",
       .value_name = "FILE",
       .group = OptionGroup::Pictures,
       .commands = kShow,
       .may_repeat = true,
       .read = [](S& spec, const std::string& /*flag*/,
                  const std::string& text) { spec.outputs.push_back(text); }},
      {.name = "tone_map",
       .member = &S::tone_map,
       .help = "Curve of .png and .jpg: srgb or filmic",
       .default_text = "srgb",
       .is_kept = true,
       .check = is_known(&S::tone_map, tone_map_by_name),
       .flags = "--tone-map",
       .value_name = "NAME",
       .group = OptionGroup::Pictures,
       .commands = kShow,
       .choices = {"srgb", "filmic"}},
      {.name = "exposure",
       .member = &S::exposure,
       .help = "Brighten .png and .jpg by this many stops, or auto: as suits the picture",
       .default_text = "0",
       .is_kept = true,
       .check =
           [](const S& spec, const std::string& name) {
             if (spec.exposure) check_within(limits::kStops, spec.exposure->stops, name);
           },
       .flags = "--exposure",
       .value_name = "STOPS|auto",
       .group = OptionGroup::Pictures,
       .commands = kShow,
       .choices = {"auto"},
       .read = reads(&S::exposure, parse_exposure)},
      {.name = "denoise",
       .member = &S::denoise,
       .help = fmt::format("Take the noise out of .png and .jpg; .exr keeps both. One of {} (auto: "
                           "Open Image Denoise where it is found, else builtin)",
                           fmt::join(denoisers, ", ")),
       .default_text = "auto",
       .in_settings = true,
       .is_kept = true,
       .check = is_known(&S::denoise, check_denoiser),
       .flags = "--denoise",
       .value_name = "HOW",
       .group = OptionGroup::Pictures,
       .commands = kShow,
       .choices = {denoisers.begin(), denoisers.end()}},
      {.name = "output_every",
       .member = &S::output_every,
       .help = "Also write the pictures while rendering, such as every 30s",
       .flags = "--output-every",
       .value_name = "TIME",
       .group = OptionGroup::Pictures,
       .commands = kRun,
       .read = reads(&S::output_every, parse_duration)},
      {.name = "preview",
       .member = &S::preview,
       .help = "Show the picture while it is rendered in a viewer that speaks tev's protocol, such "
               "as localhost:14158; without one, --output-every keeps a picture to look at",
       .flags = "--preview",
       .value_name = "HOST:PORT",
       .group = OptionGroup::Pictures,
       .commands = kRun,
       .read = [](S& spec, const std::string& flag, const std::string& text) {
         parse_viewer(flag, text);
         spec.preview = text;
       }}};
}

std::vector<RenderOption> options_of_pixels() {
  return {
      {.name = "resolution",
       .member = &S::resolution,
       .help = "Size of the picture in pixels, such as 640x480",
       .in_settings = true,
       .decides_picture = true,
       .check = check_resolution,
       .flags = "--resolution",
       .value_name = "WxH",
       .group = OptionGroup::Pictures,
       .commands = commands::kRender | commands::kView,
       .may_be_empty = true,
       .read = read_resolution},
      {.name = "scale",
       .member = &S::scale,
       .help = "Multiply the scene's own resolution, such as 0.5",
       .in_settings = true,
       .decides_picture = true,
       .check = is_within(&S::scale, limits::kScale),
       .flags = "--scale",
       .value_name = "F",
       .group = OptionGroup::Pictures,
       .commands = commands::kRender | commands::kView,
       .excludes = "--resolution",
       .read = reads(&S::scale, parse_number, "times the scene's own size", limits::kScale)},
      {.name = "crop",
       .member = &S::crop,
       .help = "Render only this window, from the top left: fractions if all are at most 1, else "
               "pixels",
       .in_settings = true,
       .decides_picture = true,
       .check = check_crop,
       .flags = "--crop",
       .value_name = "X0,Y0,X1,Y1",
       .group = OptionGroup::Pictures,
       .commands = commands::kRender | commands::kView,
       .may_be_empty = true,
       .read = reads(&S::crop_window, parse_crop)},
      {.name = "filter",
       .member = &S::filter,
       .help = "Filter of the film instead of the scene's: box, triangle, gaussian, mitchell or "
               "sinc, and its radius in pixels",
       .default_text = "the scene's",
       .in_settings = true,
       .is_kept = true,
       .decides_picture = true,
       .check = is_known(&S::filter, [](const auto& text) { parse_filter("filter", text); }),
       .flags = "--filter",
       .value_name = "NAME[:RADIUS]",
       .group = OptionGroup::Pictures,
       .commands = commands::kRender | commands::kView,
       .may_be_empty = true,
       .read =
           [](S& spec, const std::string& flag, const std::string& text) {
             parse_filter(flag, text);
             spec.filter = text;
           }},
      {.name = "layers",
       .member = &S::layers,
       .help = "Extra layers for .exr files, or all (see: ajar list aovs)",
       .in_settings = true,
       .is_kept = true,
       .decides_picture = true,
       .check = [](const S& spec, const std::string& /*name*/) { checked_aovs(spec.layers); },
       .flags = "--aov",
       .value_name = "LIST",
       .group = OptionGroup::Pictures,
       .commands = commands::kRender,
       .may_be_empty = true,
       .choices = names_of(aovs()),
       .read =
           [](S& spec, const std::string& /*flag*/, const std::string& text) {
             spec.layers = parse_list(text);
             checked_aovs(spec.layers);
           }}};
}

std::vector<RenderOption> options_of_budget() {
  return {
      {.name = "samples_per_pixel",
       .member = &S::samples_per_pixel,
       .help = "Samples per pixel (rounded up to equal replicates)",
       .in_settings = true,
       .is_kept = true,
       .check = is_within(&S::samples_per_pixel, limits::kSamples),
       .flags = "--spp",
       .value_name = "N",
       .group = OptionGroup::Stop,
       .commands = kRun,
       .read = reads(&S::samples_per_pixel, parse_whole_number<std::uint64_t>, limits::kSamples)},
      {.name = "seconds",
       .member = &S::seconds,
       .help = "Time until the finished picture is there, such as 60s, 2m or 1h30m",
       .in_settings = true,
       .is_kept = true,
       .check = is_within(&S::seconds, limits::kSeconds),
       .flags = "--time",
       .value_name = "TIME",
       .group = OptionGroup::Stop,
       .commands = kRun,
       .read = reads(&S::seconds, parse_duration)},
      {.name = "target_error",
       .member = &S::target_error,
       .help = "Estimated relative error of the picture, such as 0.01 or 1%; denoised:1%: of the "
               "denoised picture",
       .in_settings = true,
       .is_kept = true,
       .check = is_within(&S::target_error, limits::kRelativeError),
       .flags = "--target-error",
       .value_name = "[denoised:]X",
       .group = OptionGroup::Stop,
       .commands = kRun,
       .read = read_target},
      {.name = "denoised_target",
       .member = &S::denoised_target,
       .help = "Whether target_error is of the denoised picture",
       .in_settings = true,
       .is_kept = true,
       .group = OptionGroup::Stop,
       .commands = kRun}};
}

std::vector<RenderOption> options_of_method() {
  return {
      {.name = "integrator",
       .member = &S::integrator,
       .help = "Rendering method (see: ajar list integrators)",
       .in_settings = true,
       .decides_picture = true,
       .check = is_known(&S::integrator, find_integrator),
       .flags = "--integrator",
       .value_name = "NAME",
       .group = OptionGroup::Method,
       .commands = commands::kRender | commands::kView,
       .choices = names_of(integrators()),
       .read =
           [](S& spec, const std::string& /*flag*/, const std::string& text) {
             find_integrator(text);
             spec.integrator = text;
           }},
      {.name = "parameters",
       .member = &S::parameters,
       .help = "Set a parameter of the method (see: ajar list integrators NAME); may be given "
               "several times",
       .in_settings = true,
       .decides_picture = true,
       .flags = "--set",
       .value_name = "KEY=VALUE",
       .group = OptionGroup::Method,
       .commands = commands::kRender | commands::kView,
       .may_repeat = true,
       .read = assigns(&S::parameters)},
      {.name = "min_depth",
       .member = &S::min_depth,
       .help = "Least length of a path in edges",
       .in_settings = true,
       .decides_picture = true,
       .check = check_depths},
      {.name = "max_depth",
       .member = &S::max_depth,
       .help = "Path lengths in edges: 1 is light seen directly, 2 direct lighting, such as 1:8",
       .in_settings = true,
       .decides_picture = true,
       .check = is_within(&S::max_depth, limits::kDepth),
       .flags = "--depth",
       .value_name = "MIN:MAX",
       .group = OptionGroup::Method,
       .commands = commands::kRender | commands::kView,
       .may_be_empty = true,
       .read = read_depth},
      {.name = "seed",
       .member = &S::seed,
       .help = "Seed of the random numbers",
       .default_text = "0",
       .in_settings = true,
       .decides_picture = true,
       .flags = "--seed",
       .value_name = "N",
       .group = OptionGroup::Method,
       .commands = commands::kRender | commands::kView,
       .read = reads(&S::seed, parse_seed)}};
}

std::vector<RenderOption> options_of_checkpoints() {
  return {
      {.name = "checkpoint",
       .member = &S::checkpoint,
       .help = "Keep in this file all that is needed to go on (ajar resume FILE)",
       .in_settings = true,
       .flags = "--checkpoint",
       .value_name = "FILE",
       .group = OptionGroup::Safety,
       .commands = kRun | commands::kMerge},
      {.name = "checkpoint_every",
       .member = &S::checkpoint_every,
       .help = "How often to write it",
       .default_text = "60s",
       .in_settings = true,
       .check = is_within(&S::checkpoint_every, limits::kSeconds),
       .flags = "--checkpoint-every",
       .value_name = "TIME",
       .group = OptionGroup::Safety,
       .commands = kRun,
       .read = reads(&S::checkpoint_every, parse_duration)},
      {.name = "force",
       .member = &S::force,
       .help = "Go on even if another version of ajar wrote the checkpoint, or the scene has moved",
       .flags = "--force",
       .group = OptionGroup::Safety,
       .commands = kRun | commands::kMerge},
      {.name = "resume",
       .member = &S::resume,
       .help = "Go on with the checkpoint if it is there",
       .in_settings = true},
      {.name = "resume_from",
       .member = &S::resume_from,
       .help = "Go on with this checkpoint of the same render; begin anew if there is none",
       .flags = "--resume",
       .value_name = "FILE",
       .group = OptionGroup::Safety,
       .commands = commands::kRender}};
}

std::vector<RenderOption> options_of_program() {
  return {
      {.name = "threads",
       .member = &S::threads,
       .help = "Threads to use; 0: all processors",
       .default_text = "0",
       .in_settings = true,
       .check = is_within(&S::threads, limits::kThreads),
       .flags = "--threads",
       .value_name = "N",
       .commands = kRun | commands::kView,
       .read = reads(&S::threads, parse_whole_number<int>, limits::kThreads)},
      {.name = "statistics",
       .member = &S::statistics,
       .help = "Write statistics as JSON",
       .flags = "--stats",
       .value_name = "FILE.json",
       .commands = kRun | commands::kMerge},
      {.name = "share",
       .member = &S::share,
       .help = "Render only the K-th of N parts of the work, for ajar merge; needs --checkpoint",
       .is_kept = true,
       .decides_picture = true,
       .check = check_share,
       .flags = "--share",
       .value_name = "K/N",
       .commands = commands::kRender,
       .read = reads(&S::share, parse_share)}};
}

Json json_of(const Exposure& exposure) {
  // Stops are decimal for those who read them, not what a float makes of them.
  return {{"stops", decimal_of(exposure.stops)}, {"auto", exposure.automatic}};
}
Json json_of(const WorkSlice& share) { return {share.index + 1, share.count}; }
template <typename Value>
Json json_of(const Value& value) {
  return value;
}
Json json_of(const std::string& text) { return text.empty() ? Json() : Json(text); }
template <typename Value>
Json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json();
}

}  // namespace

const std::vector<RenderOption>& render_options() {
  static const std::vector<RenderOption> kOptions = [] {
    std::vector<RenderOption> all;
    for (auto* const part :
         {options_of_scenes, options_of_files, options_of_pixels, options_of_budget,
          options_of_method, options_of_checkpoints, options_of_program}) {
      for (RenderOption& option : part()) all.push_back(std::move(option));
    }
    return all;
  }();
  return kOptions;
}

void read_option(const RenderOption& option, RenderSpec& spec, const std::string& text) {
  if (option.read) {
    option.read(spec, option.flags.substr(0, option.flags.find(',')), text);
  } else if (const auto* const flag = std::get_if<bool S::*>(&option.member)) {
    spec.** flag = true;
  } else {
    spec.*std::get<std::string S::*>(option.member) = text;
  }
}

bool is_given(const RenderOption& option, const RenderSpec& spec) {
  static const RenderSpec kEmpty;
  return std::visit([&](auto member) { return spec.*member != kEmpty.*member; }, option.member);
}

void copy_option(const RenderOption& option, const RenderSpec& from, RenderSpec& to) {
  std::visit([&](auto member) { to.*member = from.*member; }, option.member);
}

Json option_json(const RenderOption& option, const RenderSpec& spec) {
  return std::visit([&](auto member) { return json_of(spec.*member); }, option.member);
}

std::string option_text(const RenderOption& option, const RenderSpec& spec) {
  const Json json = option_json(option, spec);
  if (std::holds_alternative<WorkSlice S::*>(option.member)) {
    return fmt::format("{}/{}", spec.share.index + 1, spec.share.count);
  }
  if (!is_given(option, spec)) return option.default_text.empty() ? "none" : option.default_text;
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_array()) return json.dump();
  std::string text;
  for (const Json& item : json) {
    text += (text.empty() ? "" : ",") + (item.is_string() ? item.get<std::string>() : item.dump());
  }
  return text;
}

void check_options(const RenderSpec& spec, bool RenderOption::*which) {
  for (const RenderOption& option : render_options()) {
    if (option.*which && option.check) option.check(spec, option.name);
  }
}

}  // namespace ajar
