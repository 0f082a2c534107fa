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

namespace ajar::cli {

namespace {
RenderStatistics statistics_of_merged(const Checkpoint& merged) {
  RenderStatistics statistics;
  statistics.render = merged.render;
  statistics.preparation = merged.preparation;
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
  const RenderSpec& spec = a.spec;
  const std::string denoise = spec.denoise.empty() ? "auto" : spec.denoise;
  if (spec.outputs.empty() && spec.checkpoint.empty()) {
    throw UsageError("merge: say with -o or --checkpoint where the result goes");
  }
  const Display wanted = spec.display();
  std::string note;
  std::shared_ptr<const Denoiser> denoiser = find_denoiser(denoise, &note);
  if (!note.empty()) print_note(note);
  check_picture_paths(spec.outputs);
  const std::vector<std::string> written = spec.files();
  for (const std::string& path : {spec.statistics, spec.checkpoint}) {
    if (!path.empty()) check_writable(path);
  }
  check_distinct(written);
  check_spares(written, {a.checkpoints.begin(), a.checkpoints.end()});
  std::optional<FileLock> lock;
  if (!spec.checkpoint.empty()) lock.emplace(lock_checkpoint(spec.checkpoint));

  std::vector<NamedCheckpoint> parts;
  for (const std::string& path : a.checkpoints) parts.push_back({path, read_checkpoint(path)});
  Checkpoint merged = ajar::merge(std::move(parts), spec.force);
  RenderStatistics statistics = statistics_of_merged(merged);
  statistics.render.spec.checkpoint = spec.checkpoint;

  const std::string& first = a.checkpoints.front();
  const std::vector<std::string> aovs = merged.render.spec.layers;
  const Film film = film_of(merged, Filter::box(), first);
  merged.render.spec.denoise = denoise;
  if (!spec.checkpoint.empty()) write_checkpoint(spec.checkpoint, merged, film.raw());
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
    PictureFilter filter(
        std::move(denoiser),
        [&merged](std::uint32_t /*rays*/, const Denoiser::Progress&) { return merged.features; });
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
       write_final_files(picture_files(picture, spec.outputs, display), nullptr)) {
    all_written = report_file(file) && all_written;
    if (file.path.empty()) continue;
    statistics.outputs.push_back(file.path);
    print_path(file.path);
  }
  statistics.peak_memory_bytes = peak_memory_bytes();
  const std::string complaint = write_statistics(statistics, spec.statistics);
  if (!complaint.empty()) print_error(complaint);
  all_written = complaint.empty() && all_written;
  print_note(end_text(statistics.result, 0.0, statistics.denoised_error));
  report_exposure(picture, spec.outputs, display, wanted.exposure.automatic);
  return all_written ? 0 : kExitFile;
}

}  // namespace ajar::cli
