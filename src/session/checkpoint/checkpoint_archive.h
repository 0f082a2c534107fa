#pragma once
#include "core/archive.h"
#include "session/checkpoint/checkpoint.h"
#include "session/options/render_options.h"

/// Archives of the parts of a checkpoint. Whoever changes this must raise
/// `kCheckpointFormat`.
namespace ajar {

template <Archive A>
void serialize(A& archive, WorkSlice& share) {
  archive(share.index, share.count);
}

template <Archive A>
void serialize(A& archive, RenderSettings& settings) {
  archive(settings.resolution.x, settings.resolution.y, settings.crop.min.x, settings.crop.min.y,
          settings.crop.max.x, settings.crop.max.y, settings.min_depth, settings.max_depth,
          settings.seed, settings.replicates, settings.aovs, settings.for_filters);
}

template <Archive A>
void serialize(A& archive, Exposure& exposure) {
  archive(exposure.automatic, exposure.stops);
}

/// The options that are kept, each by its name: with more of them the format is the same.
template <Archive A>
void serialize(A& archive, RenderSpec& spec) {
  std::map<std::string, std::string> kept;
  const auto through = [&spec](const RenderOption& option, auto& of_option) {
    std::visit([&](auto member) { of_option(spec.*member); }, option.member);
  };
  if constexpr (!A::is_loading::value) {
    for (const RenderOption& option : render_options()) {
      if (!option.is_kept || !is_given(option, spec)) continue;
      kept[option.name] = archived([&](OutputArchive& to) { through(option, to); });
    }
  }
  archive(kept);
  if constexpr (A::is_loading::value) {
    for (const RenderOption& option : render_options()) {
      const auto found = option.is_kept ? kept.extract(option.name) : decltype(kept)::node_type();
      if (found) unarchive(found.mapped(), [&](InputArchive& from) { through(option, from); });
    }
    if (!kept.empty()) throw std::runtime_error("it has an unknown option " + kept.begin()->first);
  }
}

template <Archive A>
void serialize(A& archive, RenderRecord& record) {
  archive(record.scene, record.scene_hash, record.integrator, record.parameters, record.given,
          record.settings, record.film_scale, record.spec);
}

template <Archive A>
void serialize(A& archive, MergedRun& run) {
  archive(run.seed, run.samples_per_pixel);
}

template <Archive A>
void serialize(A& archive, LayerSpec& spec) {
  archive(spec.name, spec.has_replicates, spec.magnitude, spec.holds_identities, spec.part_of,
          spec.instead_of, spec.box_of);
}

template <Archive A>
void serialize(A& archive, std::pair<std::string, Plane>& map) {
  archive(map.first, map.second.size.x, map.second.size.y, map.second.values);
}

template <Archive A>
void serialize(A& archive, DevelopScale& scale) {
  archive(scale.factor, scale.pixels);
}

template <Archive A>
void serialize(A& archive, Development& development) {
  archive(development.whole, development.replicates, development.misses_light);
  // Planes have no value without a size, so that containers cannot make them.
  auto maps = static_cast<std::uint32_t>(development.maps.size());
  auto masks = static_cast<std::uint32_t>(development.antialias_mask ? 1 : 0);
  archive(maps, masks);
  if constexpr (A::is_loading::value) {
    development.maps.clear();
    if (masks > 0) development.antialias_mask.emplace(Vec2i(0, 0));
  }
  for (std::uint32_t i = 0; i < maps; ++i) {
    // One by one: however many a file claims, there may be fewer.
    if constexpr (A::is_loading::value) development.maps.emplace_back("", Plane(Vec2i(0, 0)));
    serialize(archive, development.maps[i]);
  }
  if (development.antialias_mask) {
    Plane& mask = *development.antialias_mask;
    archive(mask.size.x, mask.size.y, mask.values);
  }
}

/// Each number by its name, as options.
template <Archive A>
void serialize(A& archive, Counters& counters) {
  std::map<std::string, std::uint64_t> numbers;
  for (const EventCount& count : kEventCounts) numbers[count.name] = counters.*count.number;
  archive(numbers, counters.first_discarded);
  for (const EventCount& count : kEventCounts) counters.*count.number = numbers[count.name];
  if (numbers.size() > kEventCounts.size()) throw std::runtime_error("it has unknown counters");
  std::vector<double> sums = counters.techniques.sums();
  archive(sums);
  if constexpr (A::is_loading::value) {
    counters.techniques = {};
    counters.techniques.add_sums(sums);
  }
}

template <Archive A>
void serialize(A& archive, PartialPass& pass) {
  archive(pass.first_sample, pass.samples, pass.done, pass.round, pass.rounds);
}

template <Archive A>
void serialize(A& archive, JobState::ErrorMark& mark) {
  archive(mark.samples, mark.error);
}

template <Archive A>
void serialize(A& archive, RelativeError& error) {
  archive(error.value, error.places, error.half_of_it, error.has_fireflies, error.misses_light);
}

template <Archive A>
void serialize(A& archive, JobState& job) {
  archive(job.samples_per_pixel, job.partial, job.counters, job.passes, job.seconds,
          job.cpu_seconds, job.chain_seconds, job.seconds_per_sample, job.relative_error,
          job.error_samples, job.recent_errors);
}

/// All but the film's sums.
template <Archive A>
void serialize(A& archive, Checkpoint& checkpoint) {
  bool unprepared = checkpoint.unprepared.has_value();
  bool of_samples = checkpoint.unprepared == PreparationCut::Samples;
  archive(checkpoint.version, checkpoint.render, checkpoint.features.albedo,
          checkpoint.features.normal, checkpoint.layers, checkpoint.scales, checkpoint.job,
          checkpoint.integrator_state, checkpoint.preparation, unprepared, of_samples,
          checkpoint.preparation_rounds, checkpoint.other_seconds, checkpoint.resumptions,
          checkpoint.interruptions, checkpoint.merged);
  if constexpr (A::is_loading::value) {
    checkpoint.unprepared.reset();
    if (unprepared)
      checkpoint.unprepared = of_samples ? PreparationCut::Samples : PreparationCut::Time;
  }
}

}  // namespace ajar
