#include "session/stats_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "core/atomic_file.h"
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

double per_second(std::uint64_t count, double seconds) {
  return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json budget_json(const Budget& budget) {
  const auto value_or_null = [](const auto& value) { return value ? Json(*value) : Json(); };
  return {{"samples_per_pixel", value_or_null(budget.samples_per_pixel)},
          {"seconds", value_or_null(budget.seconds)},
          {"target_error", value_or_null(budget.target_error)}};
}

std::string budget_text(const Budget& budget) {
  std::string text;
  const auto add = [&](const std::string& limit) { text += (text.empty() ? "" : ", ") + limit; };
  if (budget.samples_per_pixel) add(fmt::format("{} spp", *budget.samples_per_pixel));
  if (budget.seconds) add(fmt::format("{} s", *budget.seconds));
  if (budget.target_error) add(fmt::format("error {}", *budget.target_error));
  return text.empty() ? "none" : text;
}

Json parameters_json(const RenderStatistics& s) {
  Json parameters = Json::object();
  for (const auto& [name, value] : s.parameters) parameters[name] = value;
  return parameters;
}

/// Stops are decimal for those who read them, not what a float makes of them.
Json exposure_json(const Exposure& exposure) {
  return {{"stops", std::stod(fmt::format("{}", exposure.stops))}, {"auto", exposure.automatic}};
}

Json discarded_json(const Counters& counters, const Counters& preparation) {
  return {{"nan", counters.discarded_nan},
          {"infinite", counters.discarded_infinite},
          {"negative", counters.discarded_negative},
          {"rays_out_of_range", counters.rays_out_of_range + preparation.rays_out_of_range},
          {"first", counters.first_discarded.empty() ? Json() : Json(counters.first_discarded)}};
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

/// Keys that mean nothing to methods without chains are null there.
void add_chains(const RenderStatistics& s, Json& json) {
  for (const char* key :
       {"mutations", "mutations_per_second", "split", "acceptance", "b", "chains"}) {
    json[key] = nullptr;
  }
  if (!s.chains) return;
  const ChainReport& report = *s.chains;
  const std::uint64_t mutations = s.result.counters.mutations;
  json["mutations"] = mutations;
  json["mutations_per_second"] = per_second(mutations, s.result.seconds);
  Json by_depth = Json::array();
  Json by_technique = Json::array();
  Json b = Json::array();
  std::uint64_t chains = 0;
  for (const ChainReport::Depth& depth : report.depths) {
    const Json number = depth.depth > 0 ? Json(depth.depth) : Json();
    by_depth.push_back({{"depth", number},
                        {"chains", depth.chains},
                        {"mutations", depth.mutations},
                        {"acceptance", depth.acceptance}});
    b.push_back({{"depth", number},
                 {"b", depth.b},
                 {"standard_error", number_or_null(depth.b_standard_error)}});
    chains += depth.chains;
  }
  for (const ChainReport::OfTechnique& technique : report.techniques) {
    by_technique.push_back({{"s", technique.technique.s},
                            {"t", technique.technique.t},
                            {"proposals", technique.proposals},
                            {"acceptance", technique.acceptance}});
  }
  Json by_move = Json::array();
  for (const ChainReport::OfMove& move : report.moves) {
    by_move.push_back(
        {{"move", move.name}, {"proposals", move.proposals}, {"acceptance", move.acceptance}});
  }
  json["acceptance"] = {{"small", report.small_acceptance},
                        {"large", report.large_acceptance},
                        {"by_move", by_move},
                        {"by_depth", by_depth},
                        {"by_technique", by_technique},
                        {"longest_rejection_streak", report.longest_rejection_streak}};
  if (!report.split.empty()) json["split"] = report.split;
  json["b"] = b;
  json["chains"] = chains;
  json["bootstrap_samples"] = report.bootstrap_samples;
}

/// At most so many regions are listed, the largest ones.
constexpr std::size_t kMostRegions = 200;

Json selective_json(const SelectiveReport& report, const RenderResult& result) {
  Json regions = Json::array();
  for (const SelectiveReport::Region& region : report.regions) {
    if (regions.size() == kMostRegions) break;
    regions.push_back({{"region", region.number},
                       {"pixels", region.pixels},
                       {"object", region.object},
                       {"material", region.material},
                       {"noise", region.noise},
                       {"importance", region.importance}});
  }
  Json halves = Json::array();
  for (const SelectiveReport::Half& half : report.halves) {
    halves.push_back({{"correlation", half.correlation},
                      {"expected_error", half.expected_error},
                      {"threshold", half.threshold},
                      {"stands_by", half.stands_by}});
  }
  const auto of_omc = [](std::optional<double> of_chains) {
    return number_or_null(of_chains ? std::optional(1.0 - *of_chains) : std::nullopt);
  };
  return {{"pilot_samples_per_pixel", report.pilot_samples},
          {"pilot_stays", report.pilot_stays},
          {"halves", halves},
          {"mutations_per_sample", report.mutations_per_sample},
          {"correlation", number_or_null(report.correlation)},
          {"chains",
           {{"lasting_error", number_or_null(report.lasting_error)},
            {"cpu_seconds", result.chain_seconds},
            {"ray_share", report.chain_rays},
            {"squared_error_share", number_or_null(report.chain_error)}}},
          {"omc",
           {{"techniques", report.techniques},
            {"light_paths_per_sample", report.light_paths_per_sample},
            {"ray_price", report.ray_price},
            {"path_rest", report.path_rest},
            {"cpu_seconds", std::max(0.0, result.cpu_seconds - result.chain_seconds)},
            {"ray_share", 1.0 - report.chain_rays},
            {"squared_error_share", of_omc(report.chain_error)}}},
          {"region_count", report.regions.size()},
          {"regions", regions}};
}

}  // namespace

Json to_json(const RenderStatistics& s) {
  const RenderResult& r = s.result;
  Json json;
  json["program"] = "ajar";
  json["version"] = version();
  json["scene"] = s.scene;
  json["scene_hash"] = fmt::format("{:016x}", s.scene_hash);
  json["integrator"] = s.integrator;
  json["parameters"] = parameters_json(s);
  json["depth"] = {{"min", s.min_depth}, {"max", s.max_depth}};
  json["seed"] = s.seed;
  json["threads"] = r.threads;
  json["resolution"] = {s.resolution.x, s.resolution.y};
  json["crop"] = {s.crop.min.x, s.crop.min.y, s.crop.max.x + 1, s.crop.max.y + 1};
  json["filter"] = text_or_null(s.filter);
  json["seconds"] = {{"load", s.times.load},
                     {"build", s.times.build},
                     {"prepare", s.times.prepare},
                     {"render", r.seconds}};  // the last of all runs, the others of this one
  json["cpu_seconds"] = r.cpu_seconds;
  json["rays"] = r.counters.rays + s.preparation.rays;
  json["rays_per_second"] = per_second(r.counters.rays, r.seconds);
  json["samples"] = r.counters.samples;
  json["samples_per_pixel"] = r.samples_per_pixel;
  json["replicates"] = s.replicates;
  json["passes"] = r.passes;
  add_chains(s, json);
  json["prepared"] = s.prepared;
  json["selective"] = s.selective ? selective_json(*s.selective, r) : Json();
  add_error(r, json);
  json["peak_memory_bytes"] = s.peak_memory_bytes;
  json["warnings"] = s.warning_count;
  json["warning_messages"] = s.warnings;
  json["techniques"] = techniques_json(r.counters.techniques);
  json["discarded"] = discarded_json(r.counters, s.preparation);
  json["budget"] = budget_json(s.budget);
  json["share"] = {s.share.index + 1, s.share.count};
  json["ranks"] = s.ranks;
  json["checkpoint"] = text_or_null(s.checkpoint);
  json["resumed_from"] = text_or_null(s.resumed_from);
  json["resumptions"] = s.resumptions;
  json["interruptions"] = s.interruptions;
  json["stopped_by"] = to_string(r.stopped_by);
  json["interrupted"] = r.stopped_by == StopReason::Interrupted;
  json["complete"] = r.complete;
  json["exposure"] = exposure_json(s.exposure);
  json["outputs"] = s.outputs;
  return json;
}

std::map<std::string, std::string> to_metadata(const RenderStatistics& s) {
  const RenderResult& r = s.result;
  std::map<std::string, std::string> metadata{
      {"ajar:version", version()},
      {"ajar:scene", s.scene},
      {"ajar:scene_hash", fmt::format("{:016x}", s.scene_hash)},
      {"ajar:integrator", s.integrator},
      {"ajar:depth", fmt::format("{}:{}", s.min_depth, s.max_depth)},
      {"ajar:seed", std::to_string(s.seed)},
      {"ajar:samples_per_pixel", std::to_string(r.samples_per_pixel)},
      {"ajar:replicates", std::to_string(s.replicates)},
      {"ajar:rays", std::to_string(r.counters.rays)},
      {"ajar:render_seconds", fmt::format("{:.3f}", r.seconds)},
      {"ajar:threads", std::to_string(r.threads)},
      {"ajar:budget", budget_text(s.budget)},
      {"ajar:resumptions", std::to_string(s.resumptions)},
      {"ajar:interruptions", std::to_string(s.interruptions)},
      {"ajar:stopped_by", to_string(r.stopped_by)},
      {"ajar:complete", r.complete ? "true" : "false"},
  };
  if (!s.resumed_from.empty()) metadata["ajar:resumed_from"] = s.resumed_from;
  if (s.share.count > 1) {
    metadata["ajar:share"] = fmt::format("{}/{}", s.share.index + 1, s.share.count);
  }
  if (r.relative_error) {
    metadata["ajar:estimated_relative_error"] = fmt::format("{:.6g}", r.relative_error->value);
    metadata["ajar:estimated_error_is_lower_bound"] =
        r.relative_error->is_lower_bound() ? "true" : "false";
  }
  for (const auto& [name, value] : s.parameters) metadata["ajar:parameter:" + name] = value;
  return metadata;
}

void write_json(const Json& json, const std::string& path) {
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace ajar
