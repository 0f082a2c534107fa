#include "session/render/render_files.h"

#include "post/denoise/denoiser.h"
#include "session/output/output.h"
#include "session/output/written_paths.h"
#include "session/preview/tcp_stream.h"
#include "session/scenes/scene_file.h"

namespace ajar {

void check_files(const RenderRequest& request) {
  const RenderSpec& spec = request.spec;
  // Told before anything is loaded.
  if (!spec.preview.empty()) {
    find_addresses("--preview", parse_viewer("--preview", spec.preview));
  }
  if (!request.is_root()) return;
  find_denoiser(spec.denoiser_name());
  // An interrupted render that goes on where its folder is gone is told so in the end.
  if (!request.as_before) check_picture_paths(spec.outputs);
  for (const std::string& path : {spec.statistics, spec.checkpoint}) {
    if (!path.empty() && path != request.resumed_from) check_writable(path);
  }
  if (!spec.checkpoint.empty()) check_new_checkpoint(spec.checkpoint, request.resumed_from);
  check_distinct(spec.files());
}

void complete_files(RenderRequest& request, const desc::SceneDesc& description) {
  RenderSpec& spec = request.spec;
  if (spec.outputs.empty() && request.default_pictures) {
    spec.outputs = default_outputs(description.film.filename, scene_stem(request.scene));
    if (request.is_root()) check_picture_paths(spec.outputs);
  }
  if (!request.is_root()) return;
  check_distinct(spec.files());
  check_spares(spec.files(), description.files);
}

}  // namespace ajar
