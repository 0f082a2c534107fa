#include "apps/viewer/live_render.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "core/error.h"
#include "core/number_text.h"
#include "import/code/scene_changes.h"
#include "integrator/integrator.h"
#include "session/output/write_picture.h"
#include "session/scenes/scene_file.h"

namespace ajar::viewer {

namespace {

/// Samples per pixel of a render that nothing but a person ends.
constexpr std::uint64_t kEndless = std::uint64_t{1} << 31U;
constexpr std::size_t kMostUndone = 200;
/// Part of the time in which pictures are developed for pages, unless they wait too long for them.
constexpr double kShareOfPictures = 0.03;
constexpr double kLongestWait = 2.0;
/// Layers to look at, as far as the method makes them.
constexpr std::array kLayers = {"albedo",  "normal",  "depth",          "object-id", "material-id",
                                "samples", "noise",   "standard-error", "regions",   "importance",
                                "edges",   "density", "acceptance"};
constexpr std::size_t kMostHistory = 2000;

std::filesystem::path make_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "ajar-view-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw IoError("view: no folder for temporary files can be made: " + name);
  }
  return name;
}

bool is_light(const Picture::Layer& layer) {
  static const std::set<std::string> kLight = {"", "direct", "indirect"};
  return kLight.contains(layer.name);
}

double samples_of(const Picture& picture) {
  return metadata_number(picture, "ajar:samples_per_pixel").value_or(0.0);
}

/// Error of the mean of two pictures by samples.
double error_of_sum(double a, double samples_of_a, double b, double samples_of_b) {
  return std::hypot(a * samples_of_a, b * samples_of_b) / (samples_of_a + samples_of_b);
}

void write_mask(const std::string& path, const Mask& mask) {
  Picture picture;
  picture.resolution = mask.size;
  picture.crop = Box2i(Vec2i(0, 0), mask.size - Vec2i(1, 1));
  Picture::Layer layer{"", 3, {}};
  for (const std::uint8_t weight : mask.weights) {
    // Where nothing was painted chains make what the method leaves to them.
    const float value = weight == 255 ? 1.F : static_cast<float>(weight) / 254.F;
    layer.pixels.insert(layer.pixels.end(), 3, value);
  }
  picture.layers.push_back(std::move(layer));
  write_picture(path, picture);
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw IoError("view: cannot write " + path);
}

/// Gives a preview about as many pixels as can be rendered between two moves of a mouse.
int preview_coarseness(const Vec2i& resolution) {
  constexpr int kLongerSide = 320;
  return std::max(1, (std::max(resolution.x, resolution.y) + kLongerSide - 1) / kLongerSide);
}

/// Plain path tracing, which needs no preparation.
void make_preview(RenderSpec& spec, const Vec2i& resolution, int coarseness) {
  spec.integrator = "pt";
  spec.parameters.clear();
  spec.layers = {"object-id"};
  spec.scale.reset();
  spec.resolution = {std::max(1, resolution.x / coarseness),
                     std::max(1, resolution.y / coarseness)};
  spec.crop.reset();
  spec.crop_window.reset();
}

bool has_parameter(const std::string& integrator, const std::string& name) {
  for (const ParameterSpec& spec : find_integrator(integrator).parameters) {
    if (spec.name == name) return true;
  }
  return false;
}

}  // namespace

const char* to_string(LivePhase phase) {
  static constexpr std::array kNames = {"loading", "preparing", "rendering",
                                        "paused",  "finished",  "failed"};
  return kNames[static_cast<std::size_t>(phase)];
}

std::optional<double> metadata_number(const Picture& picture, const std::string& key) {
  const auto found = picture.metadata.find(key);
  return found == picture.metadata.end() ? std::nullopt : number_of(found->second);
}

Picture add_epochs(const Picture& a, double samples_of_a, const Picture& b, double samples_of_b) {
  Picture sum = b;
  const auto part = static_cast<float>(samples_of_a / (samples_of_a + samples_of_b));
  for (Picture::Layer& layer : sum.layers) {
    const Picture::Layer* other = is_light(layer) ? layer_named(a, layer.name) : nullptr;
    if (other == nullptr || other->pixels.size() != layer.pixels.size()) continue;
    for (std::size_t i = 0; i < layer.pixels.size(); ++i) {
      layer.pixels[i] += part * (other->pixels[i] - layer.pixels[i]);
    }
  }
  return sum;
}

struct LiveRender::Job {
  LiveState state;
  std::uint64_t version = 0;
  int coarseness = 1;
};

/// Listens to one render, on the thread that renders.
class LiveRender::Events final : public RenderEvents {
 public:
  Events(LiveRender& live, std::uint64_t version) : live_(live), version_(version) {}

  void phase_begun(RenderPhase phase) override {
    const std::lock_guard lock(live_.mutex_);
    if (phase == RenderPhase::Render) live_.status_.phase = LivePhase::Rendering;
  }
  void progress(const RenderSnapshot& snapshot) override {
    const std::lock_guard lock(live_.mutex_);
    LiveStatus& status = live_.status_;
    if (!snapshot.relative_error) return;
    double error = snapshot.relative_error->value;
    if (live_.error_before_) {
      error =
          error_of_sum(*live_.error_before_, live_.samples_before_, error, snapshot.samples_done);
    }
    status.error = error;
    status.error_is_lower_bound = snapshot.relative_error->is_lower_bound();
    const double seconds = live_.seconds_before_ + snapshot.seconds;
    if (status.history.size() < kMostHistory &&
        (status.history.empty() || seconds > 1.02 * status.history.back().first)) {
      status.history.emplace_back(seconds, error);
    }
  }
  bool wants_picture() override {
    {
      const std::lock_guard lock(live_.mutex_);
      if (live_.paused_ || live_.has_reached_limits()) return true;
    }
    if (clock_.seconds() < due_ || !live_.listener_.wants_picture()) return false;
    wanted_at_ = clock_.seconds();
    return true;
  }
  void picture(const Picture& picture) override {
    live_.take(picture);
    live_.listener_.changed();
    const double now = clock_.seconds();
    due_ = now + std::min(kLongestWait, (now - wanted_at_) / kShareOfPictures);
    std::unique_lock lock(live_.mutex_);
    if (live_.has_reached_limits()) live_.paused_ = true;
    if (!live_.paused_ || live_.status_.phase != LivePhase::Rendering) return;
    live_.status_.phase = LivePhase::Paused;
    live_.listener_.changed();
    live_.wake_.wait(lock,
                     [&] { return !live_.paused_ || live_.ended_ || live_.version_ != version_; });
    live_.status_.phase = LivePhase::Rendering;
  }
  void scene_warnings(const Warnings& warnings) override {
    for (const std::string& text : warnings.messages()) live_.listener_.note(true, text);
  }
  void warning(const Warning& warning) override { tell(true, warning.text()); }
  void trouble(const std::string& text) override { tell(true, text); }
  void note(const std::string& text) override { tell(false, text); }

 private:
  /// Nobody wants to hear of a render that was stopped for another.
  void tell(bool is_warning, const std::string& text) {
    {
      const std::lock_guard lock(live_.mutex_);
      if (live_.version_ != version_) return;
    }
    live_.listener_.note(is_warning, text);
  }

  LiveRender& live_;
  std::uint64_t version_;
  Stopwatch clock_;
  double wanted_at_ = 0.0;
  double due_ = 0.0;  ///< time of the next picture
};

LiveRender::LiveRender(Options options, Listener& listener)
    : options_(std::move(options)), listener_(listener) {
  state_.integrator = options_.spec.integrator;
  state_.parameters = options_.spec.parameters;
  state_.resolution = options_.spec.resolution;
  state_.crop = options_.spec.crop;
  load();
  folder_ = make_folder();
  thread_ = std::thread([this] { work(); });
}

LiveRender::~LiveRender() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    ++version_;
    if (current_) {
      current_->stop();
      current_->stop();
    }
  }
  wake_.notify_all();
  thread_.join();
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

// ---------------------------------------------------------------- changes

void LiveRender::begin_anew(bool is_other_picture) {
  ++version_;
  paused_ = false;
  if (current_) {
    current_->stop();
    // The pass that runs is of use if its picture is; a preparation is not.
    const bool keeps = !is_other_picture && status_.phase != LivePhase::Preparing;
    if (!keeps) current_->stop();
  }
  wake_.notify_all();
}

void LiveRender::change(const std::function<void(LiveState&)>& edit, bool is_passing) {
  {
    const std::lock_guard lock(mutex_);
    LiveState next = state_;
    edit(next);
    if (!is_passing_) {
      undo_.push_back(state_);
      if (undo_.size() > kMostUndone) undo_.erase(undo_.begin());
    }
    redo_.clear();
    is_passing_ = is_passing;
    const bool is_other = next.is_other_picture(state_);
    state_ = std::move(next);
    begin_anew(is_other);
  }
  listener_.changed();
}

void LiveRender::step(States& from, States& to) {
  {
    const std::lock_guard lock(mutex_);
    if (from.empty()) return;
    to.push_back(std::move(state_));
    state_ = std::move(from.back());
    from.pop_back();
    is_passing_ = false;
    begin_anew(state_.is_other_picture(to.back()));
  }
  listener_.changed();
}

void LiveRender::restart() {
  {
    const std::lock_guard lock(mutex_);
    rendered_.reset();
    begin_anew(true);
  }
  listener_.changed();
}

void LiveRender::pause(bool paused) {
  {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
    // A limit that was reached would end it again.
    if (!paused && has_reached_limits()) stop_at_ = {};
  }
  wake_.notify_all();
  listener_.changed();
}

void LiveRender::stop_at(const StopAt& limits) {
  {
    const std::lock_guard lock(mutex_);
    stop_at_ = limits;
    if (!has_reached_limits()) paused_ = false;
  }
  wake_.notify_all();
  listener_.changed();
}

bool LiveRender::has_reached_limits() const {
  if (status_.phase != LivePhase::Rendering && status_.phase != LivePhase::Paused) return false;
  const double samples = samples_before_ + (current_ ? current_->snapshot().samples_done : 0.0);
  const double seconds = seconds_before_ + (current_ ? current_->snapshot().seconds : 0.0);
  return (stop_at_.samples && samples >= *stop_at_.samples) ||
         (stop_at_.seconds && seconds >= *stop_at_.seconds) ||
         (stop_at_.error && status_.error && !status_.error_is_lower_bound &&
          *status_.error <= *stop_at_.error);
}

// ---------------------------------------------------------------- rendering

void LiveRender::work() {
  while (true) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ended_ || version_ != begun_; });
      if (ended_) return;
      job = {state_, version_, is_passing_ ? preview_coarseness(status_.resolution) : 1};
      begun_ = version_;
    }
    try {
      begin(job);
      render(job);
    } catch (const std::exception& error) {
      fail(error.what());
    }
  }
}

void LiveRender::load() {
  Warnings warnings;
  auto loaded = std::make_shared<LoadedScene>(
      load_scene(options_.scene, warnings, options_.spec.definitions));
  for (const std::string& text : warnings.messages()) listener_.note(true, text);
  original_ = std::move(loaded);
  loaded_ = original_;
  if (state_.integrator.empty()) {
    state_.integrator = original_->description().hints.integrator;
    if (state_.integrator.empty()) state_.integrator = "selective";
  }
}

void LiveRender::fail(const std::string& why) {
  {
    const std::lock_guard lock(mutex_);
    current_.reset();
    if (version_ != begun_) return;  // stopped for another
    status_.phase = LivePhase::Failed;
    status_.message = why;
  }
  listener_.note(true, why);
  listener_.changed();
}

/// Keeps what stays valid of the epochs before, and builds what does not.
void LiveRender::begin(Job& job) {
  std::shared_ptr<LoadedScene> loaded = loaded_;
  const bool is_other_scene = !rendered_ || job.state.is_other_scene(*rendered_);
  // A preview is another picture, and so is what comes after it.
  const bool is_other =
      !rendered_ || job.state.is_other_picture(*rendered_) || job.coarseness > 1 || coarseness_ > 1;
  if (is_other_scene && (job.state.camera || !job.state.edits.empty())) {
    desc::SceneDesc description = original_->description();
    if (job.state.camera) move_camera(description.camera, *job.state.camera);
    if (!job.state.edits.empty()) {
      Warnings warnings;
      const nlohmann::json changes = {{"edits", job.state.edits}};
      description = changed_scene(std::move(description), changes.dump(), {}, warnings);
    }
    loaded = std::make_shared<LoadedScene>(std::move(description));
  } else if (is_other_scene) {
    loaded = original_;
  }
  const std::lock_guard lock(mutex_);
  loaded_ = std::move(loaded);
  if (is_other_scene) built_.reset();
  if (is_other) {
    before_ = newest_ = nullptr;
    samples_before_ = seconds_before_ = 0.0;
    error_before_.reset();
    ++status_.epoch;
    status_.history.clear();
    status_.error.reset();
  } else {
    keep_epoch();
  }
  samples_ = 0.0;
  rendered_ = job.state;
  coarseness_ = job.coarseness;
  status_.phase = LivePhase::Preparing;
  status_.message.clear();
}

void LiveRender::keep_epoch() {
  if (newest_ == nullptr || samples_ == 0.0) return;
  before_ = shown_;
  samples_before_ += samples_;
  error_before_ = status_.error;
  newest_.reset();
}

std::string LiveRender::regions_file(const LiveState& state) const {
  if (state.mask) {
    const std::string path = folder_ / "mask.exr";
    write_mask(path, *state.mask);
    return path;
  }
  if (state.rules.empty()) return {};
  const std::string path = folder_ / "regions.txt";
  write_text(path, rules_text(state.rules));
  return path;
}

RenderRequest LiveRender::request_of(const Job& job) const {
  RenderRequest request;
  request.scene = options_.scene;
  request.loaded = loaded_;
  request.spec = options_.spec;
  request.spec.outputs.clear();
  request.spec.denoise = "none";
  if (request.spec.layers.empty()) request.spec.layers.assign(kLayers.begin(), kLayers.end());
  request.may_lack_layers = true;
  Budget budget;
  budget.samples_per_pixel = kEndless;
  request.spec.set_budget(budget);
  request.spec.integrator = job.state.integrator;
  request.spec.parameters = job.state.parameters;
  request.spec.resolution = job.state.resolution;
  if (job.state.resolution) request.spec.scale.reset();
  request.spec.crop = job.state.crop;
  // Epochs must not repeat each other.
  request.spec.seed = options_.spec.seed + job.version - 1;
  if (job.coarseness > 1) {
    make_preview(request.spec, status_.resolution, job.coarseness);
    return request;
  }
  if (has_parameter(job.state.integrator, "regions")) {
    const std::string file = regions_file(job.state);
    if (!file.empty()) request.spec.parameters["regions"] = file;
  }
  return request;
}

void LiveRender::render(Job& job) {
  Events events(*this, job.version);
  const auto render = std::make_shared<Render>(request_of(job), events);
  {
    const std::lock_guard lock(mutex_);
    if (version_ != job.version) return;
    current_ = render;
  }
  listener_.changed();
  const RenderOutcome& outcome = render->run();
  const bool is_whole = outcome.picture && outcome.statistics.result.complete &&
                        outcome.statistics.result.samples_per_pixel > 0;
  if (is_whole) take(*outcome.picture);
  {
    const std::lock_guard lock(mutex_);
    // Parts of a pass that was cut short would make some regions darker.
    seconds_before_ += is_whole ? outcome.statistics.result.seconds : 0.0;
    current_.reset();
  }
  listener_.changed();
}

void LiveRender::take(const Picture& picture) {
  const double samples = samples_of(picture);
  auto newest = std::make_shared<const Picture>(picture);
  std::shared_ptr<const Picture> before;
  double samples_before = 0.0;
  {
    const std::lock_guard lock(mutex_);
    // The look of a preparation is worse than what there is.
    if (samples == 0.0 && before_ != nullptr) return;
    before = before_;
    samples_before = samples_before_;
  }
  auto shown = newest;
  if (before != nullptr) {
    shown = std::make_shared<const Picture>(add_epochs(*before, samples_before, *newest, samples));
  }
  const std::lock_guard lock(mutex_);
  shown_coarseness_ = coarseness_;
  newest_ = std::move(newest);
  shown_ = std::move(shown);
  samples_ = samples;
  if (!built_) built_ = loaded_->built(picture.resolution, options_.spec.filter);
  if (coarseness_ > 1) return;
  status_.resolution = picture.resolution;
  status_.crop = picture.crop;
}

// ---------------------------------------------------------------- what is known

LiveStatus LiveRender::status() const {
  const std::lock_guard lock(mutex_);
  LiveStatus status = status_;
  status.state = state_;
  status.stop_at = stop_at_;
  status.can_undo = !undo_.empty();
  status.can_redo = !redo_.empty();
  status.samples = samples_before_;
  status.seconds = seconds_before_;
  if (current_) {
    const RenderSnapshot snapshot = current_->snapshot();
    if (snapshot.renders()) {
      status.samples += snapshot.samples_done;
      if (snapshot.seconds > 0.0) {
        status.rays_per_second = static_cast<double>(snapshot.rays) / snapshot.seconds;
      }
    } else {
      status.done = snapshot.phase_done;
    }
    status.seconds += snapshot.seconds;
  }
  if (state_.camera) {
    status.camera = *state_.camera;
  } else {
    status.camera =
        pose_of(original_->description().camera, built_ ? built_->scene.bounds() : Box3());
  }
  return status;
}

LivePicture LiveRender::picture() const {
  const std::lock_guard lock(mutex_);
  return {shown_, status_.epoch, shown_coarseness_};
}

std::shared_ptr<const LoadedScene> LiveRender::loaded_scene() const {
  const std::lock_guard lock(mutex_);
  return loaded_;
}

std::shared_ptr<const BuiltScene> LiveRender::built_scene() const {
  const std::lock_guard lock(mutex_);
  return built_;
}

}  // namespace ajar::viewer
