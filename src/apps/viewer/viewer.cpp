#include "apps/viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "apps/viewer/access.h"
#include "apps/viewer/frame.h"
#include "apps/viewer/messages.h"
#include "core/error.h"
#include "session/output/denoise_file.h"
#include "session/output/write_picture.h"
#include "session/scenes/scene_file.h"

namespace ajar::viewer {

namespace {

using nlohmann::json;

/// Messages of which a slow page gets the newest alone.
enum Slot : int { kAll = 0, kState, kHistory, kPixel };

/// Seconds between messages about the state.
constexpr double kStateEvery = 0.25;
/// Seconds between pictures of the render, at least.
constexpr double kPictureEvery = 0.1;
/// Seconds that a page may take for a frame; else it gets a coarser one.
constexpr double kSlow = 0.3;
constexpr double kFast = 0.1;
constexpr int kCoarsest = 8;
constexpr std::size_t kSmallFrame = 128 << 10;

std::string text_of(const json& message) {
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

Viewer::Viewer(ViewerOptions options) : options_(std::move(options)), token_(make_token()) {
  if (options_.picture == nullptr) {
    live_ = std::make_unique<LiveRender>(LiveRender::Options{options_.scene, options_.spec},
                                         static_cast<LiveRender::Listener&>(*this));
  }
  server_ = std::make_unique<WebServer>(
      WebServerOptions{options_.host, options_.port, token_, viewer_files(),
                       [this](const std::string& line) { tell(true, line); }},
      static_cast<WebServer::Listener&>(*this));
  if (live_) denoised_ = std::make_unique<DenoisedView>([this] { changed(); });
  thread_ = std::thread([this] { run(); });
}

Viewer::~Viewer() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
  if (saving_.valid()) saving_.wait();
  denoised_.reset();
  server_.reset();
  live_.reset();
}

std::string Viewer::address() const {
  const bool is_ipv6 = options_.host.find(':') != std::string::npos;
  const std::string host = is_ipv6 ? "[" + options_.host + "]" : options_.host;
  return fmt::format("http://{}:{}/#{}", host, server_->port(), token_);
}

void Viewer::tell(bool is_warning, const std::string& text) const {
  if (options_.tell) options_.tell(is_warning, text);
}

std::string Viewer::save(const std::string& format, const DisplayOptions& display) {
  if (format != "exr" && format != "png") throw UsageError("format is exr or png");
  const auto shown_picture = shown().picture;
  if (shown_picture == nullptr) throw UsageError("there is no picture yet");
  Picture picture = *shown_picture;
  if (layer_named(picture, kDenoisedLayer) == nullptr && has_features(picture)) {
    denoise_picture(picture, find_denoiser("auto"), {});
  }
  const std::string stem = scene_stem(options_.scene);
  std::filesystem::path path;
  for (int number = 1;; ++number) {
    path = std::filesystem::path(options_.folder) / fmt::format("{}-{}.{}", stem, number, format);
    if (!std::filesystem::exists(path)) break;
  }
  write_picture(path.string(), picture, display);
  return std::filesystem::absolute(path).lexically_normal().string();
}

void Viewer::save_for(PageId page, const json& message) {
  const std::string format = message.value("format", std::string());
  const DisplayOptions display = parse_display(message);
  if (saving_.valid() && saving_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    throw UsageError("the last picture is still being saved");
  }
  saving_ = std::async(std::launch::async, [this, page, format, display] {
    json answer = {{"type", "saved"}};
    try {
      answer["path"] = save(format, display);
      tell(false, "saved " + answer["path"].get<std::string>());
    } catch (const std::exception& error) {
      answer["error"] = error.what();
    }
    server_->send_text(page, text_of(answer));
  });
}

// ---------------------------------------------------------------- pages

void Viewer::opened(PageId page) {
  {
    const std::lock_guard lock(mutex_);
    watchers_[page] = {};
    is_changed_ = true;
  }
  wake_.notify_all();
}

void Viewer::closed(PageId page) {
  const std::lock_guard lock(mutex_);
  watchers_.erase(page);
}

void Viewer::text(PageId page, std::string_view message) {
  try {
    answer(page, parse_message(message));
  } catch (const std::exception& error) {
    tell(true, std::string("a message of a page was dropped: ") + error.what());
    server_->send_text(page, text_of(note_message(true, error.what())));
  }
}

void Viewer::binary(PageId page, std::string_view message) {
  try {
    const std::shared_ptr<const Mask> mask = parse_mask(message);
    if (!live_) throw UsageError("a finished picture has no regions");
    const Vec2i size = live_->status().resolution;
    if (mask && mask->size != size) throw UsageError("the mask is not as large as the picture");
    live_->change([&](LiveState& state) { state.mask = mask; });
  } catch (const std::exception& error) {
    tell(true, std::string("a message of a page was dropped: ") + error.what());
    server_->send_text(page, text_of(note_message(true, error.what())));
  }
}

void Viewer::acknowledge(PageId page, std::uint32_t frame) {
  const std::lock_guard lock(mutex_);
  const auto found = watchers_.find(page);
  if (found == watchers_.end() || frame != found->second.sent) return;
  Watcher& watcher = found->second;
  if (watcher.drawn == frame) return;
  watcher.drawn = frame;
  const double seconds = clock_.seconds() - watcher.sent_at;
  // A page that is slow with a small frame is busy, not far away.
  if (seconds > kSlow && watcher.bytes > kSmallFrame)
    watcher.next_step = std::min(kCoarsest, 2 * watcher.step);
  if (seconds < kFast) watcher.next_step = std::max(1, watcher.step / 2);
  wake_.notify_all();
}

void Viewer::answer(PageId page, const json& message) {
  const std::string type = message["type"].get<std::string>();
  if (type == "ack") {
    const auto frame = message.find("frame");
    if (frame == message.end() || !frame->is_number_unsigned()) throw UsageError("ack: no frame");
    acknowledge(page, frame->get<std::uint32_t>());
  } else if (type == "layer") {
    const auto name = message.find("name");
    if (name == message.end() || !name->is_string()) throw UsageError("layer: no name");
    const std::lock_guard lock(mutex_);
    Watcher& watcher = watchers_[page];
    watcher.layer = name->get<std::string>();
    watcher.picture = nullptr;
    wake_.notify_all();
  } else if (type == "inspect") {
    const auto [picture, epoch, coarseness] = shown();
    if (picture == nullptr || coarseness > 1) return;
    server_->send_text(page, text_of(pixel_message(message, *picture, built_scene().get())),
                       kPixel);
  } else if (type == "save") {
    save_for(page, message);
  } else if (live_) {
    change(type, message);
  } else {
    throw UsageError("a finished picture does not change");
  }
}

void Viewer::change(const std::string& type, const json& message) {
  if (type == "pause") {
    live_->pause(true);
  } else if (type == "resume") {
    live_->pause(false);
  } else if (type == "restart") {
    live_->restart();
  } else if (type == "undo") {
    live_->undo();
  } else if (type == "redo") {
    live_->redo();
  } else if (type == "stop-at") {
    live_->stop_at(parse_stop_at(message));
  } else {
    const bool is_passing = message.value("moving", json()) == true;
    live_->change(
        [&](LiveState& state) {
          if (!apply_message(message, state)) throw UsageError("unknown type " + type);
        },
        is_passing);
  }
}

// ---------------------------------------------------------------- the render

bool Viewer::wants_picture() {
  const std::lock_guard lock(mutex_);
  if (clock_.seconds() < due_) return false;
  const bool wants = std::any_of(watchers_.begin(), watchers_.end(), [](const auto& watcher) {
    return watcher.second.drawn == watcher.second.sent;
  });
  if (wants) due_ = clock_.seconds() + kPictureEvery;
  return wants;
}

void Viewer::changed() {
  {
    const std::lock_guard lock(mutex_);
    is_changed_ = true;
  }
  wake_.notify_all();
}

void Viewer::note(bool is_warning, const std::string& text) {
  tell(is_warning, text);
  if (server_) send_to_all(note_message(is_warning, text), kAll);
}

void Viewer::send_to_all(const json& message, int slot) {
  const std::string text = text_of(message);
  std::vector<PageId> pages;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [page, watcher] : watchers_) pages.push_back(page);
  }
  for (const PageId page : pages) server_->send_text(page, text, slot);
}

void Viewer::run() {
  double state_due = 0.0;
  while (true) {
    bool is_changed = false;
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, std::chrono::milliseconds(50));
      if (ended_) return;
      is_changed = std::exchange(is_changed_, false);
      if (watchers_.empty()) continue;
    }
    if (is_changed || clock_.seconds() >= state_due) {
      send_state();
      state_due = clock_.seconds() + kStateEvery;
    }
    send_frames();
  }
}

LivePicture Viewer::shown() const {
  return live_ ? live_->picture() : LivePicture{options_.picture, 1, 1};
}

LivePicture Viewer::shown(const std::string& layer, const LivePicture& newest) const {
  if (layer != kDenoisedLayer || !denoised_) return newest;
  const auto latest = denoised_->latest();
  return latest == nullptr ? newest : LivePicture{latest, newest.epoch, newest.coarseness};
}

LiveStatus Viewer::status() const {
  if (live_) return live_->status();
  LiveStatus status;
  status.phase = LivePhase::Finished;
  status.epoch = 1;
  status.resolution = options_.picture->resolution;
  status.crop = options_.picture->crop;
  status.samples = metadata_number(*options_.picture, "ajar:samples_per_pixel").value_or(0.0);
  status.seconds = metadata_number(*options_.picture, "ajar:render_seconds").value_or(0.0);
  status.error = metadata_number(*options_.picture, "ajar:estimated_relative_error");
  const auto bound = options_.picture->metadata.find("ajar:estimated_error_is_lower_bound");
  status.error_is_lower_bound =
      bound == options_.picture->metadata.end() || bound->second != "false";
  return status;
}

json Viewer::welcome() const {
  if (!live_) return welcome_message(options_.scene, *options_.picture);
  return welcome_message(options_.scene, live_->loaded_scene()->description(),
                         *live_->built_scene());
}

void Viewer::send_state() {
  const bool is_ready = !live_ || live_->built_scene() != nullptr;
  const LoadedScene* const scene = live_ ? live_->loaded_scene().get() : nullptr;
  // An edit that was made elsewhere, or undone, changes what can be edited.
  const bool is_other = is_ready && std::exchange(welcomed_, scene) != scene;
  std::vector<PageId> fresh;
  {
    const std::lock_guard lock(mutex_);
    for (auto& [page, watcher] : watchers_) {
      if ((watcher.is_new || is_other) && is_ready) fresh.push_back(page);
      watcher.is_new = watcher.is_new && !is_ready;
    }
  }
  for (const PageId page : fresh) server_->send_text(page, text_of(welcome()));
  const LivePicture newest = shown();
  const LiveStatus now = status();
  send_to_all(state_message(now, newest.picture.get(), denoised_ != nullptr), kState);
  send_to_all(history_message(now), kHistory);
}

void Viewer::send_frames() {
  const LivePicture newest = shown();
  if (newest.picture == nullptr) return;
  if (denoised_ && std::exchange(denoised_epoch_, newest.epoch) != newest.epoch) {
    denoised_->forget();
  }
  struct Frame {
    PageId page;
    std::string layer;
    FrameHeader header;
    LivePicture shown;
  };
  std::vector<Frame> frames;
  {
    const std::lock_guard lock(mutex_);
    for (auto& [page, watcher] : watchers_) {
      if (denoised_ && watcher.layer == kDenoisedLayer) denoised_->want(newest.picture);
      if (watcher.drawn != watcher.sent) continue;
      const LivePicture now = shown(watcher.layer, newest);
      const bool is_same = watcher.picture == now.picture.get() && watcher.epoch == now.epoch;
      // When there is nothing newer the finest follows.
      if (is_same && watcher.step == 1) continue;
      watcher.step = is_same ? std::max(1, watcher.step / 2) : watcher.next_step;
      watcher.picture = now.picture.get();
      watcher.epoch = now.epoch;
      watcher.sent_at = clock_.seconds();
      frames.push_back(
          {page, watcher.layer, {++watcher.sent, now.epoch, watcher.step, now.coarseness}, now});
    }
  }
  for (const Frame& frame : frames) {
    const Picture& picture = *frame.shown.picture;
    const Picture::Layer* layer = layer_named(picture, frame.layer);
    if (layer == nullptr) layer = &picture.layers.front();
    std::string bytes = encode_frame(picture, *layer, frame.header);
    {
      const std::lock_guard lock(mutex_);
      const auto watcher = watchers_.find(frame.page);
      if (watcher != watchers_.end()) watcher->second.bytes = bytes.size();
    }
    server_->send_binary(frame.page, std::move(bytes));
  }
}

}  // namespace ajar::viewer
