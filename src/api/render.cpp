#include "ajar/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/contents.h"
#include "core/error.h"
#include "session/job/progress.h"
#include "session/options/filter_option.h"
#include "session/options/limits.h"
#include "session/render.h"
#include "session/scenes/catalog.h"

namespace ajar::v0 {

namespace {

template <typename Number>
void check_given(const Limits<Number>& limits, const std::optional<Number>& value,
                 const std::string& name) {
  if (value) check_within(limits, *value, name);
}

/// Refuses settings as the command line does; names are those of `Settings`.
void check_numbers(const Settings& settings) {
  check_given(limits::kSamples, settings.samples_per_pixel, "samples_per_pixel");
  check_given(limits::kSeconds, settings.seconds, "seconds");
  check_given(limits::kRelativeError, settings.target_error, "target_error");
  check_given(limits::kScale, settings.scale, "scale");
  check_given(limits::kDepth, settings.min_depth, "min_depth");
  check_given(limits::kDepth, settings.max_depth, "max_depth");
  if (settings.min_depth && settings.max_depth && *settings.min_depth > *settings.max_depth) {
    throw UsageError(fmt::format("min_depth: must be at most max_depth, {}, not {}",
                                 *settings.max_depth, *settings.min_depth));
  }
  if (settings.resolution) {
    for (const int side : *settings.resolution) {
      check_within(limits::kResolution, side, "resolution");
    }
  }
  if (settings.crop) {
    for (const int edge : *settings.crop) check_within(limits::kCropEdge, edge, "crop");
    const auto [x0, y0, x1, y1] = *settings.crop;
    if (x1 <= x0 || y1 <= y0) {
      throw UsageError(
          "crop: x0, y0, x1, y1 are pixels from the top left corner, with x0 < x1 and y0 < y1");
    }
  }
  check_within(limits::kThreads, settings.threads, "threads");
  check_within(limits::kSeconds, settings.checkpoint_every, "checkpoint_every");
}

RenderOrder order_of(const Scene::Content& scene, const Settings& settings, bool shows_pictures,
                     double picture_every) {
  check_numbers(settings);
  RenderOrder order;
  order.scene = scene.name;
  order.loaded = scene.loaded;
  RenderRequest& request = order.request.emplace();
  if (!settings.integrator.empty()) find_integrator(settings.integrator);
  request.integrator = settings.integrator;
  request.parameters = settings.parameters;
  request.budget = {settings.samples_per_pixel, settings.seconds, settings.target_error,
                    settings.denoised_target};
  if (settings.resolution) {
    request.resolution = Vec2i(settings.resolution->at(0), settings.resolution->at(1));
  }
  request.scale = settings.scale;
  if (settings.crop) {
    request.crop = {.fractions = false};
    std::copy(settings.crop->begin(), settings.crop->end(), request.crop->values.begin());
  }
  if (!settings.filter.empty()) parse_filter("filter", settings.filter);
  request.filter = settings.filter;
  request.depth = {settings.min_depth, settings.max_depth};
  request.aovs = checked_aovs(settings.layers);
  order.all_aovs = settings.layers == std::vector<std::string>{"all"};
  order.files.denoiser = settings.denoise;
  request.seed = settings.seed;
  order.size_from_scene = !settings.resolution && !settings.scale;
  order.threads = settings.threads;
  if (shows_pictures) {
    if (!(picture_every >= 0.0)) throw UsageError("picture_every: must be seconds from 0 on");
    order.show_every = picture_every;
  }
  if (settings.resume && settings.checkpoint.empty()) {
    throw UsageError("resume needs a checkpoint: the name of the file to go on with");
  }
  if (!settings.checkpoint.empty()) {
    order.files.checkpoint = settings.checkpoint;
    order.files.checkpoint_every = settings.checkpoint_every;
    lock_checkpoint_of(order);
    if (settings.resume) resume_if_there(settings.checkpoint, order);
  }
  return order;
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
  // Names of files need not be UTF-8.
  using Json = nlohmann::ordered_json;
  return to_json(parts_->render.statistics()).dump(2, ' ', false, Json::error_handler_t::replace);
}

Picture render(const Scene& scene, const Settings& settings) {
  return Render(scene, settings).run();
}

}  // namespace ajar::v0
