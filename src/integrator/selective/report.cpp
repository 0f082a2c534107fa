#include "integrator/selective/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "integrator/metropolis/chain_report.h"
#include "integrator/regions/region_layers.h"
#include "integrator/regions/region_map.h"
#include "integrator/selective/chain_walker.h"

namespace ajar {

namespace {

std::string name_of(const std::string& techniques) {
  if (techniques == "pt") return "path tracing";
  if (techniques == "lt") return "light tracing";
  if (techniques == "ibpt") return "path and light tracing";
  if (techniques == "bdpt") return "bidirectional path tracing";
  return "Monte Carlo (" + techniques + ")";
}

std::string percent(double fraction) {
  const auto rounded = static_cast<int>(std::lround(100.0 * fraction));
  return rounded < 1 ? "less than 1 %" : "about " + std::to_string(rounded) + " %";
}

bool are_lit(std::span<const ChainPopulation> populations) {
  return std::any_of(populations.begin(), populations.end(),
                     [](const ChainPopulation& population) { return !population.chains.empty(); });
}

MethodReport or_null(std::optional<double> value) {
  return value && std::isfinite(*value) ? MethodReport(*value) : MethodReport();
}

MethodReport report_chains(const SelectiveStatus& status) {
  const SelectivePreparation& prepared = status.prepared;
  ChainReporter reporter(prepared.pilot_tried);
  for (std::size_t g = 0; g < prepared.groups().size(); ++g) {
    const PathGroup& group = prepared.groups()[g];
    ChainReporter::OfGroup row(group, moves_of(group));
    for (const ChainPopulation& population : status.populations) {
      if (population.group != g) continue;
      row.add_b(population.b.total, std::sqrt(population.b.variance),
                prepared.config.settings.replicates);
      row.add_retired(population.retired);
      for (const SelectiveChain& member : population.chains) row.add_chain(member.record);
    }
    reporter.add(std::move(row));
  }
  return reporter.report();
}

/// Expectations of each half of the replicates: `expected_error`, squared, with (bad) chains over
/// that without, 1 if it is not known; `threshold` T, relative to the brightness, geometric mean
/// over pixels; whether chains make `fireflies_only`.
MethodReport report_halves(const SelectivePreparation& prepared, const DivisionResult& division) {
  const std::vector<std::uint32_t>& labels = prepared.surfaces.regions.labels;
  MethodReport halves = MethodReport::array();
  for (const RegionChoice& choice : division.choices) {
    double sum = 0.0;
    for (const std::uint32_t label : labels) {
      sum += std::log(static_cast<double>(choice.regions[label].threshold) / prepared.brightness);
    }
    halves.push_back({{"expected_error", choice.expected_error},
                      {"threshold", std::exp(sum / static_cast<double>(labels.size()))},
                      {"fireflies_only", choice.fireflies_only}});
  }
  return halves;
}

std::vector<double> region_noise(const Plane& noise, const Regions& regions) {
  std::vector<double> result;
  for (const RegionNoise& region : aggregate_noise(noise, regions, RegionMapSettings{}.threshold)) {
    result.push_back(static_cast<double>(region.fill()));
  }
  return result;
}

MethodReport report_division(const SelectiveStatus& status) {
  const SelectivePreparation& prepared = status.prepared;
  const SampleAllocation::Known known = status.allocation.known();
  // Relative to the brightness of the picture; 0: rays have no price.
  const double ray_price =
      prepared.roulette ? prepared.roulette->price() / prepared.brightness : 0.0;
  std::optional<double> omc_error;
  if (known.chain_error) omc_error = 1.0 - *known.chain_error;
  const Surfaces& surfaces = prepared.surfaces;
  return {{"pilot_samples_per_pixel", status.division->samples},
          {"pilot_stays", prepared.pilot_kept > 0},
          {"halves", report_halves(prepared, *status.division)},
          {"mutations_per_sample", known.mutations_per_sample},
          {"correlation", or_null(known.correlation)},
          {"chains",
           {{"ray_share", known.chain_rays}, {"squared_error_share", or_null(known.chain_error)}}},
          {"omc",
           {{"techniques", prepared.techniques.omc.techniques},
            {"light_paths_per_sample", prepared.techniques.omc.light_paths_per_pixel},
            {"ray_price", ray_price},
            {"ray_share", 1.0 - known.chain_rays},
            {"squared_error_share", or_null(omc_error)}}},
          {"region_count", surfaces.regions.count()},
          {"regions", report_regions(prepared.scene(), surfaces.regions,
                                     region_noise(status.division->noise, surfaces.regions),
                                     chain_importance(prepared))}};
}

}  // namespace

std::vector<std::string> notes_on(const SelectiveStatus& status) {
  const SelectivePreparation& prepared = status.prepared;
  const std::string omc = name_of(prepared.techniques.omc.techniques);
  if (prepared.preparation_cut) {
    const bool of_time = prepared.preparation_cut == PreparationCut::Time;
    return {std::string(of_time ? "too little time" : "too few samples") +
            " to look for difficult light: rendered by plain " + omc +
            "; for Markov chains, begin anew with more " + (of_time ? "time" : "samples")};
  }
  if (!(prepared.brightness > 0.0)) return {"no light found: rendered by plain " + omc};
  const std::string easy = "no difficult light found: rendered by plain " + omc;
  if (prepared.mutations == 0.0 && prepared.config.chooses_division) return {easy};
  if (prepared.mutations == 0.0) {
    return {"no light is left to Markov chains: rendered by plain " + omc};
  }
  if (prepared.fireflies_only) {
    return {easy + "; Markov chains only take stray bright dots"};
  }
  if (!are_lit(status.populations)) {
    return {easy + " until some is"};
  }
  const std::string difficult = "difficult light (caustics, light through gaps)";
  if (status.division == nullptr) {
    return {"Markov chains make " + difficult + ", " + omc + " the rest"};
  }
  return {difficult + " in " + percent(status.division->chain_fraction) +
          " of this picture: Markov chains make it, " + omc + " the rest"};
}

MethodReport report_on(const SelectiveStatus& status) {
  MethodReport report = report_chains(status);
  if (status.division != nullptr) report["selective"] = report_division(status);
  return report;
}

Plane chain_importance(const SelectivePreparation& prepared) {
  const auto whole = static_cast<float>(prepared.brightness);
  const float most =
      Division::chain_fraction(whole, static_cast<float>(prepared.lowest_threshold()));
  const auto fraction = [&](int replicate, const Vec2& place) {
    const PixelDivision& pixel = prepared.divisions->of(replicate).at(place);
    return pixel.deposit_scale * Division::chain_fraction(whole, pixel.threshold) / most;
  };
  Plane plane(prepared.surfaces.regions.size);
  for (int y = 0; y < plane.size.y; ++y) {
    for (int x = 0; x < plane.size.x; ++x) {
      const Vec2 middle = Vec2(prepared.config.settings.crop.min + Vec2i(x, y)) + Vec2(0.5F, 0.5F);
      plane.at(x, y) = 0.5F * (fraction(0, middle) + fraction(1, middle));
    }
  }
  return plane;
}

}  // namespace ajar
