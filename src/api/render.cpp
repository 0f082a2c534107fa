#include "ajar/render.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/contents.h"
#include "core/error.h"
#include "session/job/progress.h"
#include "session/options/render_options.h"
#include "session/render.h"

namespace ajar::v0 {

namespace {

RenderRequest order_of(const Scene::Content& scene, const Settings& settings, bool shows_pictures,
                       double picture_every) {
  RenderRequest request;
  request.scene = scene.name;
  request.loaded = scene.loaded;
  request.spec = RenderSpec(settings);
  check_options(request.spec, &RenderOption::in_settings);
  if (shows_pictures) {
    if (!(picture_every >= 0.0)) throw UsageError("picture_every: must be seconds from 0 on");
    request.show_every = picture_every;
  }
  if (settings.resume && settings.checkpoint.empty()) {
    throw UsageError("resume needs a checkpoint: the name of the file to go on with");
  }
  lock_checkpoint_of(request);
  if (settings.resume) resume_if_there(settings.checkpoint, request);
  return request;
}

Progress progress_of(const RenderSnapshot& snapshot) {
  Progress progress;
  progress.preparing = snapshot.phase == RenderPhase::Prepare;
  progress.seconds = snapshot.seconds;
  progress.samples_per_pixel = snapshot.samples_done;
  progress.fraction = fraction_done(snapshot);
  if (const auto& error = snapshot.relative_error) {
    progress.estimated_error = error->value;
    progress.error_is_lower_bound = error->is_lower_bound();
  }
  return progress;
}

/// Passes what a render tells on to those who want to be called.
class Caller final : public RenderEvents {
 public:
  explicit Caller(Callbacks callbacks) : callbacks_(std::move(callbacks)) {}
  void progress(const RenderSnapshot& snapshot) override {
    if (callbacks_.progress) callbacks_.progress(progress_of(snapshot));
  }
  void picture(const ajar::Picture& picture) override {
    callbacks_.picture(public_picture(std::make_shared<const ajar::Picture>(picture)));
  }
  void scene_warnings(const Warnings& warnings) override {
    for (const std::string& text : warnings.messages()) warn(text);
  }
  void warning(const Warning& warning) override { warn(warning.text()); }
  void trouble(const std::string& text) override {
    if (callbacks_.trouble) {
      callbacks_.trouble(text);
    } else {
      warn(text);
    }
  }
  void note(const std::string& text) override {
    if (callbacks_.note) callbacks_.note(text);
  }
  void finished(const RenderOutcome& outcome) override {
    for (const WrittenFile& file : outcome.files) {
      if (file.error.empty()) continue;
      trouble(file.path.empty() ? fmt::format("{}; {} is lost: it could be written nowhere",
                                              file.error, file.what)
                                : fmt::format("{}; {} is in {} instead", file.error, file.what,
                                              std::filesystem::absolute(file.path).string()));
    }
  }

 private:
  void warn(const std::string& text) {
    if (callbacks_.warning) callbacks_.warning(text);
  }
  Callbacks callbacks_;
};

}  // namespace

struct Render::Parts {
  Parts(const Scene& scene, const Settings& settings, const Callbacks& callbacks)
      : caller(callbacks),
        render(order_of(scene.content(), settings, static_cast<bool>(callbacks.picture),
                        callbacks.picture_every),
               caller) {}
  Caller caller;
  ajar::Render render;
};

Render::Render(Scene scene, const Settings& settings, Callbacks callbacks)
    : parts_(
          with_public_errors([&] { return std::make_unique<Parts>(scene, settings, callbacks); })) {
}
Render::~Render() = default;
Render::Render(Render&&) noexcept = default;
Render& Render::operator=(Render&&) noexcept = default;

Picture Render::run() {
  return with_public_errors([&] {
    const RenderOutcome& outcome = parts_->render.run();
    if (!outcome.picture) {
      throw Error(Error::Kind::Stopped, "the render was stopped before there was a picture");
    }
    return public_picture(outcome.picture);
  });
}

void Render::stop() { parts_->render.stop(); }
Progress Render::progress() const { return progress_of(parts_->render.snapshot()); }

std::optional<Picture> Render::picture() const {
  std::shared_ptr<const ajar::Picture> picture = parts_->render.picture();
  if (!picture) return std::nullopt;
  return public_picture(std::move(picture));
}

std::string Render::statistics() const {
  return json_text(to_json(parts_->render.statistics()), 2);
}

Picture render(const Scene& scene, const Settings& settings) {
  return Render(scene, settings).run();
}

}  // namespace ajar::v0
