#include "session/render/render_files.h"

#include "post/denoise/denoiser.h"
#include "session/output/output.h"
#include "session/output/written_paths.h"
#include "session/scenes/scene_file.h"

namespace ajar {

void check_files(const RenderOrder& order) {
  const RenderFiles& files = order.files;
  // Told before anything is loaded.
  if (files.preview) find_addresses("--preview", *files.preview);
  if (!order.is_root()) return;
  find_denoiser(files.denoiser_name());
  // An interrupted render that goes on where its folder is gone is told so in the end.
  if (order.request) check_picture_paths(files.pictures);
  for (const std::string& path : {files.statistics, files.checkpoint}) {
    if (!path.empty() && path != order.resumed_from) check_writable(path);
  }
  if (!files.checkpoint.empty()) check_new_checkpoint(files.checkpoint, order.resumed_from);
  check_distinct(files.all());
}

void complete_files(RenderOrder& order, const desc::SceneDesc& description) {
  RenderFiles& files = order.files;
  if (files.pictures.empty() && files.default_pictures) {
    files.pictures = default_outputs(description.film.filename, scene_stem(order.scene));
    if (order.is_root()) check_picture_paths(files.pictures);
  }
  if (!order.is_root()) return;
  check_distinct(files.all());
  check_spares(files.all(), description.files);
}

}  // namespace ajar
