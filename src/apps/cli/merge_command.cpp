#include <fmt/format.h>

#include <utility>

#include "apps/cli/commands.h"
#include "apps/cli/denoise_progress.h"
#include "apps/cli/exit_codes.h"
#include "apps/cli/messages.h"
#include "apps/cli/render_report.h"
#include "core/error.h"
#include "session/checkpoint/merge.h"
#include "session/job/resources.h"
#include "session/output/picture_filter.h"
#include "session/output/picture_range.h"
#include "session/output/written_paths.h"
#include "session/render/render_concerns.h"
#include "session/render/render_writers.h"
#include "session/render/statistics_of.h"

namespace ajar::cli {

namespace {
RenderStatistics statistics_of_merged(const Checkpoint& merged) {
  RenderStatistics statistics = statistics_of(merged.render);
  statistics.preparation = merged.preparation;
  statistics.budget = merged.budget;
  statistics.resumptions = merged.resumptions;
  statistics.interruptions = merged.interruptions;
  statistics.result = result_of(merged.job, StopReason::Samples);
  return statistics;
}

std::string seeds_text(const Checkpoint& merged) {
  std::string text;
  for (const MergedRun& run : merged.merged) {
    text += fmt::format("{}{} ({} spp)", text.empty() ? "" : ", ", run.seed, run.samples_per_pixel);
  }
  return text;
}

}  // namespace

int merge(const MergeArguments& a) {
  if (a.outputs.empty() && a.checkpoint.empty()) {
    throw UsageError("merge: say with -o or --checkpoint where the result goes");
  }
  const Display wanted{tone_map_by_name(a.tone_map), a.exposure};
  std::string note;
  std::shared_ptr<const Denoiser> denoiser = find_denoiser(a.denoiser, &note);
  if (!note.empty()) print_note(note);
  check_picture_paths(a.outputs);
  std::vector<std::string> written = a.outputs;
  for (const std::string& path : {a.stats, a.checkpoint}) {
    if (path.empty()) continue;
    check_writable(path);
    written.push_back(path);
  }
  check_distinct(written);
  check_spares(written, {a.checkpoints.begin(), a.checkpoints.end()});
  std::optional<FileLock> lock;
  if (!a.checkpoint.empty()) lock.emplace(lock_checkpoint(a.checkpoint));

  std::vector<NamedCheckpoint> parts;
  for (const std::string& path : a.checkpoints) parts.push_back({path, read_checkpoint(path)});
  Checkpoint merged = ajar::merge(std::move(parts), a.force);
  RenderStatistics statistics = statistics_of_merged(merged);
  statistics.checkpoint = a.checkpoint;

  const std::string& first = a.checkpoints.front();
  const std::vector<std::string> aovs = merged.render.aovs;
  const Film film = film_of(merged, Filter::box(), first);
  merged.denoiser = a.denoiser;
  if (!a.checkpoint.empty()) write_checkpoint(a.checkpoint, merged, film.raw());
  statistics.errors_by_scale =
      estimate_errors_by_scale(film, merged.scales, merged.job.samples_per_pixel);
  Picture picture =
      develop(film, merged.scales, merged.job.samples_per_pixel, merged.render.film_scale, aovs);
  Warnings warnings;
  if (auto outside = range_complaint(film, picture, merged.render.film_scale)) {
    warnings.add(*std::move(outside));
  }
  for (Warning& concern : concerns_about(statistics.result)) warnings.add(std::move(concern));
  print_all_warnings(warnings);
  statistics.warnings = warnings.messages();
  statistics.warning_count = warnings.count();
  if (denoiser) {
    PictureFilter filter(std::move(denoiser),
                         [&merged](const Denoiser::Progress&) { return merged.features; });
    const PictureEstimates estimates =
        estimates_of(film, merged.scales, merged.job.samples_per_pixel, merged.render.film_scale);
    const bool is_filtered = denoise_with_progress([&](const Denoiser::Progress& progress) {
      return filter.add_best_layers(picture, estimates, progress);
    });
    if (is_filtered) {
      statistics.denoiser = filter.name();
      statistics.denoised_error = denoised_error(picture);
    } else {
      print_note("interrupted while denoising: the picture is as it was rendered");
    }
  }
  picture.metadata = to_metadata(statistics);
  if (merged.merged.size() > 1) picture.metadata["ajar:merged_seeds"] = seeds_text(merged);
  const DisplayOptions display = wanted.of(picture);
  statistics.exposure = {wanted.exposure.automatic, display.exposure};
  // The parts are there still: whoever has made room merges once more.
  bool all_written = true;
  for (const WrittenFile& file :
       write_final_files(picture_files(picture, a.outputs, display), nullptr)) {
    all_written = report_file(file) && all_written;
    if (file.path.empty()) continue;
    statistics.outputs.push_back(file.path);
    print_path(file.path);
  }
  statistics.peak_memory_bytes = peak_memory_bytes();
  const std::string complaint = write_statistics(statistics, a.stats);
  if (!complaint.empty()) print_error(complaint);
  all_written = complaint.empty() && all_written;
  print_note(end_text(statistics.result, 0.0, statistics.denoised_error));
  report_exposure(picture, a.outputs, display, wanted.exposure.automatic);
  return all_written ? 0 : kExitFile;
}

}  // namespace ajar::cli
