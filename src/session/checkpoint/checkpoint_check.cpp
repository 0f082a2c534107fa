#include "session/checkpoint/checkpoint_check.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "core/error.h"
#include "core/milestones.h"
#include "session/job/budget.h"
#include "session/options/limits.h"
#include "session/options/render_options.h"
#include "session/scenes/catalog.h"

namespace ajar {

namespace {

/// Bounds of the command line and of scenes.
constexpr int kMostEdges = 1000001;
/// Far beyond any light, and far from where powers of two end.
constexpr double kLargestMagnitude = 1e100;

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

bool is_size(double value) { return value >= 0.0 && std::isfinite(value); }

template <typename Values>
void require_distinct(const Values& values, const std::string& otherwise) {
  using Value = typename Values::value_type;
  require(std::set<Value>(values.begin(), values.end()).size() == values.size(), otherwise);
}

bool is_inside(const Box2i& crop, Vec2i resolution) {
  return crop.min.x >= 0 && crop.min.y >= 0 && crop.min.x <= crop.max.x &&
         crop.min.y <= crop.max.y && crop.max.x < resolution.x && crop.max.y < resolution.y;
}

void check_settings(const RenderSettings& settings) {
  for (const int size : {settings.resolution.x, settings.resolution.y}) {
    require(size >= 1 && size <= kMaxResolution, "a picture of this size is not possible");
  }
  require(is_inside(settings.crop, settings.resolution), "its crop is not inside the picture");
  require(settings.min_depth >= 1 && settings.min_depth <= settings.max_depth &&
              settings.max_depth <= kMostEdges,
          "its depths cannot be");
  require(settings.replicates >= 1, "it has no replicates");
}

void check_names(const RenderRecord& render) {
  checked_aovs(render.settings.aovs);
  for (const auto* names : {&render.spec.layers, &render.settings.aovs}) {
    require_distinct(*names, "a layer is asked for twice");
  }
  check_options(render.spec, &RenderOption::is_kept);
  find_integrator(render.integrator).read(render.given);
}

void check_record(const RenderRecord& render) {
  check_settings(render.settings);
  try {
    check_names(render);
  } catch (const UsageError& error) {
    throw std::runtime_error(error.what());
  }
  require(std::isfinite(render.film_scale), "its scale is no number");
}

/// `known`: the layers before it.
void check_layer(const LayerSpec& layer, const std::set<std::string>& known) {
  require(!layer.name.empty() && !known.contains(layer.name), "a layer has no name of its own");
  require(layer.magnitude >= 1.0 / kLargestMagnitude && layer.magnitude <= kLargestMagnitude,
          "the magnitude of layer " + layer.name + " cannot be");
  const bool is_of_light = layer.is_light() || !layer.instead_of.empty() || !layer.box_of.empty();
  require(!is_of_light || (layer.has_replicates && !layer.holds_identities),
          "layer " + layer.name + " has no replicates");
  require(!layer.holds_identities || !layer.has_replicates,
          "layer " + layer.name + " has replicates");
  require(layer.part_of.empty() || known.contains(layer.part_of),
          "layer " + layer.name + " is a part of nothing");
  require(layer.instead_of.empty() || (layer.part_of.empty() && known.contains(layer.instead_of)),
          "layer " + layer.name + " estimates nothing");
  require(layer.box_of.empty() ||
              (layer.part_of.empty() && layer.instead_of.empty() && known.contains(layer.box_of)),
          "layer " + layer.name + " belongs to none");
}

void check_layers(const std::vector<LayerSpec>& layers) {
  std::set<std::string> known;
  std::set<std::string> parts;
  for (const LayerSpec& layer : layers) {
    check_layer(layer, known);
    require(!parts.contains(layer.part_of), "layer " + layer.name + " is a part of a part");
    known.insert(layer.name);
    if (!layer.part_of.empty()) parts.insert(layer.name);
  }
  require(known.contains("direct") && known.contains("indirect"), "its picture has no light");
  for (const LayerSpec& layer : layers) {
    const bool whole = layer.holds_identities && layer.part_of.empty();
    require(!whole || (parts.contains(layer.name + ".1") && parts.contains(layer.name + ".2")),
            "layer " + layer.name + " lacks a part");
  }
}

bool has_pixels(const std::vector<float>& values, Vec2i size) {
  return values.size() == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

bool has_size(const Plane& plane, Vec2i size) {
  return plane.size == size && has_pixels(plane.values, size);
}

void check_scales(const Checkpoint& checkpoint) {
  const Development& scales = checkpoint.scales;
  const std::vector<LayerSpec>& layers = checkpoint.layers;
  const auto replicates = static_cast<std::size_t>(checkpoint.render.settings.replicates);
  const Vec2i size = checkpoint.render.settings.crop.size() + Vec2i(1, 1);
  const auto is_scale = [size](const DevelopScale& scale) {
    return is_size(scale.factor) && (scale.pixels.empty() || has_pixels(scale.pixels, size)) &&
           std::all_of(scale.pixels.begin(), scale.pixels.end(), is_size);
  };
  bool fit = scales.whole.size() == layers.size() && scales.replicates.size() == layers.size() &&
             std::all_of(scales.whole.begin(), scales.whole.end(), is_scale);
  for (std::size_t i = 0; fit && i < layers.size(); ++i) {
    const std::vector<DevelopScale>& each = scales.replicates[i];
    fit = each.size() == (layers[i].has_replicates ? replicates : 0) &&
          std::all_of(each.begin(), each.end(), is_scale);
  }
  require(fit, "its scales are those of another film");
  for (const auto& [name, map] : scales.maps) {
    require(!name.empty() && has_size(map, size), "a map has another size");
  }
  require(!scales.antialias_mask || has_size(*scales.antialias_mask, size),
          "its mask has another size");
}

void check_partial(const PartialPass& pass, const JobState& job, int replicates) {
  const std::uint64_t end =
      milestone_after(job.samples_per_pixel, static_cast<std::uint64_t>(replicates));
  require(pass.first_sample == job.samples_per_pixel && pass.samples >= 1 && pass.round >= 0 &&
              pass.round < pass.rounds && pass.samples <= end - pass.first_sample &&
              std::all_of(pass.done.begin(), pass.done.end(),
                          [](std::uint8_t done) { return done <= 1; }),
          "the pass that was cut short cannot be");
}

void check_job(const JobState& job, const RenderSettings& settings) {
  for (const double seconds :
       {job.seconds, job.cpu_seconds, job.chain_seconds, job.seconds_per_sample}) {
    require(is_size(seconds), "its times cannot be");
  }
  if (const std::optional<RelativeError>& error = job.relative_error) {
    require(is_size(error->value) && is_size(error->places) && is_size(error->half_of_it),
            "its error cannot be");
  }
  for (const JobState::ErrorMark& mark : job.recent_errors) {
    require(is_size(mark.error) && mark.samples >= 1 && mark.samples <= job.samples_per_pixel,
            "its errors cannot be");
  }
  if (job.partial) check_partial(*job.partial, job, settings.replicates);
}

/// A render ends at a whole number of samples per replicate; merges may have many times as many.
void check_samples(const Checkpoint& checkpoint) {
  const std::uint64_t most =
      PassSchedule::kMaxSamples + static_cast<std::uint64_t>(checkpoint.render.settings.replicates);
  std::uint64_t samples = checkpoint.job.samples_per_pixel;
  if (checkpoint.merged.empty()) {
    require(samples <= most, "nobody has so many samples");
    return;
  }
  std::vector<std::uint64_t> seeds;
  for (const MergedRun& run : checkpoint.merged) {
    require(run.samples_per_pixel <= std::min(most, samples), "its seeds have other samples");
    samples -= run.samples_per_pixel;
    seeds.push_back(run.seed);
  }
  require(samples == 0, "its seeds have other samples");
  require_distinct(seeds, "a seed is in it twice");
}

void check_features(const Features& features, const RenderSettings& settings) {
  if (features.albedo.empty() && features.normal.empty()) return;
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  const std::size_t values =
      3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  for (const std::vector<float>& layer : {features.albedo, features.normal}) {
    require(layer.size() == values, "its features have another size");
    require(std::all_of(layer.begin(), layer.end(), [](float v) { return std::isfinite(v); }),
            "its features are no numbers");
  }
}

}  // namespace

bool film_fits(const RenderSettings& settings, const std::vector<LayerSpec>& layers,
               std::size_t sums) {
  if (!is_inside(settings.crop, settings.resolution) || settings.replicates < 1) return false;
  const Vec2i size = settings.crop.size() + Vec2i(1, 1);
  const std::size_t plane = 3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  // Taken away one by one: products of what a file claims may overflow.
  for (const LayerSpec& layer : layers) {
    const std::size_t planes =
        layer.has_replicates ? static_cast<std::size_t>(settings.replicates) : 1;
    if (planes > sums / plane) return false;
    sums -= planes * plane;
  }
  return sums == 0;
}

void check_sense(const Checkpoint& checkpoint) {
  check_record(checkpoint.render);
  check_layers(checkpoint.layers);
  require(film_fits(checkpoint.render.settings, checkpoint.layers, checkpoint.sums.size()),
          "its film has another size");
  check_features(checkpoint.features, checkpoint.render.settings);
  check_scales(checkpoint);
  check_samples(checkpoint);
  check_job(checkpoint.job, checkpoint.render.settings);
  require(is_size(checkpoint.other_seconds), "its times cannot be");
}

}  // namespace ajar
