#include "apps/cli/commands.h"
#include "apps/cli/denoise_progress.h"
#include "apps/cli/exit_codes.h"
#include "apps/cli/messages.h"
#include "apps/cli/render_report.h"
#include "core/error.h"
#include "imageio/read_picture.h"
#include "os/available_memory.h"
#include "session/output/denoise_file.h"
#include "session/output/output.h"
#include "session/output/written_paths.h"

namespace ajar::cli {

int denoise(const DenoiseArguments& a) {
  const std::vector<std::string>& outputs = a.spec.outputs;
  const std::string how = a.spec.denoise.empty() ? "auto" : a.spec.denoise;
  const Display wanted = a.spec.display();
  std::string note;
  std::shared_ptr<const Denoiser> denoiser = find_denoiser(how, &note);
  if (!note.empty()) print_note(note);
  if (!denoiser) {
    throw UsageError("denoise: there is nothing to denoise with (--denoise " + how + ")");
  }
  check_picture_paths(outputs);
  check_distinct(outputs);
  check_spares(outputs, {a.picture});
  Picture picture = read_picture(a.picture);
  std::string why_another;
  denoiser = fitting_denoiser(picture, std::move(denoiser), how == "auto", available_memory_bytes(),
                              why_another);
  if (!why_another.empty()) print_note(why_another);
  if (!has_features(picture)) {
    print_note(a.picture +
               " does not know the surfaces of its scene, so edges may blur; ajar render "
               "writes them with --denoise auto or --aov albedo,normal");
  }
  const bool is_filtered = denoise_with_progress([&](const Denoiser::Progress& progress) {
    return denoise_picture(picture, std::move(denoiser), progress);
  });
  if (!is_filtered) {
    print_note("interrupted: nothing is written");
    return kExitInterrupted;
  }
  const DisplayOptions display = wanted.of(picture);
  bool all_written = true;
  for (const WrittenFile& file :
       write_final_files(picture_files(picture, outputs, display), nullptr)) {
    all_written = report_file(file) && all_written;
    if (!file.path.empty()) print_path(file.path);
  }
  report_exposure(picture, outputs, display, wanted.exposure.automatic);
  return all_written ? 0 : kExitFile;
}

}  // namespace ajar::cli
