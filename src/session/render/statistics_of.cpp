#include "session/render/statistics_of.h"

namespace ajar {

RenderStatistics statistics_of(const RenderRecord& record) {
  RenderStatistics statistics;
  statistics.scene = record.scene;
  statistics.scene_hash = record.scene_hash;
  statistics.integrator = record.integrator;
  statistics.parameters = {record.parameters.begin(), record.parameters.end()};
  statistics.seed = record.settings.seed;
  statistics.replicates = record.settings.replicates;
  statistics.min_depth = record.settings.min_depth;
  statistics.max_depth = record.settings.max_depth;
  statistics.resolution = record.settings.resolution;
  statistics.crop = record.settings.crop;
  statistics.filter = record.filter;
  statistics.share = record.share;
  return statistics;
}

RenderResult result_of(const JobState& state, StopReason reason) {
  RenderResult result;
  result.counters = state.counters;
  result.samples_per_pixel = state.mean_samples();
  result.seconds = state.seconds;
  result.cpu_seconds = state.cpu_seconds;
  result.chain_seconds = state.chain_seconds;
  result.passes = state.passes;
  result.relative_error = state.relative_error;
  result.complete = !state.partial;
  result.stopped_by = reason;
  return result;
}

}  // namespace ajar
