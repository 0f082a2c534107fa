#include "session/render/render_request.h"

#include <filesystem>

#include "session/options/render_options.h"

namespace ajar {

void lock_checkpoint_of(RenderRequest& request) {
  const std::string& path = request.spec.checkpoint;
  if (request.is_root() && !path.empty()) request.lock.emplace(lock_checkpoint(path));
}

bool resume_if_there(const std::string& path, RenderRequest& request) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return false;
  request.resumed = read_checkpoint(path);
  request.resumed_from = path;
  return true;
}

void resume_from(const std::string& path, RenderRequest& request) {
  RenderSpec& spec = request.spec;
  if (spec.checkpoint.empty()) spec.checkpoint = path;
  lock_checkpoint_of(request);
  request.resumed = read_checkpoint(path);
  request.resumed_from = path;
  request.as_before = true;
  const RenderRecord& before = request.resumed->render;
  if (request.scene.empty()) request.scene = before.scene;
  // One limit replaces all.
  const bool has_budget = !spec.budget().is_empty();
  for (const RenderOption& option : render_options()) {
    const bool is_new = option.has(commands::kResume) &&
                        (option.group == OptionGroup::Stop ? has_budget : is_given(option, spec));
    if (option.is_kept && !is_new) copy_option(option, before.spec, spec);
  }
}

}  // namespace ajar
