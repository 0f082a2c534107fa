#include "session/output/stats_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/number_text.h"
#include "os/atomic_file.h"
#include "session/options/render_options.h"
#include "session/version.h"

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

void add_error(const RenderResult& result, Json& json) {
  const std::optional<RelativeError>& error = result.relative_error;
  json["estimated_relative_error"] =
      number_or_null(error ? std::optional(error->value) : std::nullopt);
  json["estimated_error_is_lower_bound"] = !error || error->is_lower_bound();
}

/// "4": of the picture after a Gaussian of four pixels.
Json by_scale_json(const std::vector<ErrorAtScale>& errors) {
  Json json = Json::object();
  for (const double sigma : kErrorScales) json[fmt::format("{:g}", sigma)] = nullptr;
  for (const ErrorAtScale& error : errors) {
    json[fmt::format("{:g}", error.sigma)] = number_or_null(error.value);
  }
  return json;
}

double per_second(std::uint64_t count, double seconds) {
  return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json budget_json(const Budget& budget) {
  const auto value_or_null = [](const auto& value) { return value ? Json(*value) : Json(); };
  return {{"samples_per_pixel", value_or_null(budget.samples_per_pixel)},
          {"seconds", value_or_null(budget.seconds)},
          {"target_error", value_or_null(budget.target_error)},
          {"target_is_denoised", budget.denoised_target}};
}

std::string budget_text(const Budget& budget) {
  std::string text;
  const auto add = [&](const std::string& limit) { text += (text.empty() ? "" : ", ") + limit; };
  if (budget.samples_per_pixel) add(fmt::format("{} spp", *budget.samples_per_pixel));
  if (budget.seconds) add(fmt::format("{} s", *budget.seconds));
  if (budget.target_error) {
    add(fmt::format("{}error {}", budget.denoised_target ? "denoised " : "", *budget.target_error));
  }
  return text.empty() ? "none" : text;
}

/// Options that were given, of those that checkpoints keep.
Json options_json(const RenderSpec& spec) {
  Json json = Json::object();
  for (const RenderOption& option : render_options()) {
    if (option.is_kept) json[option.name] = option_json(option, spec);
  }
  return json;
}

/// Stops are decimal for those who read them, not what a float makes of them.
Json exposure_json(const Exposure& exposure) {
  return {{"stops", decimal_of(exposure.stops)}, {"auto", exposure.automatic}};
}

void add_counts(const Counters& counters, const Counters& preparation, Json& json) {
  for (const EventCount& count : kEventCounts) {
    std::string place = "/" + std::string(count.name);
    std::replace(place.begin(), place.end(), '.', '/');
    json[Json::json_pointer(place)] =
        counters.*count.number + (count.with_preparation ? preparation.*count.number : 0);
  }
  json["discarded"]["first"] = text_or_null(counters.first_discarded);
}

Json techniques_json(const TechniqueShares& shares) {
  Json list = Json::array();
  for (const TechniqueShares::Share& share : shares.list()) {
    list.push_back({{"s", share.technique.s},
                    {"t", share.technique.t},
                    {"light_share", share.light},
                    {"variance_share", share.variance}});
  }
  return list;
}

}  // namespace

Json to_json(const RenderStatistics& s) {
  const RenderResult& r = s.result;
  const RenderSettings& settings = s.render.settings;
  const RenderSpec& spec = s.render.spec;
  Json json;
  json["program"] = "ajar";
  json["version"] = version();
  json["scene"] = s.render.scene;
  json["scene_hash"] = fmt::format("{:016x}", s.render.scene_hash);
  json["integrator"] = s.render.integrator;
  json["parameters"] = s.render.parameters;
  json["depth"] = {{"min", settings.min_depth}, {"max", settings.max_depth}};
  json["seed"] = settings.seed;
  json["threads"] = r.threads;
  json["resolution"] = {settings.resolution.x, settings.resolution.y};
  json["crop"] = {settings.crop.min.x, settings.crop.min.y, settings.crop.max.x + 1,
                  settings.crop.max.y + 1};
  json["filter"] = text_or_null(spec.filter);
  json["seconds"] = {{"load", s.times.load},
                     {"build", s.times.build},
                     {"prepare", s.times.prepare},
                     {"render", r.seconds},
                     {"denoise", s.times.denoise}};  // the last of all runs, the others of this one
  json["cpu_seconds"] = r.cpu_seconds;
  add_counts(r.counters, s.preparation, json);
  json["rays_per_second"] = per_second(r.counters.rays, r.seconds);
  json["samples_per_pixel"] = r.samples_per_pixel;
  json["replicates"] = settings.replicates;
  json["passes"] = r.passes;
  json["mutations_per_second"] = per_second(r.counters.mutations, r.seconds);
  json["chain_cpu_seconds"] = r.chain_seconds;
  json["prepared"] = s.prepared;
  if (s.report) {
    for (const auto& [key, value] : s.report->items()) {
      if (!json.contains(key)) json[key] = value;
    }
  }
  add_error(r, json);
  json["peak_memory_bytes"] = s.peak_memory_bytes;
  json["warnings"] = s.warning_count;
  json["warning_messages"] = s.warnings;
  json["techniques"] = techniques_json(r.counters.techniques);
  json["budget"] = budget_json(spec.budget());
  json["share"] = {spec.share.index + 1, spec.share.count};
  json["ranks"] = s.ranks;
  json["checkpoint"] = text_or_null(spec.checkpoint);
  json["resumed_from"] = text_or_null(s.resumed_from);
  json["resumptions"] = s.resumptions;
  json["interruptions"] = s.interruptions;
  json["stopped_by"] = to_string(r.stopped_by);
  json["interrupted"] = r.stopped_by == StopReason::Interrupted;
  json["complete"] = r.complete;
  json["estimated_denoised_error"] = number_or_null(s.denoised_error);
  json["estimated_error_by_scale"] = by_scale_json(s.errors_by_scale);
  json["denoiser"] = text_or_null(s.denoiser);
  json["exposure"] = exposure_json(s.exposure);
  json["outputs"] = s.outputs;
  json["options"] = options_json(spec);
  return json;
}

std::map<std::string, std::string> to_metadata(const RenderStatistics& s) {
  const RenderResult& r = s.result;
  const RenderSettings& settings = s.render.settings;
  const WorkSlice& share = s.render.spec.share;
  std::map<std::string, std::string> metadata{
      {"ajar:version", version()},
      {"ajar:scene", s.render.scene},
      {"ajar:scene_hash", fmt::format("{:016x}", s.render.scene_hash)},
      {"ajar:integrator", s.render.integrator},
      {"ajar:depth", fmt::format("{}:{}", settings.min_depth, settings.max_depth)},
      {"ajar:seed", std::to_string(settings.seed)},
      {"ajar:samples_per_pixel", std::to_string(r.samples_per_pixel)},
      {"ajar:replicates", std::to_string(settings.replicates)},
      {"ajar:rays", std::to_string(r.counters.rays)},
      {"ajar:render_seconds", fmt::format("{:.3f}", r.seconds)},
      {"ajar:threads", std::to_string(r.threads)},
      {"ajar:budget", budget_text(s.render.spec.budget())},
      {"ajar:resumptions", std::to_string(s.resumptions)},
      {"ajar:interruptions", std::to_string(s.interruptions)},
      {"ajar:stopped_by", to_string(r.stopped_by)},
      {"ajar:complete", r.complete ? "true" : "false"},
      // If not, plain Monte Carlo stood in for the integrator.
      {"ajar:prepared", s.prepared ? "true" : "false"},
  };
  if (!s.resumed_from.empty()) metadata["ajar:resumed_from"] = s.resumed_from;
  if (share.count > 1) {
    metadata["ajar:share"] = fmt::format("{}/{}", share.index + 1, share.count);
  }
  if (r.relative_error) {
    metadata["ajar:estimated_relative_error"] = fmt::format("{:.6g}", r.relative_error->value);
    metadata["ajar:estimated_error_is_lower_bound"] =
        r.relative_error->is_lower_bound() ? "true" : "false";
  }
  if (!s.denoiser.empty()) metadata["ajar:denoiser"] = s.denoiser;
  if (s.denoised_error) {
    metadata["ajar:estimated_denoised_error"] = fmt::format("{:.6g}", *s.denoised_error);
  }
  for (const auto& [name, value] : s.render.parameters) metadata["ajar:parameter:" + name] = value;
  return metadata;
}

void write_json(const Json& json, const std::string& path) {
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace ajar
