#include "session/checkpoint/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/error.h"
#include "session/version.h"

namespace ajar {

namespace {

/// Runs in a checkpoint: its seed, or those that were merged in it.
std::vector<MergedRun> runs_of(const Checkpoint& checkpoint) {
  if (!checkpoint.merged.empty()) return checkpoint.merged;
  return {{checkpoint.render.settings.seed, checkpoint.job.samples_per_pixel}};
}

std::uint64_t seed_of(const NamedCheckpoint& part) { return part.checkpoint.render.settings.seed; }

/// Checks that two are of one picture, but for seed and share.
void check_fits(const NamedCheckpoint& first, const NamedCheckpoint& part, bool force) {
  if (part.checkpoint.version != version() && !force) {
    throw UsageError(
        fmt::format("{}: was written by ajar {}, this is ajar {}; --force merges it nevertheless",
                    part.path, part.checkpoint.version, version()));
  }
  if (part.checkpoint.job.partial) {
    throw UsageError(part.path +
                     ": a pass was cut short; finish it first, with ajar resume --spp N");
  }
  if (part.checkpoint.job.samples_per_pixel == 0) {
    throw UsageError(part.path + ": has no samples yet");
  }
  RenderRecord record = part.checkpoint.render;
  const RenderRecord& wanted = first.checkpoint.render;
  record.settings.seed = wanted.settings.seed;
  record.spec.share = wanted.spec.share;
  check_same_render(record, wanted, part.path);
  if (record.scene_hash != wanted.scene_hash) {
    throw UsageError(part.path + ": is of another scene than " + first.path);
  }
}

void add_counters(Checkpoint& sum, const Checkpoint& other) {
  JobState& job = sum.job;
  job.counters += other.job.counters;
  job.cpu_seconds += other.job.cpu_seconds;
  job.chain_seconds += other.job.chain_seconds;
  job.passes = std::max(job.passes, other.job.passes);
  job.recent_errors.clear();
  sum.preparation += other.preparation;
  sum.interruptions += other.interruptions;
  sum.resumptions += other.resumptions;
}

/// Sums saturate, as those of films.
std::int64_t sum_of(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(a, b, &sum)) return sum;
  return a < 0 ? std::numeric_limits<std::int64_t>::min()
               : std::numeric_limits<std::int64_t>::max();
}

/// The shares of one seed.
NamedCheckpoint join_shares(std::vector<NamedCheckpoint> shares) {
  std::sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
    return a.checkpoint.render.spec.share.index < b.checkpoint.render.spec.share.index;
  });
  NamedCheckpoint whole = std::move(shares.front());
  const WorkSlice share = whole.checkpoint.render.spec.share;
  const std::uint64_t samples = whole.checkpoint.job.samples_per_pixel;
  std::uint64_t next = 0;
  const auto check_next = [&](const NamedCheckpoint& part) {
    const WorkSlice& own = part.checkpoint.render.spec.share;
    if (own.count != share.count) {
      throw UsageError(fmt::format("{}: is a share of {}, {} one of {}, with the same seed {}",
                                   part.path, own.count, whole.path, share.count, seed_of(part)));
    }
    if (own.index < next) {
      throw UsageError(share.count == 1
                           ? fmt::format("{}: has the same samples as another, of seed {}",
                                         part.path, seed_of(part))
                           : fmt::format("{}: share {}/{} of seed {} is there twice", part.path,
                                         own.index + 1, own.count, seed_of(part)));
    }
    if (own.index > next) {
      throw UsageError(
          fmt::format("share {}/{} of seed {} is missing", next + 1, share.count, seed_of(part)));
    }
    if (part.checkpoint.job.samples_per_pixel != samples) {
      throw UsageError(fmt::format(
          "{}: has {} samples per pixel, {} has {}; bring shares to the same number with ajar "
          "resume --spp",
          part.path, part.checkpoint.job.samples_per_pixel, whole.path, samples));
    }
    ++next;
  };
  check_next(whole);
  for (std::size_t i = 1; i < shares.size(); ++i) {
    check_next(shares[i]);
    const Checkpoint& part = shares[i].checkpoint;
    if (part.sums.size() != whole.checkpoint.sums.size()) {
      throw UsageError(shares[i].path + ": its film has another size");
    }
    std::transform(part.sums.begin(), part.sums.end(), whole.checkpoint.sums.begin(),
                   whole.checkpoint.sums.begin(), sum_of);
    add_counters(whole.checkpoint, part);
    JobState& job = whole.checkpoint.job;
    // Wall clock: parts may have been rendered at the same time.
    job.seconds = std::max(job.seconds, part.job.seconds);
    job.seconds_per_sample = std::max(job.seconds_per_sample, part.job.seconds_per_sample);
  }
  if (next != share.count) {
    throw UsageError(
        fmt::format("share {}/{} of seed {} is missing", next + 1, share.count, seed_of(whole)));
  }
  whole.checkpoint.render.spec.share = {};
  return whole;
}

/// Films of different seeds: the finer quantum of each layer, so that nothing is lost.
void add_seed(NamedCheckpoint& sum, NamedCheckpoint part) {
  std::vector<LayerSpec> layers = sum.checkpoint.layers;
  if (part.checkpoint.layers.size() != layers.size()) {
    throw UsageError(part.path + ": has other layers than " + sum.path);
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    layers[i].magnitude = std::min(layers[i].magnitude, part.checkpoint.layers[i].magnitude);
  }
  const RenderSettings& settings = sum.checkpoint.render.settings;
  Film film(settings.resolution, settings.crop, Filter::box(), settings.replicates, layers);
  try {
    film.add(film_of(sum.checkpoint, Filter::box(), sum.path));
    film.add(film_of(part.checkpoint, Filter::box(), part.path));
  } catch (const std::invalid_argument&) {
    throw UsageError(part.path + ": has other layers than " + sum.path);
  }
  Checkpoint& whole = sum.checkpoint;
  whole.merged = runs_of(whole);
  for (const MergedRun& run : runs_of(part.checkpoint)) whole.merged.push_back(run);
  whole.sums.assign(film.raw().begin(), film.raw().end());
  whole.layers = std::move(layers);
  whole.scales = development_of_sum(whole.scales, part.checkpoint.scales);
  whole.integrator_state.clear();
  add_counters(whole, part.checkpoint);
  whole.job.samples_per_pixel += part.checkpoint.job.samples_per_pixel;
  whole.job.seconds += part.checkpoint.job.seconds;
  whole.other_seconds += part.checkpoint.other_seconds;
}

void check_seeds(const NamedCheckpoint& sum, const NamedCheckpoint& part) {
  for (const MergedRun& there : runs_of(sum.checkpoint)) {
    for (const MergedRun& run : runs_of(part.checkpoint)) {
      if (there.seed != run.seed) continue;
      throw UsageError(
          fmt::format("{}: seed {} is in it, and in another one, too", part.path, run.seed));
    }
  }
}

}  // namespace

Checkpoint merge(std::vector<NamedCheckpoint> parts, bool force) {
  if (parts.empty()) throw UsageError("there is nothing to merge");
  for (const NamedCheckpoint& part : parts) check_fits(parts.front(), part, force);
  // Parts of one seed, in the order in which seeds are named; merges are groups of their own.
  std::vector<std::vector<NamedCheckpoint>> groups;
  for (NamedCheckpoint& part : parts) {
    const bool is_merge = part.checkpoint.merged.size() > 1;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& members) {
      return !is_merge && members.front().checkpoint.merged.size() < 2 &&
             seed_of(members.front()) == seed_of(part);
    });
    if (group == groups.end()) {
      groups.emplace_back().push_back(std::move(part));
    } else {
      group->push_back(std::move(part));
    }
  }
  NamedCheckpoint whole = join_shares(std::move(groups.front()));
  for (std::size_t i = 1; i < groups.size(); ++i) {
    NamedCheckpoint next = join_shares(std::move(groups[i]));
    check_seeds(whole, next);
    add_seed(whole, std::move(next));
  }
  Checkpoint result = std::move(whole.checkpoint);
  result.version = version();
  const RenderSettings& settings = result.render.settings;
  Film film = film_of(result, Filter::box(), whole.path);
  result.job.error_samples = result.job.samples_per_pixel;
  result.job.relative_error =
      settings.replicates > 1 ? estimate_error(film, result.scales, result.job.samples_per_pixel)
                              : std::nullopt;
  result.sums.assign(film.raw().begin(), film.raw().end());
  return result;
}

}  // namespace ajar
