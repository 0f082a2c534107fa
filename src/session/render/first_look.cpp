#include "session/render/first_look.h"

#include <cmath>
#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "session/output/stats_json.h"
#include "session/scenes/scene_file.h"

namespace ajar {

namespace {

void show(RenderState& state, std::vector<float> rgb) {
  const auto scale = static_cast<float>(state.plan->record.film_scale);
  for (float& value : rgb) value *= scale;
  auto picture = std::make_shared<Picture>();
  picture->resolution = state.plan->setup.settings.resolution;
  picture->crop = state.plan->setup.settings.crop;
  picture->layers.push_back({"", 3, std::move(rgb)});
  picture->metadata = to_metadata(state.statistics);
  if (state.preview) state.preview->show(*picture);
  if (std::isfinite(state.request.show_every) || state.events.wants_picture()) {
    state.events.picture(*picture);
  }
  state.monitor.publish(std::move(picture));
}

}  // namespace

void open_preview(RenderState& state) {
  const std::string& viewer = state.request.spec.preview;
  if (viewer.empty() || !state.request.is_root()) return;
  PreviewOptions options;
  options.viewer = parse_viewer("--preview", viewer);
  options.name = "ajar: " + scene_stem(state.request.scene);
  options.film_scale = state.plan->record.film_scale;
  options.aovs = state.plan->setup.aovs;
  options.note = [&events = state.events](const std::string& text) { events.note(text); };
  state.preview = std::make_unique<Preview>(std::move(options), *state.integrator);
}

void show_first_look(RenderState& state, std::vector<float> rgb) {
  try {
    show(state, std::move(rgb));
  } catch (const std::exception& error) {
    // Errors of a listener, or for want of memory.
    state.events.trouble(std::string("no picture of the preparation: ") + error.what());
  }
}

}  // namespace ajar
