#include "session/render/render_files.h"

#include "post/denoise/denoiser.h"
#include "session/output/output.h"
#include "session/output/written_paths.h"
#include "session/preview/tcp_stream.h"
#include "session/scenes/scene_file.h"

namespace ajar {

void check_files(const RenderOrder& order) {
  const RenderSpec& spec = order.spec;
  // Told before anything is loaded.
  if (!spec.preview.empty()) {
    find_addresses("--preview", parse_viewer("--preview", spec.preview));
  }
  if (!order.is_root()) return;
  find_denoiser(spec.denoiser_name());
  // An interrupted render that goes on where its folder is gone is told so in the end.
  if (!order.as_before) check_picture_paths(spec.outputs);
  for (const std::string& path : {spec.statistics, spec.checkpoint}) {
    if (!path.empty() && path != order.resumed_from) check_writable(path);
  }
  if (!spec.checkpoint.empty()) check_new_checkpoint(spec.checkpoint, order.resumed_from);
  check_distinct(spec.files());
}

void complete_files(RenderOrder& order, const desc::SceneDesc& description) {
  RenderSpec& spec = order.spec;
  if (spec.outputs.empty() && order.default_pictures) {
    spec.outputs = default_outputs(description.film.filename, scene_stem(order.scene));
    if (order.is_root()) check_picture_paths(spec.outputs);
  }
  if (!order.is_root()) return;
  check_distinct(spec.files());
  check_spares(spec.files(), description.files);
}

}  // namespace ajar
