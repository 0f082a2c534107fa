#include "session/render/render_order.h"

#include <filesystem>

#include "session/options/render_options.h"

namespace ajar {

void lock_checkpoint_of(RenderOrder& order) {
  const std::string& path = order.spec.checkpoint;
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
  RenderSpec& spec = order.spec;
  if (spec.checkpoint.empty()) spec.checkpoint = path;
  lock_checkpoint_of(order);
  order.resumed = read_checkpoint(path);
  order.resumed_from = path;
  order.as_before = true;
  const RenderRecord& before = order.resumed->render;
  if (order.scene.empty()) order.scene = before.scene;
  // One limit replaces all.
  const bool has_budget = !spec.budget().is_empty();
  for (const RenderOption& option : render_options()) {
    const bool is_new = option.has(commands::kResume) &&
                        (option.group == OptionGroup::Stop ? has_budget : is_given(option, spec));
    if (option.is_kept && !is_new) copy_option(option, before.spec, spec);
  }
}

}  // namespace ajar
