#include "api/c/handles.h"
#include "api/c/json_text.h"
#include "api/c/settings_json.h"

using ajar::c::give_text;
using ajar::c::given;
using ajar::c::guarded;
using ajar::c::Json;

namespace {

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

int ajar_render_start(const ajar_scene* scene, const char* settings, ajar_render** render) {
  return guarded([&] {
    given(render, "render") = nullptr;
    *render = new ajar_render{{given(scene, "scene").scene,
                               ajar::c::settings_from_json(settings == nullptr ? "{}" : settings)}};
  });
}

int ajar_render_wait(ajar_render* render, double seconds, int* done) {
  return guarded([&] {
    if (done != nullptr) *done = 1;
    const bool is_done = given(render, "render").render.wait(seconds);
    if (done != nullptr) *done = is_done ? 1 : 0;
  });
}

int ajar_render_stop(ajar_render* render) {
  return guarded([&] { given(render, "render").render.stop(); });
}

int ajar_render_picture(ajar_render* render, ajar_picture** picture) {
  return guarded([&] {
    given(picture, "picture") = nullptr;
    if (auto made = given(render, "render").render.picture()) {
      *picture = new ajar_picture{std::move(*made)};
    }
  });
}

int ajar_render_progress(ajar_render* render, char** json) {
  return guarded([&] {
    const ajar::c::BackgroundRender& of = given(render, "render").render;
    const bool is_done = of.is_done();
    const ajar::v0::Progress progress = of.progress();
    give_text(ajar::c::json_text({{"preparing", progress.preparing},
                                  {"seconds", progress.seconds},
                                  {"samples_per_pixel", progress.samples_per_pixel},
                                  {"fraction", number_or_null(progress.fraction)},
                                  {"estimated_error", number_or_null(progress.estimated_error)},
                                  {"error_is_lower_bound", progress.error_is_lower_bound},
                                  {"done", is_done}}),
              json);
  });
}

int ajar_render_statistics(ajar_render* render, char** json) {
  return guarded([&] { give_text(given(render, "render").render.statistics(), json); });
}

int ajar_render_messages(ajar_render* render, char** json) {
  return guarded([&] {
    const auto messages = given(render, "render").render.messages();
    give_text(ajar::c::json_text({{"warnings", messages.warnings},
                                  {"troubles", messages.troubles},
                                  {"notes", messages.notes}}),
              json);
  });
}

void ajar_render_free(ajar_render* render) { delete render; }
