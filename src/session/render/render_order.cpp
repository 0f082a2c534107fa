#include "session/render/render_order.h"

#include <filesystem>

#include "image/tone_curve.h"

namespace ajar {

Display RenderFiles::display() const {
  return {tone_map_by_name(tone_map_name()), exposure.value_or(Exposure())};
}

std::vector<std::string> RenderFiles::all() const {
  std::vector<std::string> paths = pictures;
  for (const std::string& path : {statistics, checkpoint}) {
    if (!path.empty()) paths.push_back(path);
  }
  return paths;
}

void lock_checkpoint_of(RenderOrder& order) {
  const std::string& path = order.files.checkpoint;
  if (order.is_root() && !path.empty()) order.lock.emplace(lock_checkpoint(path));
}

bool resume_if_there(const std::string& path, RenderOrder& order) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return false;
  order.resumed = read_checkpoint(path);
  order.resumed_from = path;
  return true;
}

void resume_from(const std::string& path, RenderOrder& order) {
  if (order.files.checkpoint.empty()) order.files.checkpoint = path;
  lock_checkpoint_of(order);
  order.resumed = read_checkpoint(path);
  order.resumed_from = path;
  const Checkpoint& checkpoint = *order.resumed;
  if (order.scene.empty()) order.scene = checkpoint.render.scene;
  order.definitions = checkpoint.render.definitions;
  order.share = checkpoint.render.share;
  if (order.budget.is_empty()) order.budget = checkpoint.budget;
  RenderFiles& files = order.files;
  if (files.pictures.empty()) files.pictures = checkpoint.outputs;
  if (files.tone_map.empty()) files.tone_map = checkpoint.tone_map;
  if (!files.exposure) files.exposure = checkpoint.exposure;
  if (files.denoiser.empty()) files.denoiser = checkpoint.denoiser;
}

}  // namespace ajar
